/// The whole fluid step: predict, then project.
#include <gtest/gtest.h>

#include "flow/momentum.hpp"
#include "flow/projection.hpp"
#include "grid/stencils.hpp"
#include "unit/flow/prescribed_nodes.hpp"

namespace starling {
namespace {

using support::largest;

struct Fluid {
    Momentum momentum;
    Projection projection;
    NothingPrescribed nothing;
    VectorField rhs;

    Fluid(const Grid& g, const FluidParameters& p, const DriveParameters& drive = {})
        : momentum(g, p), projection(g, p, drive), nothing(g), rhs(g)
    {
    }
    /// Advances with a uniform body force along x.
    void step(FluidState& s, Real dt, Real force = 0, Real t = 0)
    {
        for (Location c : components) rhs[c].fill(c == Location::u ? force : 0);
        momentum.predict(s, rhs, nothing.view(), dt);
        projection.project(s, t, dt);
    }
};

/// Steady discrete flow between the y walls for a pressure gradient -G: the parabola of Poiseuille
/// plus h^2/4, which is what odd reflection at the walls solves exactly.
Real channel_flow(const Grid& g, Real Re, Real G, Index j)
{
    const Real y = g.y(Location::u, j) - g.origin().y, h = g.spacing().y;
    return Re * G / 2 * (y * (g.lengths().y - y) + h * h / 4);
}

/// Largest deviation of the velocity from channel flow, relative to its largest value.
Real channel_error(const Grid& g, const FluidState& s, Real Re, Real G)
{
    Real error = 0;
    for (Location c : components)
        error = std::max(error, largest(g.unknowns(c), [&](Index i, Index j, Index k) {
                             const bool axial = c == Location::u;
                             return s.u[c](i, j, k) - (axial ? channel_flow(g, Re, G, j) : 0);
                         }));
    return error / channel_flow(g, Re, G, g.ny() / 2);
}

struct Channel : testing::TestWithParam<Real> {
    Grid g{{8, 10, 6}, {0, -0.5, -0.5}, {2, 1, 1}};
    FluidParameters fluid{.reynolds = 1.5, .theta = GetParam()};
    FluidState s{g};
};

TEST_P(Channel, BodyForceDrivesTheDiscretePoiseuilleFlow)
{
    Fluid flow(g, fluid);
    for (int n = 0; n < 400; ++n) flow.step(s, 0.05, 2);
    EXPECT_LT(channel_error(g, s, fluid.reynolds, 2), 1e-13);
    EXPECT_LT(largest(g.unknowns(Location::cell), s.P.view()), 1e-12);
}

TEST_P(Channel, EndPressuresDriveTheDiscretePoiseuilleFlow)
{
    Fluid flow(g, fluid, {5, 1, 0});
    flow.projection.initialise_pressure(s);
    for (int n = 0; n < 400; ++n) flow.step(s, 0.05);
    EXPECT_LT(channel_error(g, s, fluid.reynolds, 2), 1e-13);
}

TEST_P(Channel, BodyForceAndPressureThatBalanceLeaveTheFluidAtRest)
{
    Fluid flow(g, fluid, {1, 5, 0});
    flow.projection.initialise_pressure(s);
    for (int n = 0; n < 10; ++n) flow.step(s, 0.05, 2);
    EXPECT_LT(largest(g.unknowns(Location::u), s.u[Location::u].view()), 1e-14);
}

/// Velocity at t = 1 of a channel whose end pressures oscillate, and whose drive begins softly.
VectorField oscillating_channel(const Grid& g, const FluidParameters& fluid, int steps)
{
    DriveParameters drive{4, 0, 0};
    drive.inlet_waveform = {.amplitude = 10, .period = 0.8, .cosine = {1}};
    drive.outlet_waveform = {.amplitude = 3, .period = 0.5, .sine = {1, 0.5}};
    drive.ramp = 0.6;
    Fluid flow(g, fluid, drive);
    FluidState s(g);
    flow.projection.initialise_pressure(s);
    const Real dt = 1. / steps;
    for (int n = 0; n < steps; ++n) flow.step(s, dt, 0, n * dt);
    return s.u;
}

TEST_P(Channel, FollowsChangingPressuresAtTheOrderOfDiffusion)
{
    const VectorField exact = oscillating_channel(g, fluid, 640);
    const auto error = [&](int steps) {
        const VectorField u = oscillating_channel(g, fluid, steps);
        return largest(g.unknowns(Location::u), [&](Index i, Index j, Index k) {
            return u[Location::u](i, j, k) - exact[Location::u](i, j, k);
        });
    };
    const Real coarse = error(40), fine = error(80);
    const Real order = std::log2(coarse / fine);
    EXPECT_NEAR(order, GetParam() == 1 ? 1 : 2, 0.15);
    const Real largest_speed = largest(g.unknowns(Location::u), exact[Location::u].view());
    EXPECT_LT(fine / largest_speed, GetParam() == 1 ? 0.1 : 0.02);
}

TEST_P(Channel, MeetsChangingPressuresOnTheEndFaces)
{
    DriveParameters drive;
    drive.inlet_waveform = {.amplitude = 2, .times = {0, 1}, .values = {0, 1}};
    Fluid flow(g, fluid, drive);
    flow.projection.initialise_pressure(s);
    const Real dt = 0.25;
    for (int n = 0; n < 2; ++n) flow.step(s, dt, 0, n * dt);
    const Real at = dt + fluid.theta * dt; // when the last step's pressures act
    support::visit({{0, 0, 0}, {1, g.ny(), g.nz()}}, [&](Index, Index j, Index k) {
        EXPECT_NEAR((s.P(-1, j, k) + s.P(0, j, k)) / 2, 2 * at, 1e-14);
    });
    EXPECT_LT(largest(g.unknowns(Location::cell), DivergenceAtCell(g, s.u)), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Theta, Channel, testing::Values(0.5, 1.),
                         [](const auto& theta) { return theta.param == 1 ? "one" : "half"; });

/// Five steps from a random state with random prescribed nodes.
FluidState five_steps(const Grid& g)
{
    support::Random random;
    const FluidParameters fluid{.reynolds = 3, .theta = 0.5};
    Fluid flow(g, fluid, {3, 1, 0});
    const support::RandomPrescribed prescribed(g, 0.05, random);
    FluidState s(g);
    s.u = support::random_velocity(g, random);
    flow.projection.initialise_pressure(s);
    for (int n = 0; n < 5; ++n) {
        for (Location c : components) support::randomise(g, c, flow.rhs[c], random);
        flow.momentum.predict(s, flow.rhs, prescribed.view(), 0.01);
        flow.projection.project(s, 0, 0.01);
    }
    return s;
}

/// Largest kinetic energy (per fluid volume of a cell) in 1000 steps of a stream U at Re = 10^4
/// with random disturbances, over that at the start.
Real growth_of_disturbances(Real U)
{
    const Grid g({12, 8, 8}, {0, -0.5, -0.5}, {1.5, 1, 1});
    Fluid flow(g, {.reynolds = 1e4, .theta = 0.5});
    FluidState s(g);
    support::Random random;
    s.u = support::random_velocity(g, random);
    const auto energy = [&] {
        Real sum = 0;
        for (Location c : components)
            support::visit(g.unknowns(c), [&](Index i, Index j, Index k) {
                sum += s.u[c](i, j, k) * s.u[c](i, j, k);
            });
        return sum;
    };
    support::visit(g.unknowns(Location::u), [&](Index i, Index j, Index k) {
        s.u[Location::u](i, j, k) = U + 0.3 * s.u[Location::u](i, j, k);
    });
    fill_velocity_halo(g, s.u);
    flow.projection.initialise_pressure(s);
    const Real start = energy();
    Real most = start;
    for (int n = 0; n < 1000; ++n) {
        flow.step(s, 0.004);
        most = std::max(most, energy());
    }
    return most / start;
}

TEST(FluidStep, DisturbancesLeaveAndEnterThroughTheEndsWithoutGrowing)
{
    for (Real U : {1., -1., 0.}) EXPECT_LT(growth_of_disturbances(U), 1.5) << U;
}

TEST(FluidStep, OneAndTwoThreadsGiveTheSameBits)
{
    const Grid g({13, 11, 15}, {0, -1.2, -1.1}, {3, 2.4, 2.2});
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const FluidState one = five_steps(g);
    omp_set_num_threads(2);
    const FluidState two = five_steps(g);
    omp_set_num_threads(before);
    EXPECT_TRUE(std::ranges::equal(one.P.values(), two.P.values()));
    for (Location c : components) {
        EXPECT_TRUE(std::ranges::equal(one.u[c].values(), two.u[c].values()));
        EXPECT_TRUE(std::ranges::equal(one.N_before[c].values(), two.N_before[c].values()));
    }
}

TEST(FluidStep, IsMirrorSymmetricInYAndZ)
{
    // v and w sit on low faces: the mirror of face k is face nz - k
    const Grid g({8, 9, 10}, {0, -1.2, -1.1}, {3, 2.4, 2.2});
    support::Random random;
    FluidState s(g);
    support::randomise(g, Location::u, s.u[Location::u], random);
    for (Location c : {Location::v, Location::w}) support::randomise(g, c, s.u[c], random);
    fill_velocity_halo(g, s.u);
    FluidState mirror(g);
    const Index ny = g.ny(), nz = g.nz();
    support::visit({{0, 0, 0}, {g.nx() + 1, ny, nz}}, [&](Index i, Index j, Index k) {
        mirror.u[Location::u](i, j, k) = s.u[Location::u](i, ny - 1 - j, nz - 1 - k);
        mirror.u[Location::v](i, j, k) = -s.u[Location::v](i, ny - j, nz - 1 - k);
        mirror.u[Location::w](i, j, k) = -s.u[Location::w](i, ny - 1 - j, (nz - k) % nz);
    });
    fill_velocity_halo(g, mirror.u);
    Fluid flow(g, {.reynolds = 5, .theta = 0.5});
    for (FluidState* state : {&s, &mirror})
        for (int n = 0; n < 3; ++n) flow.step(*state, 0.01, 1);
    EXPECT_LT(largest(g.unknowns(Location::u),
                      [&](Index i, Index j, Index k) {
                          return mirror.u[Location::u](i, j, k) -
                                 s.u[Location::u](i, ny - 1 - j, nz - 1 - k);
                      }),
              1e-13);
    EXPECT_LT(largest(g.unknowns(Location::v),
                      [&](Index i, Index j, Index k) {
                          return mirror.u[Location::v](i, j, k) +
                                 s.u[Location::v](i, ny - j, nz - 1 - k);
                      }),
              1e-13);
}

} // namespace
} // namespace starling
