#include "grid/boundary.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "unit/grid/random_fields.hpp"

namespace starling {
namespace {

using support::visit;

constexpr Real unset = std::numeric_limits<Real>::quiet_NaN();

class Boundary : public testing::Test {
protected:
    /// Random unknowns of one component; everything else set by the halo alone.
    ScalarField velocity(Location c)
    {
        ScalarField f(g);
        f.fill(unset);
        support::randomise(g, c, f, random);
        fill_velocity_halo(g, c, f);
        return f;
    }

    Grid g{{4, 5, 6}, {0, 0, 0}, {1, 1, 1}};
    Index nx = g.nx(), ny = g.ny(), nz = g.nz();
    support::Random random;
};

TEST_F(Boundary, EveryHaloValueIsSet)
{
    for (Location c : components) {
        const ScalarField f = velocity(c);
        const Index planes = nx + (c == Location::u ? 1 : 0);
        visit({{-1, -1, -1}, {planes + 1, ny + 1, nz + 1}}, [&](Index i, Index j, Index k) {
            EXPECT_FALSE(std::isnan(f(i, j, k))) << axis(c) << ": " << i << ' ' << j << ' ' << k;
        });
    }
}

TEST_F(Boundary, UnknownsStayAsTheyAre)
{
    for (Location c : components) {
        ScalarField f(g);
        support::randomise(g, c, f, random);
        const ScalarField before = f;
        fill_velocity_halo(g, c, f);
        visit(g.unknowns(c),
              [&](Index i, Index j, Index k) { EXPECT_EQ(f(i, j, k), before(i, j, k)); });
    }
}

TEST_F(Boundary, VelocityIsPeriodicInZ)
{
    for (Location c : components) {
        const ScalarField f = velocity(c);
        visit({{-1, -1, 0}, {nx + 1, ny + 1, 1}}, [&](Index i, Index j, Index) {
            EXPECT_EQ(f(i, j, -1), f(i, j, nz - 1));
            EXPECT_EQ(f(i, j, nz), f(i, j, 0));
        });
    }
}

TEST_F(Boundary, VelocityIsOddAboutTheYWalls)
{
    for (Location c : {Location::u, Location::w}) {
        const ScalarField f = velocity(c);
        visit({{-1, 0, -1}, {nx + 1, 1, nz + 1}}, [&](Index i, Index, Index k) {
            EXPECT_EQ(f(i, -1, k), -f(i, 0, k));
            EXPECT_EQ(f(i, ny, k), -f(i, ny - 1, k));
        });
    }
    const ScalarField v = velocity(Location::v);
    visit({{-1, 0, -1}, {nx + 1, 1, nz + 1}}, [&](Index i, Index, Index k) {
        EXPECT_EQ(v(i, 0, k), 0);
        EXPECT_EQ(v(i, ny, k), 0);
        EXPECT_EQ(v(i, -1, k), -v(i, 1, k));
    });
}

TEST_F(Boundary, VelocityIsEvenAboutTheEndFaces)
{
    const ScalarField u = velocity(Location::u);
    visit({{0, -1, -1}, {1, ny + 1, nz + 1}}, [&](Index, Index j, Index k) {
        EXPECT_EQ(u(-1, j, k), u(1, j, k));
        EXPECT_EQ(u(nx + 1, j, k), u(nx - 1, j, k));
    });
    for (Location c : {Location::v, Location::w}) {
        const ScalarField f = velocity(c);
        visit({{0, -1, -1}, {1, ny + 1, nz + 1}}, [&](Index, Index j, Index k) {
            EXPECT_EQ(f(-1, j, k), f(0, j, k));
            EXPECT_EQ(f(nx, j, k), f(nx - 1, j, k));
        });
    }
}

TEST_F(Boundary, AllComponentsAtOnceEqualOneByOne)
{
    VectorField u(g);
    for (Location c : components) support::randomise(g, c, u[c], random);
    VectorField one_by_one = u;
    fill_velocity_halo(g, u);
    for (Location c : components) {
        fill_velocity_halo(g, c, one_by_one[c]);
        EXPECT_TRUE(std::ranges::equal(u[c].values(), one_by_one[c].values()));
    }
}

TEST_F(Boundary, IncrementIsEvenInYPeriodicInZAndOddAboutTheEndFaces)
{
    ScalarField phi(g);
    phi.fill(unset);
    support::randomise(g, Location::cell, phi, random);
    fill_increment_halo(g, phi);
    visit({{-1, 0, -1}, {nx + 1, 1, nz + 1}}, [&](Index i, Index, Index k) {
        EXPECT_EQ(phi(i, -1, k), phi(i, 0, k));
        EXPECT_EQ(phi(i, ny, k), phi(i, ny - 1, k));
    });
    visit({{-1, -1, 0}, {nx + 1, ny + 1, 1}}, [&](Index i, Index j, Index) {
        EXPECT_EQ(phi(i, j, -1), phi(i, j, nz - 1));
        EXPECT_EQ(phi(i, j, nz), phi(i, j, 0));
    });
    visit({{0, -1, -1}, {1, ny + 1, nz + 1}}, [&](Index, Index j, Index k) {
        EXPECT_EQ(phi(-1, j, k), -phi(0, j, k));
        EXPECT_EQ(phi(nx, j, k), -phi(nx - 1, j, k));
    });
}

} // namespace
} // namespace starling
