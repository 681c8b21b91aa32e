#include <gtest/gtest.h>

#include <algorithm>

#include "config/read_case.hpp"
#include "config/shipped_cases.hpp"
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

/// Whether one of the warnings holds the words.
bool warns(const Case& c, const std::string& words)
{
    return std::ranges::any_of(estimate_run(c).warnings, [&](const std::string& w) {
        return w.find(words) != std::string::npos;
    });
}

TEST(Forewarning, NothingIsWrongWithTheShippedInflations)
{
    for (const char* name : {"inflation", "inflation_neo_hookean", "rigid_tube", "microchannel_si"})
        EXPECT_TRUE(estimate_run(read_case_text(shipped_case(name).text, name)).warnings.empty())
            << name;
}

TEST(Forewarning, OfAFlowFasterThanTheWaves)
{
    Case c;
    c.fluid.reynolds = 20; // waves at 2.24 U_c
    c.drive.pressure_inlet = c.baseline_pressure_drop();
    EXPECT_FALSE(warns(c, "faster than the waves")); // 1.55 U_c
    c.drive.pressure_inlet *= 1.3;
    EXPECT_TRUE(warns(c, "faster than the waves of the wall: about 2.7 U_c on the axis"));
    c.tube.rigid = true;
    EXPECT_TRUE(estimate_run(c).warnings.empty());
}

TEST(Forewarning, OfPressuresWithoutASteadyTube)
{
    Case c; // in which beyond a ratio of about 1.15 the flow runs away
    c.fluid.reynolds = 50;
    c.drive.pressure_inlet = 0.5 * c.baseline_pressure_drop();
    EXPECT_FALSE(warns(c, "no steady tube"));
    c.drive.pressure_inlet *= 2.5;
    EXPECT_TRUE(warns(c, "no steady tube"));
    EXPECT_TRUE(warns(c, "a smaller pressure drop or a stiffer wall"));
}

TEST(Forewarning, OfABoxTooNarrowNamesAWidthThatDoes)
{
    Case c = inflation(); // to R_max = 1.3025
    c.grid.width_y = 3;
    EXPECT_TRUE(warns(c, "Set grid.width_y to at least 3.3 R_0"));
    EXPECT_FALSE(warns(c, "grid.width_z"));
    c.grid.width_y = 3.3;
    EXPECT_TRUE(estimate_run(c).warnings.empty());
    c.grid.tube_offset_y = -0.3;
    EXPECT_TRUE(warns(c, "Set grid.width_y to at least 3.9 R_0"));
}

TEST(Forewarning, OfAnEndBeforeTheSteadyState)
{
    Case c = inflation();
    const Real steady = expected_time_to_steady(c, 1e-4), dt = estimate_run(c).dt;
    c.stop.end_time = 1.01 * steady;
    c.stop.steps = static_cast<Index>(1.01 * steady / dt) + 1;
    EXPECT_TRUE(estimate_run(c).warnings.empty());
    c.stop.end_time = 0.9 * steady;
    EXPECT_TRUE(warns(c, "raise stop.end_time"));
    c.stop.end_time.reset();
    c.stop.steps = static_cast<Index>(0.9 * steady / dt);
    EXPECT_TRUE(warns(c, "raise stop.steps to at least"));
    c.stop.steady_tolerance.reset(); // a course in time is wanted, not its end
    EXPECT_TRUE(estimate_run(c).warnings.empty());
}

TEST(Forewarning, OfSlowDrainingInCollapseWithoutPromisingAShortRun)
{
    Case c = read_case_text(shipped_case("collapse_mode3").text, "case");
    EXPECT_TRUE(warns(c, "drains through its narrowest place"));
    EXPECT_TRUE(estimate_run(c).at_least);
    c.stop.end_time = 0.1; // the end is known
    EXPECT_FALSE(estimate_run(c).at_least);
    c.drive.pressure_external = c.drive.pressure_outlet;
    EXPECT_FALSE(warns(c, "drains"));
    Case short_run = read_case_text(shipped_case("collapse_mode3").text, "case");
    short_run.stop.steady_tolerance.reset();
    EXPECT_TRUE(warns(short_run, "may buckle until its walls meet"));
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
