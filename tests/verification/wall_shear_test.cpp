/// Wall shear stress over a cycle of a pulsating flow through a rigid tube, against Womersley's
/// solution.
#include <gtest/gtest.h>

#include <complex>

#include "simulation/cycles.hpp"
#include "simulation/simulation.hpp"

namespace starling {
namespace {

using Complex = std::complex<Real>;

/// J_0 or J_1 by its power series.
Complex bessel(int order, Complex z)
{
    Complex term = order == 0 ? Complex(1) : z / 2., sum = term;
    for (int n = 1; n < 40; ++n) {
        term *= -z * z / Real(4 * n * (n + order));
        sum += term;
    }
    return sum;
}

/// Complex amplitude of the wall shear stress that belongs to a pressure gradient -cos(t), in units
/// of R_0, rho and the angular frequency; Re = alpha^2.
Complex shear_amplitude(Real alpha)
{
    const Complex i(0, 1), k = std::pow(i, 1.5) * alpha;
    return k * bessel(1, k) / (i * alpha * alpha * bessel(0, k));
}

struct Shear {
    Real TAWSS = 0, OSI = 0;
};

/// Of mean + amplitude cos(t).
Shear exact(Real mean, Real amplitude)
{
    constexpr int n = 20000;
    Real size = 0;
    for (int m = 0; m < n; ++m) size += std::abs(mean + amplitude * std::cos(2 * pi * m / n)) / n;
    return {size, (1 - std::abs(mean) / size) / 2};
}

constexpr Real alpha = 2;

/// A pressure gradient g + cos(t), with which the mean of the wall shear stress, g/2, is `ratio`
/// of its amplitude.
Case pulsating(Real spacing, Real ratio)
{
    Case c;
    c.tube.length = 10 * spacing;
    c.tube.rigid = true;
    c.grid.spacing = spacing;
    c.grid.width_y = c.grid.width_z = 4;
    c.fluid = {alpha * alpha, 0.5};
    c.drive.pressure_inlet = 2 * ratio * std::abs(shear_amplitude(alpha)) * c.tube.length;
    c.drive.inlet_waveform = {.amplitude = c.tube.length, .period = 2 * pi, .cosine = {1}};
    c.time.step = 2 * pi / 400;
    return c;
}

/// Of the second cycle, mean over the middle ring.
Shear computed(const Case& c)
{
    Simulation s(c);
    Cycles cycles(c);
    while (cycles.memory().cycles < 2) {
        s.step(cycles.next());
        if (cycles.due(s.time(), s.dt())) cycles.add(s.sample(), s.wall_shear_stress());
    }
    std::vector<ProfileRow> rows = s.profile();
    add_shear(cycles.memory(), s.ring_size(), rows);
    return {rows[rows.size() / 2].TAWSS, rows[rows.size() / 2].OSI};
}

/// Spacing, ratio of the mean to the amplitude, relative error of TAWSS and error of OSI allowed.
struct Setting {
    Real spacing, ratio, of_TAWSS, of_OSI;
};
class WallShear : public testing::TestWithParam<Setting> {};

TEST_P(WallShear, OverACycleIsThatOfWomersleysFlow)
{
    const Setting s = GetParam();
    const Real amplitude = std::abs(shear_amplitude(alpha));
    const Shear expected = exact(s.ratio * amplitude, amplitude);
    const Shear found = computed(pulsating(s.spacing, s.ratio));
    RecordProperty("TAWSS_error_percent", std::to_string(100 * (found.TAWSS / expected.TAWSS - 1)));
    RecordProperty("OSI_error", std::to_string(found.OSI - expected.OSI));
    EXPECT_NEAR(found.TAWSS, expected.TAWSS, s.of_TAWSS * expected.TAWSS);
    EXPECT_NEAR(found.OSI, expected.OSI, s.of_OSI);
}

INSTANTIATE_TEST_SUITE_P(RatiosAndGrids, WallShear,
                         testing::Values(Setting{0.1, 0.1, 0.025, 0.002},
                                         Setting{0.1, 0.5, 0.025, 0.002},
                                         Setting{0.2, 0.5, 0.08, 0.008}));

} // namespace
} // namespace starling
