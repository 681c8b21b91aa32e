#include "config/scaling.hpp"

#include <gtest/gtest.h>

#include "config/quantities.hpp"

namespace starling {
namespace {

TEST(Scaling, EveryFactorHasTheDimensionOfItsQuantity)
{
    const Scaling s{true, 2, 3, 5};
    for (int n = 0; n <= static_cast<int>(Quantity::viscosity); ++n) {
        const auto q = static_cast<Quantity>(n);
        const Dimension d = dimension(q);
        // kg = rho L^3, s = L/U
        const double expected = std::pow(5., d.mass) *
                                std::pow(2., 3 * d.mass + d.length + d.time) *
                                std::pow(3., -d.time);
        EXPECT_DOUBLE_EQ(s.factor(q), expected) << s.unit(q);
        EXPECT_EQ(Scaling{}.factor(q), 1);
    }
}

TEST(Scaling, SiUnitsAreOne)
{
    for (int n = 1; n <= static_cast<int>(Quantity::viscosity); ++n) {
        const auto q = static_cast<Quantity>(n);
        const Measure m = parse_measure("1 " + Scaling{true, 1, 1, 1}.unit(q));
        EXPECT_DOUBLE_EQ(static_cast<double>(m.value), 1);
        EXPECT_EQ(m.dimension, dimension(q));
    }
}

} // namespace
} // namespace starling
