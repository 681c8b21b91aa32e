#include "theory/tube_waves.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "theory/wave_speed.hpp"

namespace starling {
namespace {

constexpr Real hardly_viscous = 1e10;

MaterialParameters material(Real reynolds)
{
    MaterialParameters m;
    m.eps = 2 / reynolds; // c = 1
    return m;
}

GridParameters box(Real width)
{
    GridParameters g;
    g.width_y = g.width_z = width;
    return g;
}

TubeWaves waves(Real reynolds, Real width = 4.7)
{
    return {material(reynolds), reynolds, box(width)};
}

/// Eq. of docs/theory.md with modified Bessel functions, K = 2.
Real closed_form(Real k, Real width)
{
    const Real b = width / std::sqrt(pi);
    const auto I = [](int n, Real z) { return std::cyl_bessel_i(n, z); };
    const auto K = [](int n, Real z) { return std::cyl_bessel_k(n, z); };
    const Real N = K(0, k) * I(1, k * b) + I(0, k) * K(1, k * b);
    const Real D = K(1, k) * I(1, k * b) - I(1, k) * K(1, k * b);
    return std::sqrt(2 * k / (I(0, k) / I(1, k) + N / D));
}

/// 2 J_1(z)/(z J_0(z)) at z = i^(3/2) alpha, of Womersley's flow in a pipe as exp(i omega t).
Complex womersley_share(Real alpha)
{
    const Complex z = std::sqrt(Complex(0, 1)) * Complex(0, 1) * alpha;
    Complex J0 = 0, J1 = 0, term = 1;
    for (int n = 0; n < 80; ++n) {
        J0 += term;
        J1 += term * z / 2.0 / Real(n + 1);
        term *= -z * z / 4.0 / Real((n + 1) * (n + 1));
    }
    return 2.0 * J1 / (z * J0);
}

TEST(TubeWaves, WithoutViscosityTheDispersionIsTheClosedForm)
{
    for (const Real width : {3.0, 4.7, 9.4})
        for (const Real k : {1e-3, 0.1, 0.5, 1.0, 3.0}) {
            const Real exact = closed_form(k, width);
            EXPECT_NEAR(waves(1, width).inviscid_frequency(k), exact, 1e-7 * exact);
            const Complex omega = waves(hardly_viscous, width).frequency(k);
            EXPECT_NEAR(omega.real(), exact, 1e-3 * exact);
        }
}

TEST(TubeWaves, LongWavesHaveTheShareOfTheFluidInsideInTheInertia)
{
    for (const Real width : {3.0, 4.7, 9.4}) {
        const Real speed = std::sqrt(1 - pi / (width * width));
        EXPECT_NEAR(waves(1, width).long_wave_speed(), speed, 1e-14);
        EXPECT_NEAR(closed_form(1e-4, width) / 1e-4, speed, 1e-6);
    }
}

TEST(TubeWaves, LongWavesInAWideBoxHaveWomersleysFriction)
{
    const Real omega = 1e-3;
    for (const Real alpha : {0.5, 2.0, 5.0, 20.0}) {
        const Real reynolds = alpha * alpha / omega;
        const Complex k = waves(reynolds, 3000).wave_number(omega);
        const Complex exact = omega / std::sqrt(1.0 - std::conj(womersley_share(alpha)));
        EXPECT_LT(std::abs(k - exact), 2e-3 * std::abs(exact)) << alpha;
    }
}

TEST(TubeWaves, AWaveThatDecaysInTimeAndOneInSpaceAgreeByTheGroupSpeed)
{
    const TubeWaves w = waves(1e5);
    const Real k = 0.4, h = 1e-4;
    const Complex omega = w.frequency(k);
    const Real group = (w.frequency(k + h).real() - w.frequency(k - h).real()) / (2 * h);
    const Complex back = w.wave_number(omega.real());
    EXPECT_NEAR(back.real(), k, 2e-5);
    EXPECT_NEAR(group * back.imag(), -omega.imag(), 0.01 * std::abs(omega.imag()));
}

TEST(TubeWaves, FrictionStopsTheSwingOnceAndEveryFrequencyIsFound)
{
    const Real k = 0.25;
    bool swings = false;
    Complex last = 0;
    for (Real reynolds = 0.01; reynolds < 1e5; reynolds *= 1.1) {
        const Complex omega = waves(reynolds).frequency(k);
        ASSERT_TRUE(std::isfinite(omega.real()) && std::isfinite(omega.imag())) << reynolds;
        EXPECT_LT(omega.imag(), 0) << reynolds;
        const bool now = omega.real() > 1e-6 * std::abs(omega.imag());
        EXPECT_GE(now, swings) << reynolds; // a tube that swings does so at any higher Re
        if (swings) {
            EXPECT_GT(omega.real(), last.real()) << reynolds;
        }
        swings = now;
        last = omega;
    }
    EXPECT_TRUE(swings);
}

TEST(TubeWaves, VeryViscousTubesRelaxAsLubricationSays)
{
    const Real k = 0.05;
    for (const Real reynolds : {1e-6, 1e-3, 0.1}) {
        const Complex omega = waves(reynolds, 300).frequency(k);
        const Real rate = k * k * reynolds / 8;
        EXPECT_NEAR(omega.real(), 0, 1e-9 * rate);
        EXPECT_NEAR(-omega.imag(), rate, 0.01 * rate);
    }
}

TEST(TubeWaves, ViscosityOfTheWallAndDampersOfTheTissueDampAlike)
{
    const Real reynolds = 1e4, k = 0.3;
    MaterialParameters viscous = material(reynolds), damped = viscous;
    viscous.viscosity = 0.01;
    damped.support.damping = 0.04; // 2 mu_s/(1 - nu)
    const Complex a = TubeWaves(viscous, reynolds, box(4.7)).frequency(k);
    const Complex b = TubeWaves(damped, reynolds, box(4.7)).frequency(k);
    EXPECT_LT(std::abs(a - b), 1e-10);
    const Complex elastic = waves(reynolds).frequency(k);
    const Real more = std::norm(elastic) * damped.support.damping / 4; // omega^2 c/(2 K)
    EXPECT_NEAR(elastic.imag() - a.imag(), more, 0.05 * more);
}

TEST(TubeMode, RigidEndsLengthenTheWave)
{
    TubeParameters tube;
    tube.length = 10;
    tube.rigid_inlet = tube.rigid_outlet = 0;
    EXPECT_NEAR(slowest_wave_number(tube), pi / 10, 1e-12);
    tube.rigid_inlet = tube.rigid_outlet = 1;
    const Real k = slowest_wave_number(tube);
    EXPECT_NEAR(k * std::tan(4 * k), 1,
                1e-10); // pressure even about the middle: k l tan(k L_d/2) = 1
}

TEST(TubeMode, AnOverdampedTubeHasNoPeriod)
{
    const TubeParameters tube;
    EXPECT_TRUE(std::isnan(slowest_mode(waves(0.1), tube).period));
    const TubeMode mode = slowest_mode(waves(1000), tube);
    EXPECT_NEAR(mode.period, 2 * tube.length / 0.926, 0.1 * mode.period);
    EXPECT_GT(mode.decay_time, mode.period);
}

TEST(WavesText, NamesSpeedAndModeInTheUnitsOfTheCase)
{
    TubeProblem problem;
    problem.fluid.reynolds = 1000;
    problem.material = material(1000);
    const Scaling si{.si = true, .length = 0.005, .velocity = 0.1, .density = 1060};
    const std::string text = waves_text(problem, box(4.7), si);
    for (const char* part : {"Moens-Korteweg", "0.1 m/s", "0.0926165 m/s", "period", " s\n"})
        EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
    const std::string csv = waves_csv(problem, box(4.7), si);
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "omega [1/s],speed [m/s],attenuation [1/m]");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 201);
    EXPECT_EQ(csv.find("nan"), std::string::npos);
    problem.tube.rigid = true;
    EXPECT_EQ(waves_text(problem, box(4.7), si), "");
    EXPECT_THROW(waves_csv(problem, box(4.7), si), std::exception);
}

} // namespace
} // namespace starling
