#include "wall/contact.hpp"

#include <gtest/gtest.h>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

constexpr ContactParameters parameters{.pressure = 5, .range = 0.4};

struct Repulsion : testing::Test {
    Tube tube = make_tube(support::short_tube(), 0.1);

    Array<Vec3> force(const Array<Vec3>& x, const ContactParameters& p = parameters) const
    {
        Geometry geometry(tube.mesh);
        geometry.update(x);
        Array<Vec3> f(x.size());
        Contact(tube, p).add(x, geometry, f);
        return f;
    }
    static Real largest(const Array<Vec3>& f)
    {
        Real most = 0;
        for (const Vec3& a : f) most = std::max(most, norm(a));
        return most;
    }
};

TEST_F(Repulsion, VanishesBeyondItsRange)
{
    EXPECT_EQ(largest(force(WallState(tube).x)), 0);
    EXPECT_EQ(largest(force(support::positions(tube, support::dumbbell(0.21)))), 0);
    EXPECT_GT(largest(force(support::positions(tube, support::dumbbell(0.15)))), 0);
}

TEST_F(Repulsion, IsOffWithoutAPressure)
{
    const Array<Vec3> x = support::positions(tube, support::dumbbell(0.05));
    EXPECT_EQ(largest(force(x, {.pressure = 0, .range = 0.4})), 0);
}

TEST_F(Repulsion, PushesBothWallsApartWithForcesThatCancel)
{
    const Array<Vec3> x = support::positions(tube, support::dumbbell(0.1)), f = force(x);
    Vec3 sum;
    Real upper = 0;
    for (Index v = 0; v < x.size(); ++v) {
        sum += f[v];
        if (norm(f[v]) == 0) continue;
        EXPECT_GT(f[v].z * x[v].z, 0); // the neck is narrow along z
        upper += std::abs(f[v].z) / 2;
    }
    EXPECT_GT(upper, 0);
    EXPECT_LT(std::abs(sum.z), 0.01 * upper);
    EXPECT_LT(std::abs(sum.y), 0.01 * upper);
}

TEST_F(Repulsion, IsThePressureOfTheGapOnTheAreaOfTheVertex)
{
    const Array<Vec3> x = support::positions(tube, support::dumbbell(0.1)), f = force(x);
    Geometry geometry(tube.mesh);
    geometry.update(x);
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) {
        const VertexIndex ring = v / tube.ring_size * tube.ring_size;
        const Real width = lumen_width(&x[ring], tube.ring_size, v - ring);
        const Real p = width < 0.4 ? 5 * std::pow(1 - width / 0.4, 2) : 0;
        EXPECT_LT(norm(f[v] - p * geometry.vertex_area()[v]), 1e-14);
    }
}

} // namespace
} // namespace starling
