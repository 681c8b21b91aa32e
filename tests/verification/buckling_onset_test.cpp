/// The load at which the simulated tube buckles, against linear theory.
#include <gtest/gtest.h>

#include <algorithm>

#include "config/read_case.hpp"
#include "config/shipped_cases.hpp"
#include "simulation/simulation.hpp"
#include "theory/buckling_report.hpp"

namespace starling {
namespace {

/// A short tube that linear theory sees buckle into three lobes, at `load` of its critical drive.
Case near_onset(Real load)
{
    Case c;
    c.fluid.reynolds = 0.1;
    c.tube = {.length = 2 * pi, .rigid_inlet = 0.6, .rigid_outlet = 0.6};
    c.material.eps = 0.005;
    c.material.bending = 1e-3;
    c.perturbation = {.amplitude = 1e-3, .mode = 3};
    c.grid.spacing = 0.2;
    c.drive.pressure_outlet = -c.baseline_pressure_drop();
    const auto theory = buckling_report({c.tube, c.material, c.fluid, c.drive});
    EXPECT_EQ(theory->under_own_pressure->n, 3);
    c.drive.pressure_outlet *= load * theory->under_own_pressure->factor;
    return c;
}

/// Largest amplitude of three lobes along the tube at time t.
Real amplitude_at(Simulation& simulation, Real t)
{
    while (simulation.time() < t) simulation.step(t);
    Real most = 0;
    for (const ProfileRow& row : simulation.profile()) most = std::max(most, row.mode_3);
    return most;
}

/// d ln(amplitude)/dt, once the axisymmetric state is reached.
Real growth_rate(Real load)
{
    Simulation simulation(near_onset(load));
    const Real before = amplitude_at(simulation, 1), after = amplitude_at(simulation, 2.5);
    return std::log(after / before) / 1.5;
}

TEST(Buckling, SetsInAtTheLoadOfLinearTheory)
{
    const Real below = growth_rate(0.85), above = growth_rate(1.15);
    EXPECT_LT(below, 0);
    EXPECT_GT(above, 0);
    const Real onset = 0.85 - 0.3 * below / (above - below);
    EXPECT_NEAR(onset, 1, 0.05);
}

TEST(Buckling, TheoryNamesTheModeOfEachShippedCase)
{
    for (const int n : {2, 3, 4, 5, 6, 8}) {
        const std::string name = "collapse_mode" + std::to_string(n);
        const Case c = read_case_text(shipped_case(name).text, name);
        const auto theory = buckling_report({c.tube, c.material, c.fluid, c.drive});
        EXPECT_EQ(theory->under_own_pressure->n, n);
        EXPECT_LT(theory->under_own_pressure->factor, 1) << name;
        EXPECT_EQ(c.perturbation.mode, n);
    }
}

} // namespace
} // namespace starling
