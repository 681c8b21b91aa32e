#pragma once
/// Numbers as text that a page can hold: little-endian bytes in base64.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace starling::report {

std::string base64(std::span<const std::uint8_t> bytes);

/// 32-bit floats; NaN stays NaN.
std::string packed(std::span<const Real> values);
/// 32-bit unsigned integers.
std::string packed(const std::vector<std::array<std::int32_t, 3>>& triangles);

/// Smallest and largest of the numbers that are finite; 0 and 0 where there is none.
struct Range {
    Real low = 0, high = 0;
};
Range range_of(const std::vector<std::vector<Real>>& frames);

/// 16-bit steps of 1/65534 of the range; 65535 where there is no number.
std::string packed16(std::span<const Real> values, const Range& range);

/// Bytes of base64 for so many bytes.
constexpr std::size_t base64_size(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

/// At most `most` of `count` things, evenly spread: the first and the last are among them, of one
/// only the last.
std::vector<std::size_t> spread(std::size_t count, std::size_t most);

} // namespace starling::report
