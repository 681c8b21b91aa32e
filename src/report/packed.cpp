#include "report/packed.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace starling::report {

static_assert(std::endian::native == std::endian::little, "numbers are packed as they lie");

namespace {

constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint16_t no_number = 65535;

template <class T>
std::string base64_of(const std::vector<T>& values)
{
    std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
    if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return base64(bytes);
}

} // namespace

std::string base64(std::span<const std::uint8_t> bytes)
{
    std::string text;
    text.reserve(base64_size(bytes.size()));
    for (std::size_t n = 0; n < bytes.size(); n += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - n);
        std::uint32_t word = 0;
        for (std::size_t b = 0; b < 3; ++b) word = word << 8 | (b < count ? bytes[n + b] : 0u);
        for (std::size_t d = 0; d < 4; ++d)
            text += d <= count ? digits[word >> (18 - 6 * d) & 63] : '=';
    }
    return text;
}

std::string packed(std::span<const Real> values)
{
    return base64_of(std::vector<float>(values.begin(), values.end()));
}

std::string packed(const std::vector<std::array<std::int32_t, 3>>& triangles)
{
    return base64_of(triangles);
}

Range range_of(const std::vector<std::vector<Real>>& frames)
{
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    Range range{infinity, -infinity};
    for (const auto& values : frames)
        for (const Real v : values)
            if (std::isfinite(v)) range = {std::min(range.low, v), std::max(range.high, v)};
    return range.low <= range.high ? range : Range{};
}

std::string packed16(std::span<const Real> values, const Range& range)
{
    const Real width = range.high > range.low ? range.high - range.low : 1;
    std::vector<std::uint16_t> steps;
    steps.reserve(values.size());
    for (const Real v : values)
        steps.push_back(std::isfinite(v) ? static_cast<std::uint16_t>(
                                               std::lround((v - range.low) / width * 65534))
                                         : no_number);
    return base64_of(steps);
}

std::vector<std::size_t> spread(std::size_t count, std::size_t most)
{
    const std::size_t kept = std::min(count, most);
    if (kept == 1) return {count - 1};
    std::vector<std::size_t> chosen;
    for (std::size_t n = 0; n < kept; ++n) chosen.push_back(n * (count - 1) / (kept - 1));
    return chosen;
}

} // namespace starling::report
