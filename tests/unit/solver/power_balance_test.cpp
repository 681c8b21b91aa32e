#include "solver/power_balance.hpp"

#include <gtest/gtest.h>

#include "unit/grid/random_fields.hpp"
#include "unit/solver/coupled.hpp"

namespace starling {
namespace {

using support::Coupled;
using support::CoupledParameters;

Real largest_of(const Powers& p) { return std::max({std::abs(p.inlet), std::abs(p.wall)}); }

/// Kinetic energy summed directly; the end faces carry half a cell each.
Real kinetic_energy(const Grid& g, const VectorField& u)
{
    Real sum = 0;
    for (Location c : components)
        support::visit(g.unknowns(c), [&](Index i, Index j, Index k) {
            const bool half = c == Location::u && (i == 0 || i == g.nx());
            sum += (half ? 0.5 : 1) * u[c](i, j, k) * u[c](i, j, k) / 2;
        });
    return sum * g.cell_volume();
}

TEST(PowerBalance, StateKnowsItsKineticEnergies)
{
    Coupled c;
    ASSERT_TRUE(c.run(3));
    const Real before = kinetic_energy(c.g, c.s.fluid.u);
    ASSERT_TRUE(c.run(1));
    const Real now = kinetic_energy(c.g, c.s.fluid.u);
    EXPECT_NEAR(c.s.fluid.kinetic_energy_before, before, 1e-13 * before);
    EXPECT_NEAR(c.s.fluid.kinetic_energy, now, 1e-13 * now);
    PowerBalance power(c.g, c.op, Coupled::fluid, {});
    EXPECT_NEAR(power.measure(c.s).kinetic, (now - before) / c.s.fluid.dt_before,
                1e-10 * now / c.s.fluid.dt_before);
}

TEST(PowerBalance, IsZeroBeforeTheFirstStep)
{
    Coupled c;
    const Powers p = PowerBalance(c.g, c.op, Coupled::fluid, {}).measure(c.s);
    for (Real zero : {p.inlet, p.outlet, p.exterior, p.dissipation, p.kinetic, p.wall})
        EXPECT_EQ(zero, 0);
}

TEST(PowerBalance, RigidTubeDissipatesWhatThePressureDoes)
{
    CoupledParameters p{.spacing = 0.2};
    p.tube.rigid = true;
    Coupled c(p);
    ASSERT_TRUE(c.run(400));
    const Powers power = PowerBalance(c.g, c.op, Coupled::fluid, {}).measure(c.s);
    const Real Q = pi / 2 * p.pressure_ratio; // Poiseuille
    EXPECT_NEAR(power.dissipation, Q * p.pressure_ratio * 4 * p.tube.length / Coupled::reynolds,
                0.03 * power.dissipation);
    EXPECT_LT(std::abs(power.residual()), 0.01 * power.inlet); // 0.2 %
}

/// Of the neo-Hookean wall that inflates, in every step.
TEST(PowerBalance, WorkOnTheWallIsItsChangeOfEnergy)
{
    Coupled c(CoupledParameters{.scheme = CouplingScheme::conserving});
    PowerBalance power(c.g, c.op, Coupled::fluid, {});
    const auto energy = [&] { return c.op.elastic.energy(c.s.wall.x); };
    Real work = 0;
    ASSERT_TRUE(c.run(1));
    const Real start = energy();
    c.s.dt /= 20; // that of the force before the step, not of the mean
    for (int n = 0; n < 160; ++n) {
        ASSERT_TRUE(c.run(1));
        work += c.s.dt * power.measure(c.s).wall;
    }
    EXPECT_GT(work, 0);
    EXPECT_NEAR(work, energy() - start, 0.01 * work);
}

TEST(PowerBalance, WorkOnAViscousWallInTissueIsItsChangeOfEnergyAndItsDissipation)
{
    Coupled c(CoupledParameters{.scheme = CouplingScheme::conserving,
                                .tissue = {.stiffness = 300, .damping = 20},
                                .mu_s = 5});
    PowerBalance power(c.g, c.op, Coupled::fluid, {});
    const auto of_wall = [&] { return c.op.elastic.energy(c.s.wall.x); };
    const auto of_springs = [&] { return c.op.tissue.energy(c.s.wall.x); };
    c.s.dt /= 20;
    ASSERT_TRUE(c.run(1));
    const Real wall = of_wall(), springs = of_springs();
    Real work = 0, viscosity = 0, dampers = 0;
    for (int n = 0; n < 160; ++n) {
        const Array<Vec3> x = c.s.wall.x;
        ASSERT_TRUE(c.run(1));
        work += c.s.dt * power.measure(c.s).wall;
        viscosity += c.s.dt * c.op.viscosity.dissipation(x, c.s.wall.velocity);
        dampers += c.s.dt * c.op.tissue.dissipation(c.s.wall.velocity);
    }
    for (Real part : {of_springs() - springs, viscosity, dampers}) EXPECT_GT(part, 0.03 * work);
    EXPECT_NEAR(work, of_wall() - wall + of_springs() - springs + viscosity + dampers, 0.01 * work);
}

TEST(PowerBalance, ClosesWhileATubeInflates)
{
    Coupled c(CoupledParameters{.scheme = CouplingScheme::conserving, .spacing = 0.2});
    PowerBalance power(c.g, c.op, Coupled::fluid, {});
    State trial = c.s;
    ASSERT_TRUE(load_rigid_parts(c.s, trial, c.op, c.w, c.s.dt));
    ASSERT_TRUE(c.run(10));
    for (int n = 0; n < 60; ++n) {
        ASSERT_TRUE(c.run(1));
        const Powers p = power.measure(c.s);
        EXPECT_LT(std::abs(p.residual()), 0.06 * largest_of(p)) << n;
    }
}

/// What enters from a reservoir brings P u - u^3/2 + u^3/2: all of it is work of the reservoir.
TEST(PowerBalance, CountsKineticEnergyAtTheEnds)
{
    Coupled c;
    ASSERT_TRUE(c.run(1));
    ScalarField& u = c.s.fluid.u[Location::u];
    for (Real& value : u.values()) value = 2;
    for (Location l : {Location::v, Location::w}) c.s.fluid.u[l].fill(0);
    const Real P = c.s.fluid.ends.inside[0];
    const Powers of_pressure = PowerBalance(c.g, c.op, Coupled::fluid, {}).measure(c.s);
    EXPECT_NEAR(of_pressure.inlet, pi * 2 * (P + 2), 0.02 * pi * 2 * (P + 2));
    EXPECT_NEAR(of_pressure.outlet, pi * 2 * 2, 0.02 * pi * 4);
    const DriveParameters reservoir{.total_pressure = true};
    const Powers of_reservoir = PowerBalance(c.g, c.op, Coupled::fluid, reservoir).measure(c.s);
    EXPECT_NEAR(of_pressure.inlet - of_reservoir.inlet, pi * 4, 0.02 * pi * 4);
    EXPECT_EQ(of_reservoir.outlet, of_pressure.outlet); // leaves as a jet
}

} // namespace
} // namespace starling
