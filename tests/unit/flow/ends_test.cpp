/// Ends whose pressure answers to the flow, and ends that are reservoirs.
#include "flow/ends.hpp"

#include <gtest/gtest.h>

#include "flow/projection.hpp"
#include "grid/boundary.hpp"
#include "grid/stencils.hpp"
#include "unit/grid/random_fields.hpp"

namespace starling {
namespace {

using support::largest;

class EndsStep : public testing::Test {
protected:
    Grid g{{12, 10, 9}, {0, -1.6, -1.35}, {3, 3.2, 2.7}};
    FluidParameters fluid{.reynolds = 2, .theta = 0.5};
    support::Random random;
    Real dt = 0.01;

    FluidState random_state()
    {
        FluidState s(g);
        s.u = support::random_velocity(g, random);
        return s;
    }
    /// Flow through the faces with r < R_0.
    Real flow(const FluidState& s, Index face) const
    {
        const Array<Real> share = inside_share(g);
        Real Q = 0;
        for (Index j = 0; j < g.ny(); ++j)
            for (Index k = 0; k < g.nz(); ++k)
                Q += share[j * g.nz() + k] * s.u[Location::u](face, j, k);
        return Q * g.spacing().y * g.spacing().z;
    }
};

TEST_F(EndsStep, InletHasTheFlowRateAskedFor)
{
    DriveParameters drive{.pressure_outlet = 0.3, .pressure_external = 0.1};
    drive.inlet_flow = {true, 0.7, {.amplitude = 0.5, .period = 1, .sine = {1}}};
    Projection projection(g, fluid, drive);
    FluidState s = random_state();
    projection.initialise_pressure(s);
    EXPECT_EQ(s.ends.inside[0], 0.3) << "starts from rest";
    for (int step = 0; step < 3; ++step) {
        const Real t = 0.2 + step * dt;
        projection.project(s, t, dt);
        EXPECT_NEAR(flow(s, 0), 0.7 + 0.5 * std::sin(2 * pi * (t + dt)), 1e-12);
        EXPECT_LT(largest(g.unknowns(Location::cell), DivergenceAtCell(g, s.u)), 1e-12);
        s.u = support::random_velocity(g, random);
    }
}

TEST_F(EndsStep, AnswerIsThePressureThatDrivesTheSameFlow)
{
    DriveParameters drive{.pressure_external = 0.1};
    drive.inlet_flow = {true, 0.7, {}};
    drive.windkessel = {.R1 = 0.5, .R2 = 2, .C = 0.1, .distal = 0.2};
    Projection answering(g, fluid, drive);
    FluidState s = random_state();
    answering.initialise_pressure(s);
    FluidState given = s;
    answering.project(s, 0, dt);
    ASSERT_GT(std::abs(s.ends.inside[0]), 1);

    Projection(g, fluid, {s.ends.inside[0], s.ends.inside[1], 0.1}).project(given, 0, dt);
    for (Location c : components)
        EXPECT_LT(
            largest(g.unknowns(c), [&](Index i, Index j,
                                       Index k) { return s.u[c](i, j, k) - given.u[c](i, j, k); }),
            1e-12);
    EXPECT_LT(largest(g.unknowns(Location::cell),
                      [&](Index i, Index j, Index k) { return s.P(i, j, k) - given.P(i, j, k); }),
              1e-10);
}

TEST_F(EndsStep, WindkesselObeysItsEquations)
{
    DriveParameters drive{.pressure_inlet = 3, .pressure_outlet = 1.5};
    drive.windkessel = {.R1 = 0.5, .R2 = 2, .C = 0.1, .distal = 0.2};
    const Windkessel& w = drive.windkessel;
    Projection projection(g, fluid, drive);
    FluidState s = random_state();
    projection.initialise_pressure(s);
    EXPECT_EQ(s.ends.stored, 1.5);
    for (int step = 0; step < 3; ++step) {
        const Real before = s.ends.stored;
        projection.project(s, step * dt, dt);
        const Real Q = flow(s, g.nx());
        EXPECT_NEAR(s.ends.inside[1], s.ends.stored + w.R1 * Q, 1e-12);
        EXPECT_NEAR(w.C * (s.ends.stored - before) / dt, Q - (s.ends.stored - w.distal) / w.R2,
                    1e-11);
        s.u = support::random_velocity(g, random);
    }
}

TEST_F(EndsStep, WindkesselWithoutComplianceIsAResistance)
{
    DriveParameters drive{.pressure_inlet = 3};
    drive.windkessel = {.R1 = 0.5, .R2 = 2, .C = 0, .distal = 0.2};
    Projection projection(g, fluid, drive);
    FluidState s = random_state();
    projection.initialise_pressure(s);
    projection.project(s, 0, dt);
    EXPECT_NEAR(s.ends.inside[1], 0.2 + 2.5 * flow(s, g.nx()), 1e-12);
}

TEST_F(EndsStep, RampActsOnTheFlowRateAndOnTheDistalPressure)
{
    DriveParameters drive{.ramp = 4};
    drive.inlet_flow = {true, 0.7, {}};
    drive.windkessel = {.R1 = 0.5, .R2 = 2, .C = 0, .distal = 0.2};
    Projection projection(g, fluid, drive);
    FluidState s = random_state();
    projection.initialise_pressure(s);
    projection.project(s, 2 - dt, dt); // half way: sin^2 = 1/2
    EXPECT_NEAR(flow(s, 0), 0.35, 1e-12);
    EXPECT_NEAR(s.ends.inside[1], 0.1 + 2.5 * flow(s, g.nx()), 1e-12);
}

TEST_F(EndsStep, ReservoirGivesTheDynamicPressureToWhatEnters)
{
    DriveParameters drive{3, 1, 0.5};
    drive.total_pressure = true;
    Ends ends(g, drive);
    EndState s(g);
    ScalarField u(g);
    support::randomise(g, Location::u, u, random);
    ends.initialise(s);
    EXPECT_TRUE(ends.prescribe(s, u, 0));
    const Array<Real> share = inside_share(g);
    for (Index j = 0; j < g.ny(); ++j)
        for (Index k = 0; k < g.nz(); ++k) {
            const Index n = j * g.nz() + k;
            const Real in = std::max(u(0, j, k), Real{0});
            const Real back = std::min(u(g.nx(), j, k), Real{0});
            EXPECT_EQ(s.pressure[0][n], share[n] == 1 ? 3 - in * in / 2 : 0.5);
            EXPECT_EQ(s.pressure[1][n], share[n] == 1 ? 1 - back * back / 2 : 0.5);
        }
    EXPECT_FALSE(ends.prescribe(s, u, 0)) << "the same flow changes nothing";
}

} // namespace
} // namespace starling
