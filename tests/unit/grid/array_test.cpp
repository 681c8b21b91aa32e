#include "core/array.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

namespace starling {
namespace {

std::uintptr_t address(const void* p) { return reinterpret_cast<std::uintptr_t>(p); }

TEST(Array, StartsAtZeroAndOnACacheLine)
{
    for (Index size : {1, 7, 64, 1000}) {
        const Array<Real> a(size);
        EXPECT_EQ(a.size(), size);
        EXPECT_EQ(address(a.data()) % 64, 0u);
        for (Real value : a) EXPECT_EQ(value, 0);
    }
}

TEST(Array, LargeOnesBeginOnACacheLineEachElsewhereInItsPage)
{
    std::set<std::uintptr_t> places;
    std::vector<Array<Real>> arrays;
    for (int n = 0; n < 12; ++n) {
        const Array<Real>& a = arrays.emplace_back(Index{1} << 20); // 8 MiB
        EXPECT_EQ(address(a.data()) % 64, 0u);
        EXPECT_EQ(a[a.size() - 1], 0);
        places.insert(address(a.data()) % 4096);
    }
    EXPECT_EQ(places.size(), arrays.size());
}

TEST(Array, CopiesOwnTheirValues)
{
    Array<Real> a(3);
    a.fill(2);
    Array<Real> b(a), c;
    c = a;
    a.fill(5);
    for (Index n = 0; n < 3; ++n) {
        EXPECT_EQ(b[n], 2);
        EXPECT_EQ(c[n], 2);
    }
}

TEST(Array, MovesKeepTheMemory)
{
    Array<Real> a(3);
    const Real* data = a.data();
    Array<Real> b(std::move(a)), c;
    EXPECT_EQ(b.data(), data);
    c = std::move(b);
    EXPECT_EQ(c.data(), data);
    EXPECT_EQ(c.size(), 3);
}

TEST(Array, MayBeEmpty)
{
    const Array<Real> none, zero(0);
    EXPECT_EQ(none.size(), 0);
    EXPECT_EQ(none.begin(), none.end());
    EXPECT_EQ(zero.begin(), zero.end());
    const Array<Real> copy(none);
    EXPECT_EQ(copy.size(), 0);
}

} // namespace
} // namespace starling
