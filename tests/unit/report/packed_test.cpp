#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string_view>

#include "report/packed.hpp"

namespace starling::report {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

std::string base64_of(std::string_view text)
{
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(Packed, AgreesWithTheExamplesOfRfc4648)
{
    EXPECT_EQ(base64_of(""), "");
    EXPECT_EQ(base64_of("f"), "Zg==");
    EXPECT_EQ(base64_of("fo"), "Zm8=");
    EXPECT_EQ(base64_of("foo"), "Zm9v");
    EXPECT_EQ(base64_of("foob"), "Zm9vYg==");
    EXPECT_EQ(base64_of("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
    for (std::size_t n : {0, 1, 2, 3, 4, 5})
        EXPECT_EQ(base64_size(n), base64_of(std::string(n, 'x')).size());
}

TEST(Packed, HoldsFloatsAsTheyLie)
{
    const std::vector<Real> values = {1}; // 00 00 80 3f
    EXPECT_EQ(packed(values), "AACAPw==");
}

TEST(Packed, DividesTheRangeIntoSteps)
{
    const std::vector<Real> values = {-1, 3, 1, nan}; // 0, 65534, 32767, 65535
    EXPECT_EQ(packed16(values, {-1, 3}),
              base64_of(std::string_view("\0\0\xfe\xff\xff\x7f\xff\xff", 8)));
    EXPECT_EQ(packed16(std::vector<Real>{2, 2}, {2, 2}),
              base64_of(std::string_view("\0\0\0\0", 4)));
}

TEST(Packed, RangesLeaveOutWhatIsNotFinite)
{
    const Range range = range_of({{nan, 2}, {-3, std::numeric_limits<Real>::infinity()}});
    EXPECT_EQ(range.low, -3);
    EXPECT_EQ(range.high, 2);
    EXPECT_EQ(range_of({{nan}}).high, 0);
}

TEST(Packed, SpreadsWhatIsKeptFromTheFirstToTheLast)
{
    using Chosen = std::vector<std::size_t>;
    EXPECT_EQ(spread(5, 9), (Chosen{0, 1, 2, 3, 4}));
    EXPECT_EQ(spread(101, 3), (Chosen{0, 50, 100}));
    EXPECT_EQ(spread(7, 1), (Chosen{6}));
    EXPECT_EQ(spread(7, 0), Chosen{});
    EXPECT_EQ(spread(0, 3), Chosen{});
}

} // namespace
} // namespace starling::report
