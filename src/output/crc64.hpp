#pragma once
/// CRC-64 (the variant of the xz format), to recognise damaged files.
#include <cstdint>
#include <span>

namespace starling {

/// Takes bytes in pieces; `value()` is the checksum of all of them so far.
class Crc64 {
public:
    void add(std::span<const char> bytes);
    std::uint64_t value() const { return ~state_; }

private:
    std::uint64_t state_ = ~std::uint64_t{0};
};

} // namespace starling
