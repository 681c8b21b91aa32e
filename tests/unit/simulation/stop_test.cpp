#include <gtest/gtest.h>

#include "simulation/stop.hpp"

namespace starling {
namespace {

StopParameters end_time(Real t)
{
    StopParameters stop;
    stop.end_time = t;
    return stop;
}
StopParameters steps(Index n)
{
    StopParameters stop;
    stop.steps = n;
    return stop;
}
StopParameters wall_clock(Real seconds)
{
    StopParameters stop;
    stop.wall_clock = seconds;
    return stop;
}

/// Reason after a step at the given moment; "" while the run goes on.
std::string reason(const StopParameters& stop, const Moment& now)
{
    Case c;
    c.stop = stop;
    StopCriteria criteria(c);
    criteria.check(now);
    return criteria.reason().value_or("");
}

TEST(StopCriteria, EachEndsTheRunWhenReached)
{
    EXPECT_EQ(reason(end_time(1), {10, 0.9, 0.1, 5}), "");
    EXPECT_EQ(reason(end_time(1), {11, 1.0, 0.1, 5}), "end time");
    EXPECT_EQ(reason(steps(10), {9, 0.9, 0.1, 5}), "");
    EXPECT_EQ(reason(steps(10), {10, 0.9, 0.1, 5}), "steps");
    EXPECT_EQ(reason(wall_clock(6), {10, 0.9, 0.1, 5}), "");
    EXPECT_EQ(reason(wall_clock(6), {10, 0.9, 0.1, 7}), "wall clock");
}

TEST(StopCriteria, EndTimeMissedByRoundOffCountsAsReached)
{
    EXPECT_EQ(reason(end_time(1), {10, 1 - 1e-15, 0.1, 5}), "end time");
}

TEST(StopCriteria, InterruptEndsTheRunOnlyIfNothingElseDid)
{
    Case c;
    c.stop.steps = 3;
    StopCriteria going(c), done(c);
    going.interrupt();
    EXPECT_EQ(going.reason(), "interrupted");
    done.check({3, 1, 1, 1});
    done.interrupt();
    EXPECT_EQ(done.reason(), "steps");
}

TEST(StopCriteria, WithoutASteadyToleranceARunIsNeverSteady)
{
    Case c;
    c.stop.end_time = 1e9;
    StopCriteria stop(c);
    for (int n = 0; n < 100; ++n) {
        Sample s;
        s.t = n;
        stop.add(s);
    }
    EXPECT_FALSE(stop.reason());
    EXPECT_FALSE(stop.converged());
}

TEST(StopCriteria, TimeLeftFollowsTheNearestCriterion)
{
    Case c;
    c.stop.end_time = 10;
    c.stop.steps = 1000;
    const StopCriteria stop(c);
    // 100 steps of 0.01 in 5 s: 900 steps until 10 or 1000 steps.
    EXPECT_NEAR(stop.seconds_left({100, 1, 0.01, 5}), 45, 1e-9);
    c.stop.steps = 200;
    EXPECT_NEAR(StopCriteria(c).seconds_left({100, 1, 0.01, 5}), 5, 1e-9);
}

TEST(StopCriteria, TimeToSteadyIsReadFromTheDecay)
{
    Case c;
    c.material.eps = 0.01;
    c.tube.length = 10; // window 0.1
    c.stop.steady_tolerance = 1e-4;
    StopCriteria stop(c);
    EXPECT_TRUE(std::isnan(stop.seconds_left({1, 0.01, 0.01, 1})));
    Real t = 0;
    for (; t < 2; t += 0.02) {
        Sample s;
        s.t = t;
        s.Q_mid = 2;
        s.R_max = 1.2;
        s.dV_dt = 2 * std::exp(-t / 0.4);
        stop.add(s);
    }
    // dV/dt/Q = exp(-t/0.4) reaches 1e-4 at t = 3.68; one second per unit of time here.
    EXPECT_NEAR(stop.seconds_left({200, 2, 0.01, 2}), 1.68, 0.15);
}

} // namespace
} // namespace starling
