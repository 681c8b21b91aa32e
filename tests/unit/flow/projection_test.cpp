#include "flow/projection.hpp"

#include <gtest/gtest.h>

#include "grid/stencils.hpp"
#include "unit/grid/random_fields.hpp"

namespace starling {
namespace {

using support::largest;

class ProjectionStep : public testing::Test {
protected:
    Grid g{{12, 10, 9}, {0, -1.6, -1.35}, {3, 3.2, 2.7}};
    FluidParameters fluid{.reynolds = 2, .theta = 0.5};
    Box cells = g.unknowns(Location::cell);
    support::Random random;
    Real dt = 0.01;
};

TEST_F(ProjectionStep, LeavesADivergenceAtRoundOff)
{
    const Real smallest_spacing = g.spacing().x;
    FluidState s(g);
    s.u = support::random_velocity(g, random);
    Projection(g, fluid, {1, -1, 0.5}).project(s, 0, dt);
    EXPECT_LT(largest(cells, DivergenceAtCell(g, s.u)), 1e-13 / smallest_spacing);
    EXPECT_GT(largest(g.unknowns(Location::u), s.u[Location::u].view()), 0.1);
}

TEST_F(ProjectionStep, DoesNotChangeASolenoidalFlow)
{
    FluidState s(g);
    s.u = support::random_solenoidal_velocity(g, 1, random);
    const VectorField before = s.u;
    Projection(g, fluid, {}).project(s, 0, dt);
    for (Location c : components)
        EXPECT_LT(
            largest(g.unknowns(c), [&](Index i, Index j,
                                       Index k) { return s.u[c](i, j, k) - before[c](i, j, k); }),
            1e-13);
    EXPECT_LT(largest(cells, s.P.view()), 1e-12 / dt);
}

TEST_F(ProjectionStep, RemovesAGradientAndAddsItToThePressure)
{
    // u_hat = dt grad phi: after the step u = 0 and P = phi - theta dt/Re Lap phi
    ScalarField phi(g);
    support::randomise(g, Location::cell, phi, random);
    fill_increment_halo(g, phi);
    FluidState s(g);
    const Vec3 h = g.spacing();
    for (Location c : components)
        support::visit(g.unknowns(c), [&](Index i, Index j, Index k) {
            const Real* p = &phi(i, j, k);
            const Real spacing = c == Location::u ? h.x : c == Location::v ? h.y : h.z;
            s.u[c](i, j, k) = dt * (p[0] - p[-phi.view().stride(axis(c))]) / spacing;
        });
    fill_velocity_halo(g, s.u);
    Projection(g, fluid, {}).project(s, 0, dt);
    for (Location c : components) EXPECT_LT(largest(g.unknowns(c), s.u[c].view()), 1e-14);
    const Laplacian laplacian(h);
    const View<const Real> f = std::as_const(phi).view();
    EXPECT_LT(largest(cells,
                      [&](Index i, Index j, Index k) {
                          return s.P(i, j, k) -
                                 (phi(i, j, k) - fluid.theta * dt / fluid.reynolds *
                                                     laplacian(f, f.offset(i, j, k)));
                      }),
              1e-12);
}

TEST_F(ProjectionStep, IsAProjection)
{
    FluidState s(g);
    s.u = support::random_velocity(g, random);
    Projection projection(g, fluid, {});
    projection.project(s, 0, dt);
    const VectorField once = s.u;
    projection.project(s, 0, dt);
    for (Location c : components)
        EXPECT_LT(
            largest(g.unknowns(c),
                    [&](Index i, Index j, Index k) { return s.u[c](i, j, k) - once[c](i, j, k); }),
            1e-13);
}

TEST_F(ProjectionStep, LeavesValidHalos)
{
    FluidState s(g);
    s.u = support::random_velocity(g, random);
    Projection(g, fluid, {}).project(s, 0, dt);
    VectorField filled = s.u;
    fill_velocity_halo(g, filled);
    ScalarField P = s.P;
    fill_increment_halo(g, P); // no drive: the pressure is zero on the end faces
    for (Location c : components)
        EXPECT_TRUE(std::ranges::equal(filled[c].values(), s.u[c].values())) << axis(c);
    EXPECT_TRUE(std::ranges::equal(P.values(), s.P.values()));
}

/// Largest |Lap P| with the halos of the end pressures.
Real laplacian_of_pressure(const Grid& g, const FluidState& s)
{
    const Laplacian laplacian(g.spacing());
    const View<const Real> P = s.P.view();
    return largest(g.unknowns(Location::cell),
                   [&](Index i, Index j, Index k) { return laplacian(P, P.offset(i, j, k)); });
}

TEST_F(ProjectionStep, PressureAtRestIsHarmonicAndMeetsTheEndPressures)
{
    const DriveParameters drive{5, 2, -1};
    FluidState s(g);
    Projection(g, fluid, drive).initialise_pressure(s);
    EXPECT_LT(laplacian_of_pressure(g, s), 1e-11);
    support::visit({{0, 0, 0}, {1, g.ny(), g.nz()}}, [&](Index, Index j, Index k) {
        const Vec3 r = g.position(Location::cell, 0, j, k);
        const bool inside = r.y * r.y + r.z * r.z < 1;
        EXPECT_NEAR((s.P(-1, j, k) + s.P(0, j, k)) / 2, inside ? 5 : -1, 1e-14);
        EXPECT_NEAR((s.P(g.nx() - 1, j, k) + s.P(g.nx(), j, k)) / 2, inside ? 2 : -1, 1e-14);
    });
}

TEST_F(ProjectionStep, PressureAtRestIsUniformBetweenEqualPressures)
{
    FluidState s(g);
    Projection(g, fluid, {3, 3, 3}).initialise_pressure(s);
    EXPECT_LT(largest(cells, [&](Index i, Index j, Index k) { return s.P(i, j, k) - 3; }), 1e-13);
}

TEST_F(ProjectionStep, PressureAtRestIsLinearWhereAllOfTheBoxIsInside)
{
    const Grid narrow({12, 6, 8}, {0, -0.5, -0.5}, {3, 1, 1});
    FluidState s(narrow);
    Projection(narrow, fluid, {7, 1, 100}).initialise_pressure(s);
    EXPECT_LT(largest(narrow.unknowns(Location::cell),
                      [&](Index i, Index j, Index k) {
                          return s.P(i, j, k) - (7 - 2 * narrow.x(Location::cell, i));
                      }),
              1e-13);
}

} // namespace
} // namespace starling
