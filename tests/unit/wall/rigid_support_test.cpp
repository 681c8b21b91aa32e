#include "wall/rigid_support.hpp"

#include <gtest/gtest.h>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

constexpr Real dt = 0.02, spacing = 0.2, memory = 63. / 64;
constexpr Real settling = 0.5 / (5.78 * dt);

struct Support : testing::Test {
    Tube tube = make_tube(support::short_tube(), 0.15);
    WallState wall{tube};
    Geometry geometry{tube.mesh};
    RigidSupport support{tube, true, 0.5, spacing};

    Support() { geometry.update(wall.x); }
    bool rigid(Index v) const { return v < tube.moving_begin() || v >= tube.moving_end(); }
    /// The fluid flows outwards as fast as `speed` everywhere.
    void flow_outwards(Real speed)
    {
        for (Index v = 0; v < wall.x.size(); ++v)
            wall.velocity[v] = speed * Vec3{0, wall.x[v].y, wall.x[v].z};
    }
};

TEST_F(Support, AnswersFlowThroughTheWallWithPressureAgainstIt)
{
    constexpr Real speed = 0.01;
    const Real gain = 4 / std::sqrt(0.5 * dt),
               learning = gain / (gain + spacing / (2 * dt)) / (1 + settling * settling / 8) / 16;
    const Real pressure = gain * speed; // of each step
    Real steps = 0, rate = 0;           // what they make together
    for (int step = 1; step <= 3; ++step) {
        steps += 1 + rate;
        rate = memory * rate + learning;
        flow_outwards(speed);
        support.hold(geometry, wall, dt);
        for (Index v = 0; v < wall.x.size(); ++v) {
            const Vec3 outwards = {0, wall.x[v].y, wall.x[v].z};
            const Real force = rigid(v) ? steps * pressure * norm(geometry.vertex_area()[v]) : 0;
            // H sees that the direction turns from vertex to vertex
            EXPECT_LE(norm(wall.support[v] + force * outwards), 1e-3 * force) << v;
            EXPECT_EQ(wall.velocity[v] == Vec3{}, rigid(v));
        }
    }
}

/// Fluid that passes in proportion to the load that is not held.
TEST_F(Support, FollowsALoadThatChangesSteadilyWithLessOfALag)
{
    const Real gain = 4 / std::sqrt(0.5 * dt),
               learning = gain / (gain + spacing / (2 * dt)) / (1 + settling * settling / 8) / 16;
    const Real change = 0.1; // of the pressure in a step
    const Index v = 3 * tube.ring_size;
    ASSERT_TRUE(rigid(v));
    Real largest = 0, last = 0;
    for (int step = 1; step <= 300; ++step) {
        const Real held = norm(wall.support[v]) / norm(geometry.vertex_area()[v]);
        last = 0.6 * (step * change - held) / gain;
        largest = std::max(largest, last);
        flow_outwards(last);
        support.hold(geometry, wall, dt);
    }
    EXPECT_GT(largest, 0.6 * change / gain);
    EXPECT_NEAR(last, change / gain / (1 + learning / (1 - memory)), 1e-2 * largest);
}

TEST_F(Support, ForgetsWavesThatTheFluidCannotSee)
{
    const auto largest = [&] {
        Real most = 0;
        for (Index v = 0; v < wall.x.size(); ++v)
            most = std::max(most, norm(wall.support[v]) / norm(geometry.vertex_area()[v]));
        return most;
    };
    for (Index v = 0; v < wall.x.size(); ++v) {
        const Real sign = v % tube.ring_size % 2 == 0 ? 1 : -1;
        if (rigid(v))
            wall.support[v] =
                sign * norm(geometry.vertex_area()[v]) * Vec3{0, wall.x[v].y, wall.x[v].z};
    }
    EXPECT_NEAR(largest(), 1, 1e-12);
    for (int step = 0; step < 10; ++step) support.hold(geometry, wall, dt);
    EXPECT_LT(largest(), 1e-2);
}

TEST_F(Support, ItsForceReplacesThatOfTheRigidVertices)
{
    Array<Vec3> f(wall.x.size());
    f.fill({1, 2, 3});
    flow_outwards(1);
    support.hold(geometry, wall, dt);
    support.apply(geometry, wall, dt, f);
    for (Index v = 0; v < f.size(); ++v) {
        // and what damps: half of what stops the fluid of a spacing
        const Vec3 damping = -spacing / (2 * dt) * norm(geometry.vertex_area()[v]) *
                             Vec3{0, wall.x[v].y, wall.x[v].z};
        const Vec3 expected = rigid(v) ? wall.support[v] + damping : Vec3{1, 2, 3};
        EXPECT_LT(norm(f[v] - expected), 1e-14);
    }
}

TEST_F(Support, IsNothingWhereGhostNodesHoldTheRigidParts)
{
    auto rigid_tube = support::short_tube();
    rigid_tube.rigid = true;
    const Tube stiff = make_tube(rigid_tube, 0.15);
    RigidSupport none[] = {RigidSupport(tube, false, 0.5, spacing),
                           RigidSupport(stiff, true, 0.5, spacing)};
    const Tube* tubes[] = {&tube, &stiff};
    for (int n : {0, 1}) {
        WallState w(*tubes[n]);
        Geometry g(tubes[n]->mesh);
        g.update(w.x);
        w.velocity.fill({0, 1, 0});
        none[n].hold(g, w, dt);
        Array<Vec3> f(w.x.size());
        f.fill({1, 2, 3});
        none[n].apply(g, w, dt, f);
        for (Index v = 0; v < f.size(); ++v) {
            EXPECT_EQ(f[v], (Vec3{1, 2, 3}));
            EXPECT_EQ(w.support[v], Vec3{});
        }
    }
}

} // namespace
} // namespace starling
