#include "simulation/cycles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "simulation/resume.hpp"
#include "simulation/run.hpp"
#include "simulation/stop.hpp"
#include "unit/output/temporary_directory.hpp"

namespace starling {
namespace {

namespace fs = std::filesystem;

/// A rigid tube with a pressure at the inlet that swings with period 2 after a ramp of 1.
Case swinging()
{
    Case c;
    c.tube.length = 1.2;
    c.tube.rigid = true;
    c.grid.spacing = 0.3;
    c.grid.width_y = c.grid.width_z = 4;
    c.fluid.reynolds = 5;
    c.drive.pressure_inlet = 0.5;
    c.drive.inlet_waveform = {.amplitude = 1, .period = 2, .sine = {1}};
    c.drive.ramp = 1;
    c.time.cycle_samples = 8;
    c.stop.periodic_tolerance = 0.01;
    c.output.wall = c.output.fluid = false;
    return c;
}

Sample sample(Real t, Real Q)
{
    Sample s;
    s.t = t;
    s.Q_in = s.Q_mid = s.Q_out = Q;
    s.R_max = s.volume = 1;
    return s;
}

/// Samples of a cycle in which the flow swings by 1 about `mean`.
std::vector<Sample> cycle(Real mean)
{
    std::vector<Sample> samples;
    for (int n = 1; n <= 8; ++n) samples.push_back(sample(n, mean + std::sin(pi / 4 * n)));
    return samples;
}

TEST(CycleChange, IsTheLargestDifferenceOverTheRange)
{
    EXPECT_EQ(cycle_change(cycle(3), cycle(3)), 0);
    EXPECT_NEAR(cycle_change(cycle(3), cycle(3.1)), 0.05, 1e-14) << "0.1 over a range of 2";
    std::vector<Sample> other = cycle(3);
    other[5].P_out = 0.2;
    EXPECT_NEAR(cycle_change(cycle(3), other), 1, 1e-14) << "the pressure's range is 0.2";
    other = cycle(3);
    other[2].R_max += 1e-5;
    EXPECT_NEAR(cycle_change(cycle(3), other), 0.01, 1e-6) << "over a thousandth of R_0";
}

TEST(CycleChange, DoesNotTakeANarrowRangeBesideAWideOneForAMeasure)
{
    std::vector<Sample> a = cycle(0), b = cycle(0);
    for (Sample& s : a) s.Q_in = 0;
    for (Sample& s : b) s.Q_in = 1e-9;
    EXPECT_NEAR(cycle_change(a, b), 0.5e-9, 1e-15) << "over the range of Q_mid";
}

TEST(CycleValues, AreThoseOfTheCycle)
{
    const CycleValues v = values_over(cycle(3), &Sample::Q_mid);
    EXPECT_NEAR(v.mean, 3, 1e-14);
    EXPECT_NEAR(v.min, 2, 1e-14);
    EXPECT_NEAR(v.max, 4, 1e-14);
    EXPECT_NEAR(v.amplitude(), 1, 1e-14);
}

TEST(ShearSums, TellStressThatTurnsRoundFromStressThatKeepsItsDirection)
{
    ShearSums sums;
    sums.add(std::vector<Vec3>{{2, 0, 0}, {0, 3, 4}, {1, 0, 0}});
    sums.add(std::vector<Vec3>{{-2, 0, 0}, {0, 6, 8}, {0, 1, 0}});
    EXPECT_EQ(sums.TAWSS(0, 2), 2);
    EXPECT_EQ(sums.OSI(0), 0.5) << "back and forth";
    EXPECT_EQ(sums.TAWSS(1, 2), 7.5);
    EXPECT_EQ(sums.OSI(1), 0) << "one direction";
    EXPECT_NEAR(sums.OSI(2), (1 - std::sqrt(0.5)) / 2, 1e-15) << "turned by a right angle";
}

TEST(ShearSums, StandInFramesAndProfilesOfCyclesThatAreFollowed)
{
    CycleMemory cycles;
    WallSnapshot wall;
    wall.points.resize(4);
    std::vector<ProfileRow> rows(2);
    add_shear(cycles, wall);
    EXPECT_TRUE(wall.at_vertex.empty());
    cycles.period = 1;
    cycles.per_cycle = 1;
    add_shear(cycles, wall);
    add_shear(cycles, 2, rows);
    ASSERT_EQ(wall.at_vertex.size(), 2u);
    EXPECT_TRUE(std::isnan(wall.at_vertex[0].values[3])) << "no cycle is complete";
    EXPECT_TRUE(std::isnan(rows[1].OSI));
    cycles.shear_last.add(std::vector<Vec3>{{1, 0, 0}, {3, 0, 0}, {0, 0, 4}, {0, 0, 8}});
    wall.at_vertex.clear();
    add_shear(cycles, wall);
    add_shear(cycles, 2, rows);
    EXPECT_EQ(wall.at_vertex[0].values, (std::vector<Real>{1, 3, 4, 8}));
    EXPECT_EQ(wall.at_vertex[1].values, (std::vector<Real>{0, 0, 0, 0}));
    EXPECT_EQ(rows[0].TAWSS, 2);
    EXPECT_EQ(rows[1].TAWSS, 6);
    EXPECT_EQ(rows[1].OSI, 0);
}

TEST(Cycles, BeginAtWholePeriodsAfterTheRamp)
{
    Case c = swinging();
    EXPECT_NEAR(Cycles(c).next(), 2 + 0.25, 1e-14);
    c.drive.ramp = 0;
    EXPECT_NEAR(Cycles(c).next(), 0.25, 1e-14);
    c.drive.ramp = 2;
    EXPECT_NEAR(Cycles(c).next(), 2.25, 1e-14);
    c.time.cycle_samples = 0;
    EXPECT_TRUE(std::isinf(Cycles(c).next()));
    c.drive.inlet_waveform.amplitude = 0;
    c.time.cycle_samples = 8;
    EXPECT_TRUE(std::isinf(Cycles(c).next()));
}

TEST(Cycles, GoOnWhereTheyWereOnlyIfTheyAreTheSame)
{
    Case c = swinging();
    Cycles before(c);
    for (int n = 0; n < 11; ++n) before.add(sample(before.next(), n));
    Cycles after(c);
    after.go_on_from(before.memory(), 4.8);
    EXPECT_EQ(after.next(), before.next());
    EXPECT_EQ(after.memory().cycles, 1);
    EXPECT_EQ(after.memory().current.size(), 3u);
    c.drive.inlet_waveform.period = 3;
    Cycles others(c);
    others.go_on_from(before.memory(), 4.8);
    EXPECT_NEAR(others.next(), 6 + 3. / 8, 1e-14);
    EXPECT_EQ(others.memory().cycles, 0);
}

TEST(StopCriteria, CyclesThatAgreeEndTheRun)
{
    const Case c = swinging();
    StopCriteria stop(c);
    Cycles cycles(c);
    int complete = 0;
    Real left = 0;
    while (!stop.reason() && complete < 20) {
        const Real t = cycles.next();
        // changes of 0.5, 0.25, ... over the range of 2
        if (!cycles.add(sample(t, std::sin(pi * t) + std::pow(0.5, complete)))) continue;
        ++complete;
        stop.look_at(cycles);
        if (complete == 3) left = cycles.time_to(0.01);
    }
    EXPECT_EQ(stop.reason(), "periodic");
    EXPECT_TRUE(stop.converged());
    EXPECT_EQ(complete, 7) << "0.5^7 is the first change below 0.01";
    EXPECT_NEAR(left, 4 * 2, 1e-9) << "as the third cycle foresaw";
}

std::string contents(const fs::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(PeriodicRun, EndsWhenItsCyclesAgreeAndResumedToTheBitInTheMiddleOfOne)
{
    TemporaryDirectory dir;
    RunObserver quiet;
    Case c = swinging();
    const Summary whole = run(c, {dir.path() / "whole", false, {}}, quiet);
    EXPECT_EQ(whole.reason, "periodic");
    EXPECT_TRUE(whole.converged);
    ASSERT_TRUE(whole.cycle);
    EXPECT_LE(whole.cycle->change, 0.01);
    EXPECT_GE(whole.cycle->cycles, 2);
    EXPECT_EQ(whole.last.t, 2 * static_cast<Real>(whole.cycle->cycles + 1));
    const CycleValues Q = values_over(whole.cycle->last, &Sample::Q_mid);
    EXPECT_GT(Q.mean, 0);
    EXPECT_GT(Q.amplitude(), 0);

    c.stop.steps = whole.last.step - 20; // of 56 in a cycle
    run(c, {dir.path() / "parts", false, {}}, quiet);
    const CheckpointFile half = latest_checkpoint(dir.path() / "parts");
    EXPECT_FALSE(half.read_memory().cycles.current.empty());
    c.stop.steps.reset();
    const Summary parts = resume(c, half, dir.path() / "parts", quiet);
    EXPECT_EQ(parts.reason, "periodic");
    EXPECT_EQ(parts.cycle->change, whole.cycle->change);
    for (const CycleQuantity& q : cycle_quantities())
        EXPECT_EQ(values_over(parts.cycle->last, q.member).mean,
                  values_over(whole.cycle->last, q.member).mean)
            << q.name;
    EXPECT_EQ(contents(dir.path() / "parts/profile.csv"),
              contents(dir.path() / "whole/profile.csv"));
    EXPECT_THROW(resume(c, latest_checkpoint(dir.path() / "parts"), dir.path() / "parts", quiet),
                 InputError)
        << "nothing is left to do";
}

} // namespace
} // namespace starling
