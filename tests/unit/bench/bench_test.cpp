#include <gtest/gtest.h>

#include "bench/bench.hpp"
#include "bench/traffic.hpp"
#include "core/error.hpp"
#include "core/for_each.hpp"

namespace starling::bench {
namespace {

TEST(Timing, MedianIsTheLowerOfTheTwoInTheMiddle)
{
    EXPECT_EQ((Timing{{3, 1, 2}}).median(), 2);
    EXPECT_EQ((Timing{{4, 1, 3, 2}}).median(), 2);
    EXPECT_EQ((Timing{{5}}).median(), 5);
    EXPECT_EQ((Timing{{4, 1, 3, 2}}).least(), 1);
}

TEST(Triad, TimesEveryPassAndKeepsTheNumberOfThreads)
{
    const int before = max_threads();
    Triad triad(100'000);
    const Timing timing = triad.run(2, 4);
    EXPECT_EQ(timing.seconds.size(), 4u);
    EXPECT_GT(timing.least(), 0);
    EXPECT_EQ(max_threads(), before);
}

TEST(Problem, IsReadAndWrittenAlike)
{
    EXPECT_EQ(grid_text(parse_grid("512x240x240")), "512x240x240");
    for (const char* wall : {"none", "17k", "250k", "950"})
        EXPECT_EQ(wall_text(parse_wall(wall)), wall);
    for (const char* grid : {"", "32", "32x24", "32x24x24x24", "32x24x24 ", "32x-24x24", "ax24x24",
                             "99999999999999999999x24x24"})
        EXPECT_THROW(parse_grid(grid), InputError) << grid;
    for (const char* wall :
         {"", "k", "17K", "1e4", "100", "-17k", "99999999999999999999", "20000k"})
        EXPECT_THROW(parse_wall(wall), InputError) << wall;
}

TEST(Problem, WallHasAboutTheVerticesAskedFor)
{
    for (Index vertices : {600, 2000}) {
        const BuiltProblem built = build({{32, 24, 24}, vertices});
        EXPECT_NEAR(static_cast<double>(built.steps->vertices()), static_cast<double>(vertices),
                    0.1 * static_cast<double>(vertices));
    }
}

TEST(Problem, StepsStaySoundAndFillEveryPhase)
{
    for (Index vertices : {0, 1000}) {
        const BuiltProblem built = build({{32, 24, 24}, vertices});
        for (int n = 0; n < 100; ++n) built.steps->step();
        EXPECT_TRUE(built.steps->sound()) << vertices;
        for (double seconds : built.steps->timer().seconds()) EXPECT_GT(seconds, 0);
    }
}

TEST(Plan, IsRefusedWhereItsLargestProblemDoesNotFit)
{
    const Plan plan{.problems = {{{32, 24, 24}}, {{512, 240, 240}, 250'000}}, .threads = {1}};
    const auto needed = static_cast<Index>(expected_bytes(plan.problems[1]));
    EXPECT_NO_THROW(check_memory(plan, needed + 1));
    EXPECT_THROW(check_memory(plan, needed - 1), InputError);
}

TEST(StepRow, ShareOfTheBoundIsOneWhereSeparateKernelsWouldUseAllBandwidth)
{
    StepRow row;
    row.problem.cells = {100, 100, 100};
    row.bandwidth = 20e9;
    row.step.seconds = {2 * 1e6 * bytes_per_cell_step() / 20e9, 1e6 * bytes_per_cell_step() / 20e9};
    EXPECT_DOUBLE_EQ(row.share_of_bound(), 1);
}

TEST(Report, HasARowForEveryProblemAndNumberOfThreads)
{
    Plan plan{.problems = {{{24, 18, 16}}, {{24, 18, 16}, 500}}, .threads = {2, 1}};
    plan.repeats = 2;
    plan.triad_size = 1000;
    int lines = 0;
    const Report report = run(plan, [&](const std::string&) { ++lines; });
    EXPECT_EQ(lines, 4);
    ASSERT_EQ(report.bandwidth.size(), 2u);
    ASSERT_EQ(report.rows.size(), 4u);
    for (std::size_t n = 0; n < 4; ++n) {
        const StepRow& row = report.rows[n];
        EXPECT_EQ(row.threads, n % 2 == 0 ? 2 : 1);
        EXPECT_EQ(row.bandwidth, report.bandwidth[n % 2].best);
        EXPECT_EQ(row.step.seconds.size(), 2u);
        EXPECT_EQ(row.phases.size(), n < 2 ? 2u : 7u);
    }
}

} // namespace
} // namespace starling::bench
