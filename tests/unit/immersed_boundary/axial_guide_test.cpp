#include "immersed_boundary/axial_guide.hpp"

#include <gtest/gtest.h>

#include "unit/grid/random_fields.hpp"
#include "unit/immersed_boundary/boxed_tube.hpp"

namespace starling {
namespace {

struct Guide : testing::Test {
    support::BoxedTube stage{0.3};
    support::Random random;
    Array<Vec3> f, u;

    Guide()
    {
        stage.place(support::positions(stage.tube, support::random_smooth(2, 0.5)));
        f = random_vectors();
        u = random_vectors();
    }
    Array<Vec3> random_vectors()
    {
        Array<Vec3> a(stage.wall.x.size());
        for (Vec3& b : a) b = {random(), random(), random()};
        return a;
    }
    Array<Vec3> constrained_force(CouplingScheme scheme) const
    {
        Array<Vec3> g = f;
        AxialGuide(scheme).constrain_force(stage.tube, stage.geometry, g);
        return g;
    }
    Array<Vec3> constrained_velocity(CouplingScheme scheme) const
    {
        Array<Vec3> U = u;
        AxialGuide(scheme).constrain_velocity(stage.tube, stage.geometry, U);
        return U;
    }
    template <class F>
    void for_moving(F check) const
    {
        for (VertexIndex v = stage.tube.moving_begin(); v < stage.tube.moving_end(); ++v) check(v);
    }
    const Vec3& area(VertexIndex v) const { return stage.geometry.vertex_area()[v]; }
};

TEST_F(Guide, ReactionMakesTheAxialForceThatOfANormalForce)
{
    for (CouplingScheme scheme : {CouplingScheme::reaction, CouplingScheme::conserving}) {
        const Array<Vec3> g = constrained_force(scheme);
        for_moving([&](VertexIndex v) {
            EXPECT_EQ(g[v].y, f[v].y);
            EXPECT_EQ(g[v].z, f[v].z);
            // less its part along the wall, across x, the force is along the normal
            const Vec3 a = area(v);
            const Vec3 along = (1 / std::hypot(a.y, a.z)) * Vec3{0, -a.z, a.y};
            EXPECT_LT(norm(cross(g[v] - dot(g[v], along) * along, a)), 1e-14);
        });
    }
}

TEST_F(Guide, PrintedSchemeHasNoAxialForce)
{
    const Array<Vec3> g = constrained_force(CouplingScheme::printed);
    for_moving([&](VertexIndex v) { EXPECT_EQ(g[v], (Vec3{0, f[v].y, f[v].z})); });
}

TEST_F(Guide, WallNeverMovesAxially)
{
    for (CouplingScheme scheme :
         {CouplingScheme::printed, CouplingScheme::reaction, CouplingScheme::conserving}) {
        const Array<Vec3> U = constrained_velocity(scheme);
        for_moving([&](VertexIndex v) { EXPECT_EQ(U[v].x, 0); });
    }
}

TEST_F(Guide, WithoutFeedBackTheWallFollowsTheFluidAcrossTheAxis)
{
    for (CouplingScheme scheme : {CouplingScheme::printed, CouplingScheme::reaction}) {
        const Array<Vec3> U = constrained_velocity(scheme);
        for_moving([&](VertexIndex v) { EXPECT_EQ(U[v], (Vec3{0, u[v].y, u[v].z})); });
    }
}

TEST_F(Guide, ConservingSchemeSweepsTheVolumeTheFluidSweeps)
{
    const Array<Vec3> U = constrained_velocity(CouplingScheme::conserving);
    for_moving([&](VertexIndex v) { EXPECT_NEAR(dot(area(v), U[v]), dot(area(v), u[v]), 1e-15); });
}

TEST_F(Guide, ForceAndVelocityOfTheConservingSchemeAreAdjoint)
{
    // what the elastic force does on the wall is what the constrained force does on the fluid
    const Array<Vec3> g = constrained_force(CouplingScheme::conserving);
    const Array<Vec3> U = constrained_velocity(CouplingScheme::conserving);
    for_moving([&](VertexIndex v) {
        EXPECT_NEAR(f[v].y * U[v].y + f[v].z * U[v].z, dot(g[v], u[v]), 1e-14);
    });
}

TEST_F(Guide, LeavesRigidPartsWithoutSupportAlone)
{
    const Array<Vec3> g = constrained_force(CouplingScheme::reaction);
    const Array<Vec3> U = constrained_velocity(CouplingScheme::reaction);
    for (VertexIndex v = 0; v < stage.tube.moving_begin(); ++v) {
        EXPECT_EQ(g[v], f[v]);
        EXPECT_EQ(U[v], u[v]);
    }
}

} // namespace
} // namespace starling
