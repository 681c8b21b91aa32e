#include "wall/along_x.hpp"

#include <gtest/gtest.h>

#include "wall/elastic_force.hpp"
#include "wall/wall_state.hpp"

namespace starling {
namespace {

const AlongX stenosis{.shape = AlongX::Shape::bump, .position = 5, .length = 4, .change = -0.3};
const AlongX stiffer{.shape = AlongX::Shape::step, .position = 5, .length = 2, .change = 1};

TEST(AlongX, IsOneByDefault)
{
    EXPECT_TRUE(AlongX{}.uniform());
    EXPECT_EQ(AlongX{}(3), 1);
    EXPECT_EQ(AlongX{}.highest(), 1);
}

TEST(AlongX, BumpsAndStepsHaveTheirShapes)
{
    EXPECT_NEAR(stenosis(5), 0.7, 1e-15);
    EXPECT_NEAR(stenosis(6), 0.85, 1e-15) << "half of the change at a quarter of the length";
    EXPECT_EQ(stenosis(3), 1);
    EXPECT_EQ(stenosis(7.1), 1);
    EXPECT_EQ(stenosis.lowest(), 0.7);
    EXPECT_EQ(stenosis.highest(), 1);
    EXPECT_EQ(stiffer(4), 1);
    EXPECT_NEAR(stiffer(5), 1.5, 1e-15);
    EXPECT_EQ(stiffer(6), 2);
    EXPECT_EQ(stiffer.highest(), 2);
}

TEST(AlongX, ATableIsJoinedByStraightLinesAndHeldBeyondItsEnds)
{
    AlongX table;
    table.shape = AlongX::Shape::table;
    table.x = {1, 2, 4};
    table.values = {1, 0.5, 2};
    EXPECT_EQ(table(-7), 1);
    EXPECT_EQ(table(1.5), 0.75);
    EXPECT_EQ(table(2), 0.5);
    EXPECT_EQ(table(3), 1.25);
    EXPECT_EQ(table(9), 2);
    EXPECT_EQ(table.lowest(), 0.5);
    EXPECT_EQ(table.highest(), 2);
}

Tube tube_with(const AlongX& radius)
{
    TubeParameters p;
    p.length = 10;
    p.rigid_inlet = p.rigid_outlet = 1;
    p.rest_radius = radius;
    return make_tube(p, 0.3);
}

TEST(Tube, HasTheRestRadius)
{
    const Tube tube = tube_with(stenosis);
    for (Index ring = 0; ring < tube.rings(); ++ring)
        for (VertexIndex v = tube.first(ring); v < tube.first(ring + 1); ++v) {
            const Vec3& X = tube.X[static_cast<std::size_t>(v)];
            EXPECT_NEAR(std::hypot(X.y, X.z), stenosis(X.x), 1e-14);
        }
}

TEST(ElasticForce, VanishesInAnUndeformedTubeOfAnyRestRadius)
{
    const Tube tube = tube_with(stenosis);
    const WallState rest(tube);
    Array<Vec3> f(rest.x.size());
    ElasticForce(tube, NeoHookean{3}, stiffer).compute(rest.x, f);
    for (const Vec3& force : f) EXPECT_LT(norm(force), 1e-12);
}

TEST(ElasticForce, GrowsWithTheStiffnessOfItsElements)
{
    const Tube tube = tube_with({});
    WallState wall(tube);
    for (Vec3& x : wall.x) x = {x.x, 1.1 * x.y, 1.1 * x.z};
    Array<Vec3> uniform(wall.x.size()), varying(wall.x.size()), by_energy(wall.x.size());
    ElasticForce plain(tube, NeoHookean{3}), stepped(tube, NeoHookean{3}, stiffer);
    plain.compute(wall.x, uniform);
    stepped.compute(wall.x, varying);
    stepped.compute_from_energy(wall.x, by_energy);
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) {
        const Real x = wall.x[v].x;
        EXPECT_LT(norm(varying[v] - by_energy[v]), 1e-12);
        if (x < 3.7) {
            EXPECT_LT(norm(varying[v] - uniform[v]), 1e-14);
        } else if (x > 6.3) {
            EXPECT_LT(norm(varying[v] - 2.0 * uniform[v]), 1e-14);
        }
    }
    EXPECT_GT(stepped.energy(wall.x), 1.3 * plain.energy(wall.x));
    EXPECT_LT(stepped.energy(wall.x), 1.7 * plain.energy(wall.x));
}

} // namespace
} // namespace starling
