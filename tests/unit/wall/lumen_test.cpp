#include "wall/lumen.hpp"

#include <gtest/gtest.h>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

struct Lumen : testing::Test {
    Tube tube = make_tube(support::short_tube(), 0.1);
    Index middle = (tube.clamp_in + tube.clamp_out) / 2;

    /// The smallest gap and the middle ring's self-crossing when the wall has the shape.
    std::pair<Real, bool> of(const support::Shape& shape, Real progress = 1) const
    {
        const Array<Vec3> x = support::positions(tube, shape, progress);
        return {smallest_gap(tube, x), crosses_itself(tube, x, middle)};
    }
};

TEST_F(Lumen, OfARoundTubeIsItsDiameter)
{
    EXPECT_NEAR(of(support::inflated(0)).first, 2, 1e-12);
    EXPECT_FALSE(of(support::inflated(0)).second);
}

TEST_F(Lumen, OfADumbbellIsItsNeck)
{
    for (Real neck : {0.3, 0.2, 0.05}) {
        const auto [gap, crosses] = of(support::dumbbell(neck));
        EXPECT_NEAR(gap, 2 * neck, 0.02);
        EXPECT_FALSE(crosses);
    }
}

TEST_F(Lumen, CrossesItselfOnceOppositeWallsHavePassedEachOther)
{
    EXPECT_FALSE(of(support::dumbbell(0.01)).second);
    EXPECT_TRUE(of(support::dumbbell(-0.05)).second);
    EXPECT_FALSE(of(support::lobed(3, 0.6)).second);
    EXPECT_FALSE(of(support::lobed(8, 0.2)).second);
}

TEST_F(Lumen, ModesOfALobedRingAreItsWave)
{
    const Array<Vec3> x = support::positions(tube, support::lobed(3, 0.2));
    const Real s = (tube.ring_x[static_cast<std::size_t>(middle)] - tube.x_clamp_in()) /
                   (tube.x_clamp_out() - tube.x_clamp_in());
    const RadiusModes modes = radius_modes(tube, x, middle);
    for (std::size_t n = 0; n < RadiusModes::count; ++n) {
        const Real expected = n == 0 ? 1 : n == 3 ? 0.2 * std::pow(std::sin(pi * s), 2) : 0;
        EXPECT_NEAR(modes.amplitude[n], expected, 1e-12) << n;
    }
    EXPECT_EQ(modes.lobes(), 3);
}

TEST_F(Lumen, HasNoLobesWhereItIsRoundAndWhereItIsAsideOnly)
{
    Array<Vec3> x = WallState(tube).x;
    EXPECT_EQ(radius_modes(tube, x, middle).lobes(), 0);
    for (Vec3& p : x) p = {p.x, 0.9 * p.y + 0.05, 0.9 * p.z};
    EXPECT_EQ(radius_modes(tube, x, middle).lobes(), 0);
    EXPECT_NEAR(radius_modes(tube, x, middle).amplitude[1], 0.05, 1e-3);
}

TEST(RadiusModes, OfModesThatARingCannotResolveAreZero)
{
    const Tube tube = make_tube(support::short_tube(), 0.8); // 8 vertices
    const Array<Vec3> x = support::positions(tube, support::lobed(2, 0.2));
    const RadiusModes modes = radius_modes(tube, x, (tube.clamp_in + tube.clamp_out) / 2);
    EXPECT_EQ(modes.lobes(), 2);
    for (std::size_t n = 5; n < RadiusModes::count; ++n) EXPECT_EQ(modes.amplitude[n], 0);
}

} // namespace
} // namespace starling
