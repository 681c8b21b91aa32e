#include "grid/grid.hpp"

#include <gtest/gtest.h>

#include "grid/field.hpp"

namespace starling {
namespace {

Grid small_grid() { return Grid({4, 6, 5}, {0, -3, -2}, {2, 6, 4}); }

Index size(const Box& b)
{
    return (b.end[0] - b.begin[0]) * (b.end[1] - b.begin[1]) * (b.end[2] - b.begin[2]);
}

TEST(Grid, SpacingIsLengthOverCount)
{
    const Grid g = small_grid();
    EXPECT_EQ(g.spacing(), (Vec3{0.5, 1, 0.8}));
    EXPECT_NEAR(g.delta(), std::cbrt(0.4), 1e-15);
    EXPECT_NEAR(g.cell_volume(), 0.4, 1e-15);
    EXPECT_EQ(g.cell_count(), 120);
}

TEST(Grid, ComponentsSitOnTheLowFacesOfTheirCell)
{
    const Grid g = small_grid();
    const Vec3 cell = g.position(Location::cell, 1, 2, 3), h = g.spacing();
    EXPECT_NEAR(norm(cell - Vec3{0.75, -0.5, 0.8}), 0, 1e-15);
    EXPECT_NEAR(norm(g.position(Location::u, 1, 2, 3) - (cell - Vec3{h.x / 2, 0, 0})), 0, 1e-15);
    EXPECT_NEAR(norm(g.position(Location::v, 1, 2, 3) - (cell - Vec3{0, h.y / 2, 0})), 0, 1e-15);
    EXPECT_NEAR(norm(g.position(Location::w, 1, 2, 3) - (cell - Vec3{0, 0, h.z / 2})), 0, 1e-15);
}

TEST(Grid, EndFacesAndWallsAreFaces)
{
    const Grid g = small_grid();
    EXPECT_EQ(g.x(Location::u, 0), 0);
    EXPECT_EQ(g.x(Location::u, g.nx()), 2);
    EXPECT_EQ(g.y(Location::v, 0), -3);
    EXPECT_EQ(g.y(Location::v, g.ny()), 3);
}

TEST(Grid, UnknownsIncludeTheEndFacesButNotTheWalls)
{
    const Grid g = small_grid();
    EXPECT_EQ(size(g.unknowns(Location::u)), 5 * 6 * 5);
    EXPECT_EQ(size(g.unknowns(Location::v)), 4 * 5 * 5);
    EXPECT_EQ(size(g.unknowns(Location::w)), 4 * 6 * 5);
    EXPECT_EQ(size(g.unknowns(Location::cell)), 4 * 6 * 5);
    EXPECT_EQ(g.unknowns(Location::v).begin[1], 1);
}

TEST(NearestSmooth, HasNoPrimeFactorButTwoThreeFive)
{
    for (Index n = 1; n < 700; ++n) {
        Index m = nearest_smooth(static_cast<Real>(n));
        for (Index p : {2, 3, 5})
            while (m % p == 0) m /= p;
        EXPECT_EQ(m, 1) << n;
    }
}

TEST(NearestSmooth, IsTheNearest)
{
    EXPECT_EQ(nearest_smooth(47), 48);
    EXPECT_EQ(nearest_smooth(236), 240);
    EXPECT_EQ(nearest_smooth(237), 240);
    EXPECT_EQ(nearest_smooth(22.4), 24);
    EXPECT_EQ(nearest_smooth(22), 20); // the smaller of two equally near
    EXPECT_EQ(nearest_smooth(60), 60);
    EXPECT_EQ(nearest_smooth(0.3), 2);
}

TEST(NearestSmooth, IsEvenIfAsked)
{
    EXPECT_EQ(nearest_smooth(45), 45);
    EXPECT_EQ(nearest_smooth(44.9, true), 48);
    EXPECT_EQ(nearest_smooth(26, true), 24);
    for (Index n = 1; n < 300; ++n) EXPECT_EQ(nearest_smooth(static_cast<Real>(n), true) % 2, 0);
}

TEST(MakeGrid, RoundsCountsAndCentresTheBoxOnTheAxis)
{
    GridParameters p;
    p.width_y = 4.7;
    p.width_z = 3.1;
    p.spacing = 0.1;
    const Grid g = make_grid(p, 4 * pi);
    EXPECT_EQ(g.cells(), (std::array<Index, 3>{126, 48, 30}));
    EXPECT_NEAR(g.lengths().x, 4 * pi, 1e-14);
    EXPECT_NEAR(g.y(Location::v, 0) + g.y(Location::v, g.ny()), 0, 1e-14);
    EXPECT_NEAR(g.z(Location::w, 0) + g.z(Location::w, g.nz()), 0, 1e-14);
}

TEST(MakeGrid, OffsetMovesTheAxisRelativeToTheBox)
{
    GridParameters p;
    p.tube_offset_y = 0.25;
    p.tube_offset_z = -0.5;
    const Grid g = make_grid(p, 2);
    // the box centre seen from the axis
    EXPECT_NEAR((g.y(Location::v, 0) + g.y(Location::v, g.ny())) / 2, -0.25, 1e-14);
    EXPECT_NEAR((g.z(Location::w, 0) + g.z(Location::w, g.nz())) / 2, 0.5, 1e-14);
}

TEST(MakeGrid, TakesExactCounts)
{
    GridParameters p;
    p.cells = std::array<Index, 3>{7, 11, 13};
    EXPECT_EQ(make_grid(p, 2).cells(), *p.cells);
}

TEST(Field, HoldsOneLayerOfHaloAndRunsAlongZ)
{
    const Grid g = small_grid();
    ScalarField f(g);
    const View<Real> view = f.view();
    EXPECT_EQ(&view(-1, -1, -1), f.values().data());
    EXPECT_EQ(&view(g.nx() + 1, g.ny(), g.nz()), f.values().end() - 1);
    EXPECT_EQ(&view(1, 2, 4) - &view(1, 2, 3), view.stride(2));
    EXPECT_EQ(&view(1, 3, 3) - &view(1, 2, 3), view.stride(1));
    EXPECT_EQ(&view(2, 2, 3) - &view(1, 2, 3), view.stride(0));
    EXPECT_EQ(&view(1, 2, 3), view.data + view.offset(1, 2, 3));
}

} // namespace
} // namespace starling
