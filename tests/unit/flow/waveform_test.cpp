#include "flow/waveform.hpp"

#include <gtest/gtest.h>

#include "flow/fluid_parameters.hpp"

namespace starling {
namespace {

TEST(Waveform, IsNothingByDefault)
{
    EXPECT_TRUE(Waveform{}.none());
    EXPECT_EQ(Waveform{}(1.3), 0);
    EXPECT_EQ(Waveform{}.level(), 0);
}

TEST(Waveform, SumsAFourierSeries)
{
    const Waveform w{.amplitude = 2, .period = 4, .cosine = {0.5, 0, 0.25}, .sine = {1}};
    for (Real t : {0.0, 0.3, 1.7, 3.99}) {
        const Real a = 2 * pi * t / 4;
        const Real expected = 2 * (0.5 * std::cos(a) + 0.25 * std::cos(3 * a) + std::sin(a));
        EXPECT_NEAR(w(t), expected, 1e-14);
        EXPECT_NEAR(w(t + 3 * 4), expected, 1e-13) << "repeats";
    }
    EXPECT_EQ(w.level(), 0);
}

TEST(Waveform, JoinsATableByLinesAndHoldsItsEnds)
{
    const Waveform w{.amplitude = 10, .times = {1, 2, 4}, .values = {0, 1, 0.5}};
    EXPECT_EQ(w(0), 0);
    EXPECT_EQ(w(1), 0);
    EXPECT_NEAR(w(1.25), 2.5, 1e-14);
    EXPECT_EQ(w(2), 10);
    EXPECT_NEAR(w(3), 7.5, 1e-14);
    EXPECT_EQ(w(4), 5);
    EXPECT_EQ(w(1e6), 5);
    EXPECT_EQ(w.level(), 5);
}

TEST(Waveform, RepeatsATableThatHasAPeriod)
{
    // from 3 at t = 4 to 1 at t = 0.5 of the next period, 1.5 later
    const Waveform w{.amplitude = 1, .period = 5, .times = {0.5, 2, 4}, .values = {1, 2, 3}};
    EXPECT_NEAR(w(4.75), 2, 1e-14);
    EXPECT_NEAR(w(0), 3 - 2 / 1.5, 1e-14);
    EXPECT_NEAR(w(0.25), 1 + 2 * 0.25 / 1.5, 1e-14);
    EXPECT_NEAR(w(5 + 1.25), 1.5, 1e-14);
    EXPECT_NEAR(w(15 + 3), 2.5, 1e-13);
    const Real area = 1.5 * 1.5 + 2 * 2.5 + 1.5 * 2;
    EXPECT_NEAR(w.level(), area / 5, 1e-14);
}

TEST(Drive, AddsWaveformsAndRisesFromZero)
{
    DriveParameters d{3, 1, 0.5};
    EXPECT_FALSE(d.has_waveform());
    EXPECT_EQ(d.at(7).inlet, 3);
    EXPECT_EQ(d.at(7).outlet, 1);
    EXPECT_EQ(d.at(7).external, 0.5);
    d.outlet_waveform = {.amplitude = 2, .period = 1, .sine = {1}};
    EXPECT_TRUE(d.has_waveform());
    EXPECT_NEAR(d.at(0.25).outlet, 3, 1e-14);
    d.ramp = 4;
    EXPECT_EQ(d.at(0).inlet, 0);
    EXPECT_NEAR(d.at(2).inlet, 1.5, 1e-14) << "sin^2 of half way";
    EXPECT_NEAR(d.at(2.25).outlet, 3 * std::pow(std::sin(pi / 8 * 2.25), 2), 1e-14);
    EXPECT_EQ(d.at(4).inlet, 3);
}

TEST(Waveform, KnowsItsBoundsAndWhatResolvesIt)
{
    const Waveform wave{.amplitude = -2, .period = 6, .cosine = {0, 0, 1}};
    EXPECT_NEAR(wave.lowest(), -2, 1e-12);
    EXPECT_NEAR(wave.highest(), 2, 1e-12);
    EXPECT_NEAR(wave.resolution(), 6. / 150, 1e-12);
    const Waveform table{.amplitude = -1, .times = {1, 2, 4}, .values = {-3, 1, 0.5}};
    EXPECT_EQ(table.lowest(), -1);
    EXPECT_EQ(table.highest(), 3);
    EXPECT_EQ(table.resolution(), 3. / 50);
    EXPECT_EQ(Waveform{}.highest(), 0);
    EXPECT_TRUE(std::isinf(Waveform{}.resolution()));
}

TEST(Drive, RepeatsAfterTheCommonPeriodOfItsWaveforms)
{
    DriveParameters d;
    EXPECT_EQ(d.period(), 0) << "a steady drive";
    d.inlet_waveform = {.amplitude = 1, .period = 3, .sine = {1}};
    EXPECT_EQ(d.period(), 3);
    d.external_waveform = {.amplitude = 1, .period = 2, .sine = {1}};
    EXPECT_EQ(d.period(), 6);
    d.inlet_flow.waveform = {.amplitude = 1, .period = 0.6, .times = {0, 0.3}, .values = {0, 1}};
    EXPECT_EQ(d.period(), 6);
    d.external_waveform.period = std::sqrt(2.);
    EXPECT_EQ(d.period(), 0) << "periods that never meet";
    d.external_waveform = {.amplitude = 1, .times = {0, 1}, .values = {0, 1}};
    EXPECT_EQ(d.period(), 0) << "a table that does not repeat";
    d.external_waveform.amplitude = 0;
    EXPECT_EQ(d.period(), 3) << "which does nothing now";
}

TEST(Drive, IsBoundedByTheSteadyOnesThatWidenAndNarrowTheTubeMost)
{
    DriveParameters d{3, 1, 0.5};
    d.inlet_waveform = {.amplitude = 2, .period = 1, .sine = {1}};
    d.external_waveform = {.amplitude = 1, .times = {0, 1}, .values = {0.25, -0.5}};
    EXPECT_NEAR(d.widest().pressure_inlet, 5, 1e-12);
    EXPECT_NEAR(d.narrowest().pressure_inlet, 1, 1e-12);
    EXPECT_EQ(d.widest().pressure_external, 0);
    EXPECT_EQ(d.narrowest().pressure_external, 0.75);
    EXPECT_EQ(d.resolution(), 1. / 50);
    d.ramp = 0.1;
    EXPECT_EQ(d.resolution(), 0.1 / 25);
    EXPECT_TRUE(std::isinf(DriveParameters{}.resolution()));
}

} // namespace
} // namespace starling
