#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/for_each.hpp"
#include "simulation/simulation.hpp"

namespace starling {
namespace {

Case coarse_tube()
{
    Case c;
    c.tube.length = 4;
    c.tube.rigid_inlet = c.tube.rigid_outlet = 0.8;
    c.grid.spacing = 0.33;
    c.grid.width_y = c.grid.width_z = 4.5;
    c.drive.pressure_inlet = c.baseline_pressure_drop();
    return c;
}

/// Lengths of the steps to a time `end` from now.
std::vector<Real> steps_to(Real end, Real dt)
{
    std::vector<Real> steps;
    while (end > 0 && steps.size() < 1000) {
        steps.push_back(step_towards(end, dt));
        end -= steps.back();
    }
    return steps;
}

TEST(StepTowards, KeepsAStepThatFits)
{
    for (Real dt : steps_to(1, 0.1)) EXPECT_NEAR(dt, 0.1, 1e-15);
    EXPECT_EQ(step_towards(1, 0.1), 0.1);
}

TEST(StepTowards, MakesEqualStepsThatAreNoLonger)
{
    const auto steps = steps_to(1, 0.3);
    ASSERT_EQ(steps.size(), 4u);
    for (Real dt : steps) EXPECT_NEAR(dt, 0.25, 1e-15);
}

TEST(StepTowards, NeverLeavesASliver)
{
    for (Real end : {0.1, 0.1 + 1e-15, 0.1 - 1e-15, 0.3, 0.31, 0.7 + 1e-13})
        for (Real dt : steps_to(end, 0.1)) EXPECT_GT(dt, 0.049) << end;
}

TEST(Simulation, LandsExactlyOnATime)
{
    Simulation simulation(coarse_tube());
    const Real end = 2.3 * simulation.dt();
    for (int n = 0; n < 3; ++n) simulation.step(end);
    EXPECT_EQ(simulation.time(), end);
    EXPECT_EQ(simulation.steps(), 3);
}

TEST(Simulation, BlamesAFixedStepThatIsTooLong)
{
    Case c = coarse_tube();
    c.time.step = 3;
    Simulation simulation(c);
    std::string message;
    try {
        for (int n = 0; n < 100; ++n) simulation.step();
    } catch (const NumericalError& e) {
        message = e.what();
    }
    EXPECT_NE(message.find("step is too long"), std::string::npos) << message;
    EXPECT_NE(message.find("membrane stiffness"), std::string::npos) << message;
    EXPECT_EQ(message.find("time.safety"), std::string::npos) << message;
}

TEST(Simulation, SaysThatTheWallReachedTheBoxWhenItDid)
{
    Case c = coarse_tube();
    c.material.law = ElasticLaw::neo_hookean; // no equilibrium at such a pressure
    c.drive.pressure_inlet = c.drive.pressure_outlet = 6 / (c.fluid.reynolds * c.material.eps);
    c.time.safety = 0.2;
    Simulation simulation(c);
    std::string message;
    try {
        for (int n = 0; n < 4000; ++n) simulation.step();
    } catch (const NumericalError& e) {
        message = e.what();
    }
    EXPECT_NE(message.find("side of the box"), std::string::npos) << message;
}

TEST(Simulation, ReturnsToASoundStateAfterABreakdown)
{
    Case c = coarse_tube();
    c.time.step = 3;
    Simulation simulation(c);
    EXPECT_THROW(for (int n = 0; n < 100; ++n) simulation.step(), NumericalError);
    simulation.back_to_good();
    EXPECT_TRUE(std::isfinite(simulation.sample().Q_in));
}

TEST(Simulation, RefusesMoreThreadsThanItWasBuiltWith)
{
    const int before = max_threads();
    omp_set_num_threads(1);
    Simulation simulation(coarse_tube());
    omp_set_num_threads(2);
    EXPECT_THROW(simulation.step(), std::logic_error);
    omp_set_num_threads(before);
}

/// A soft wall with small waves on it, without flow.
Case soft_tube()
{
    Case c = coarse_tube();
    c.fluid.reynolds = 10;
    c.material.eps = 1;
    c.perturbation.amplitude = 1e-3;
    c.drive.pressure_inlet = 0;
    return c;
}

/// Growth of the waves in 150 steps of `factor` times the automatic one; infinite where the run
/// breaks down.
Real growth(Case c, Real factor)
{
    c.time.step = factor * Simulation(c).dt();
    Simulation simulation(c);
    const auto depth = [&] { return 1 - simulation.sample().R_min; };
    const Real start = depth();
    try {
        for (int n = 0; n < 150; ++n) simulation.step();
    } catch (const NumericalError&) {
        return std::numeric_limits<Real>::infinity();
    }
    return depth() / start;
}

/// The largest stable steps are about twice these limits.
TEST(TimeStepLimits, OfTissueAndWallViscosityAreNeitherLongNorShort)
{
    Case springs = soft_tube(), dampers = soft_tube(), viscous = soft_tube();
    springs.material.support.stiffness = 1000;
    dampers.material.support.damping = 100;
    viscous.material.viscosity = 10;
    const std::vector<std::pair<std::string, Case>> stiff = {
        {"tissue stiffness", springs}, {"tissue damping", dampers}, {"wall viscosity", viscous}};
    for (const auto& [name, c] : stiff) {
        EXPECT_EQ(Simulation(c).limiting().name, name);
        EXPECT_LT(growth(c, 1), 1.05) << name;
        EXPECT_GT(growth(c, 4), 10) << name;
    }
}

} // namespace
} // namespace starling
