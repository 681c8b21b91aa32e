#include "wall/tissue.hpp"

#include <gtest/gtest.h>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

constexpr TissueParameters parameters{.stiffness = 3, .damping = 0.7};

struct AroundTheTube : testing::Test {
    Tube tube = make_tube(support::short_tube(), 0.1);
    Array<Vec3> x = support::positions(tube, support::random_smooth(3, 0.3)), U{x.size()};

    AroundTheTube()
    {
        for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v)
            U[v] = {0, std::sin(0.1 * v), std::cos(0.3 * v)};
    }
    Array<Vec3> force(const TissueParameters& p) const
    {
        Array<Vec3> f(x.size());
        Tissue(tube, p).add(x, U, f);
        return f;
    }
};

TEST_F(AroundTheTube, PullsUniformInflationBackByItsStiffnessPerUndeformedArea)
{
    x = support::positions(tube, support::inflated(0));
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) x[v] *= 1.25;
    const Array<Vec3> f = force({.stiffness = 3});
    const Index ring = (tube.clamp_in + tube.clamp_out) / 2;
    const auto r = static_cast<std::size_t>(ring);
    Real radial = 0;
    for (VertexIndex v = tube.first(ring); v < tube.first(ring + 1); ++v)
        radial += f[v].y * tube.X[static_cast<std::size_t>(v)].y +
                  f[v].z * tube.X[static_cast<std::size_t>(v)].z;
    const Real area = 2 * pi * (tube.ring_x[r + 1] - tube.ring_x[r]);
    EXPECT_NEAR(radial, -3 * 0.25 * area, 2e-3 * area); // of the facets
}

TEST_F(AroundTheTube, ForceIsMinusTheGradientOfTheEnergy)
{
    const Tissue tissue(tube, {.stiffness = 3});
    const Array<Vec3> f = force({.stiffness = 3});
    const Real h = 1e-3;
    for (VertexIndex v : {tube.moving_begin(), tube.moving_begin() + 77, tube.moving_end() - 1}) {
        Array<Vec3> up = x, down = x;
        up[v].y += h;
        down[v].y -= h;
        EXPECT_NEAR(f[v].y, -(tissue.energy(up) - tissue.energy(down)) / (2 * h), 1e-9);
    }
}

TEST_F(AroundTheTube, PowerOfTheForcesIsThatOfTheSpringsAndOfTheDampers)
{
    const Tissue tissue(tube, parameters);
    const Array<Vec3> f = force(parameters), spring = force({.stiffness = parameters.stiffness});
    Real power = 0, of_springs = 0;
    for (Index v = 0; v < f.size(); ++v) {
        power += dot(f[v], U[v]);
        of_springs += dot(spring[v], U[v]);
    }
    EXPECT_GT(tissue.dissipation(U), 0);
    EXPECT_NEAR(power, of_springs - tissue.dissipation(U), 1e-12 * tissue.dissipation(U));
}

TEST_F(AroundTheTube, ActsOnTheDeformingPartAlone)
{
    for (Vec3& p : x) p *= 1.1;
    for (Vec3& u : U) u = {1, 1, 1};
    const Array<Vec3> f = force(parameters);
    for (VertexIndex v = 0; v < tube.mesh.vertex_count(); ++v)
        EXPECT_EQ(norm(f[v]) > 0, v >= tube.moving_begin() && v < tube.moving_end()) << v;
}

TEST_F(AroundTheTube, IsNothingWithoutStiffnessAndDampingOrInARigidTube)
{
    for (const Vec3& f : force({})) EXPECT_EQ(norm(f), 0);
    EXPECT_EQ(Tissue(tube, {}).energy(x), 0);
    const Tube rigid = make_tube({.length = 2, .rigid = true}, 0.3);
    Array<Vec3> f(static_cast<Index>(rigid.X.size())), up = WallState(rigid).x;
    for (Vec3& p : up) p *= 1.1;
    Tissue(rigid, parameters).add(up, up, f);
    for (const Vec3& a : f) EXPECT_EQ(norm(a), 0);
}

} // namespace
} // namespace starling
