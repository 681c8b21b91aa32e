#include "output/crc64.hpp"

#include <array>
#include <cstring>

namespace starling {

namespace {

constexpr std::uint64_t polynomial = 0xC96C5795D7870F42; ///< ECMA-182, reflected

using Table = std::array<std::array<std::uint64_t, 256>, 8>;

/// table[n][b]: byte b followed by n zero bytes, so that eight bytes are looked up at once.
constexpr Table make_table()
{
    Table table{};
    for (std::size_t b = 0; b < 256; ++b) {
        std::uint64_t r = b;
        for (int bit = 0; bit < 8; ++bit) r = (r & 1) != 0 ? (r >> 1) ^ polynomial : r >> 1;
        table[0][b] = r;
    }
    for (std::size_t n = 1; n < 8; ++n)
        for (std::size_t b = 0; b < 256; ++b)
            table[n][b] = (table[n - 1][b] >> 8) ^ table[0][table[n - 1][b] & 255];
    return table;
}

constexpr Table table = make_table();

} // namespace

void Crc64::add(std::span<const char> bytes)
{
    const char *p = bytes.data(), *end = p + bytes.size();
    for (; end - p >= 8; p += 8) { // little-endian, as all supported machines are
        std::uint64_t word = 0;
        std::memcpy(&word, p, 8);
        word ^= state_;
        state_ = 0;
        for (std::size_t n = 0; n < 8; ++n) state_ ^= table[7 - n][(word >> (8 * n)) & 255];
    }
    for (; p != end; ++p)
        state_ = (state_ >> 8) ^ table[0][(state_ ^ static_cast<unsigned char>(*p)) & 255];
}

} // namespace starling
