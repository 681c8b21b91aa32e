#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "output/summary.hpp"
#include "simulation/estimate.hpp"
#include "simulation/steady.hpp"
#include "wall/tube.hpp"

namespace starling {
namespace {

Case inflation()
{
    Case c;
    c.drive.pressure_inlet = 1.5 * c.baseline_pressure_drop();
    c.stop.steady_tolerance = 1e-4;
    return c;
}

TEST(Estimate, CountsCellsAsTheSimulationDoes)
{
    Case c = inflation();
    c.grid.spacing = 0.19;
    c.grid.width_y = c.grid.width_z = 4;
    EXPECT_EQ(estimate_run(c).cells, Simulation(c).cells());
}

TEST(Estimate, WallIsCountedToAFewPerCent)
{
    const Case c = inflation();
    const RunEstimate e = estimate_run(c);
    const Real delta = std::cbrt(e.spacing.x * e.spacing.y * e.spacing.z);
    const Tube tube = make_tube(c.tube, c.tube.edge_over_spacing * delta);
    EXPECT_NEAR(static_cast<Real>(e.vertices), static_cast<Real>(tube.X.size()),
                0.03 * static_cast<Real>(e.vertices));
}

TEST(Estimate, SmallestLimitBindsUnlessTheStepIsFixed)
{
    Case c = inflation();
    const RunEstimate automatic = estimate_run(c);
    for (const TimeStepLimit& limit : automatic.limits) EXPECT_LE(automatic.dt, limit.dt);
    c.time.step = 1e-3;
    EXPECT_EQ(estimate_run(c).dt, 1e-3);
}

TEST(Estimate, WarnsOfAFixedStepAboveALimit)
{
    Case c = inflation();
    const RunEstimate automatic = estimate_run(c);
    EXPECT_TRUE(automatic.warnings.empty());
    c.time.step = 0.9 * automatic.dt;
    EXPECT_TRUE(estimate_run(c).warnings.empty());
    c.time.step = 1.1 * automatic.dt;
    ASSERT_EQ(estimate_run(c).warnings.size(), 1u);
    EXPECT_NE(estimate_run(c).warnings[0].find(automatic.binding.name), std::string::npos);
}

TEST(Estimate, BendingLimitsTheStepOfAStiffWallOnAFineGrid)
{
    const auto names = [](const Case& c) {
        std::vector<std::string> found;
        for (const TimeStepLimit& limit : estimate_run(c).limits) found.push_back(limit.name);
        return found;
    };
    Case c = inflation();
    EXPECT_EQ(std::ranges::count(names(c), "bending stiffness"), 0);
    c.material.bending = 0.1;
    EXPECT_EQ(std::ranges::count(names(c), "bending stiffness"), 1);
    EXPECT_EQ(estimate_run(c).binding.name, "bending stiffness");
    c.material.bending = 1e-6;
    EXPECT_NE(estimate_run(c).binding.name, "bending stiffness");
}

TEST(Memory, ThatIsNotThereIsRefused)
{
    Case c = inflation();
    const Index needed = estimate_run(c).memory_bytes;
    EXPECT_NO_THROW(check_memory(c, needed));
    EXPECT_THROW(check_memory(c, needed - 1), InputError);
    EXPECT_GT(available_memory_bytes(), Index{1} << 20);
    c.grid.spacing = 0.005; // 2.3e9 cells
    EXPECT_THROW(check_memory(c, available_memory_bytes()), InputError);
}

TEST(Estimate, DurationIsThatOfTheFirstCriterion)
{
    Case c = inflation();
    EXPECT_DOUBLE_EQ(estimate_run(c).duration, expected_time_to_steady(c, 1e-4));
    c.stop.end_time = 0.5;
    EXPECT_DOUBLE_EQ(estimate_run(c).duration, 0.5);
    c.stop.steps = 3;
    EXPECT_DOUBLE_EQ(estimate_run(c).steps, 3);
}

TEST(Estimate, TakesAboutEightRelaxationTimesToATenThousandth)
{
    const Case c = inflation();
    EXPECT_NEAR(expected_time_to_steady(c, 1e-4) / relaxation_time(c), 7.7, 0.1);
}

TEST(Estimate, WavesOfHookesTubeRunAtTheMoensKortewegSpeed)
{
    const Case c = inflation(); // 1/sqrt(Re eps (1 - nu))
    EXPECT_NEAR(estimate_run(c).wave_speed, 1 / std::sqrt(0.1 * 0.02 * 0.5), 1e-6);
}

} // namespace
} // namespace starling
