#include "theory/tube_waves.hpp"

#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "theory/report_text.hpp"
#include "theory/wave_speed.hpp"

namespace starling {

namespace {

constexpr Complex i_unit{0, 1};

/// I_1(z)/I_0(z) by its continued fraction, from far enough out inwards.
Complex ratio_inside(Complex z)
{
    constexpr Real large = 300;
    if (std::abs(z) > large) return 1.0 - (0.5 + (0.125 + 0.125 / z) / z) / z;
    Complex ratio = 0;
    for (int n = 40 + 2 * static_cast<int>(std::abs(z)); n > 0; --n)
        ratio = 1.0 / (2.0 * n / z + ratio);
    return ratio;
}

/// -G'(1)/(q G(1)) of the Bessel function G(q r) with G' = 0 at r = R_b: by its Riccati equation
/// dy/d(ln r) = q r (y^2 - 1) - y from there, or from so near that what lies beyond has no say.
Complex ratio_outside(Complex q, Real R_b)
{
    constexpr int steps = 1000;
    constexpr Real reach = 40; // over |q|
    const auto slope = [&](Real s, Complex y) { return q * std::exp(s) * (y * y - 1.0) - y; };
    const bool far = (R_b - 1) * std::abs(q) > reach;
    Real s = far ? std::log1p(reach / std::abs(q)) : std::log(R_b);
    Complex y = far ? 1 : 0;
    const Real h = -s / steps;
    for (int n = 0; n < steps; ++n, s += h) {
        const Complex a = slope(s, y), b = slope(s + h / 2, y + h / 2 * a),
                      c = slope(s + h / 2, y + h / 2 * b), d = slope(s + h, y + h * c);
        y += h / 6 * (a + 2.0 * b + 2.0 * c + d);
    }
    return y;
}

/// Newton's method with a difference for the derivative; NaN where it does not settle.
template <class F>
Complex root(F f, Complex z)
{
    constexpr int most_steps = 100;
    constexpr Real tolerance = 1e-9, difference = 1e-4;
    for (int n = 0; n < most_steps; ++n) {
        const Complex h = difference * z, change = 2.0 * h * f(z) / (f(z + h) - f(z - h));
        z -= change;
        if (std::abs(change) < tolerance * std::abs(z)) return z;
    }
    return std::numeric_limits<Real>::quiet_NaN();
}

} // namespace

TubeWaves::TubeWaves(const MaterialParameters& m, Real reynolds, const GridParameters& box)
    : reynolds_(reynolds), stiffness_(2 * std::pow(wave_speed(m, reynolds), 2)),
      damping_(2 * m.viscosity / (1 - small_strain_poisson_ratio(m)) + m.support.damping),
      outer_radius_(std::sqrt(box.width_y * box.width_z / pi))
{
}

Real TubeWaves::long_wave_speed() const
{
    return std::sqrt(stiffness_ / 2 * (1 - 1 / (outer_radius_ * outer_radius_)));
}

/// dP/dR of wall and tissue.
Complex TubeWaves::stiffness(Complex omega) const { return stiffness_ - i_unit * omega * damping_; }

/// Pressure that the fluid on both sides puts against the wall, over omega^2/k times its motion.
Complex TubeWaves::inertia(Complex k, Complex omega) const
{
    constexpr Real least = 1e-4; // of k^2: below, what differs is linear in the difference
    Complex difference = -i_unit * omega * reynolds_, scale = 1;
    if (std::abs(difference) < least * std::norm(k)) {
        scale = difference / (least * k * k);
        difference = least * k * k;
    }
    const Complex l = std::sqrt(k * k + difference);
    const auto motion = [&](auto ratio) { return scale * (ratio(k) - k / l * ratio(l)); };
    return 1.0 / motion(ratio_inside) +
           1.0 / motion([&](Complex q) { return ratio_outside(q, outer_radius_); });
}

Real TubeWaves::inviscid_frequency(Real k) const
{
    const Complex of_fluid = 1.0 / ratio_inside(k) + 1.0 / ratio_outside(k, outer_radius_);
    return std::sqrt(stiffness_ * k / of_fluid.real());
}

/// As if the profile were Poiseuille's or, where that is thicker than boundary layers, at rest in
/// the middle.
Complex TubeWaves::first_guess(Real k) const
{
    const Real omega = inviscid_frequency(k), share = 1 - 1 / (outer_radius_ * outer_radius_);
    const Real f = share * 3 / reynolds_ + damping_ * omega * omega / (2 * stiffness_);
    const Real layers = share * std::sqrt(omega / (2 * reynolds_));
    if (f < layers) return Complex(omega - layers, -layers);
    const Real square = 0.75 * omega * omega;
    if (square > f * f) return Complex(std::sqrt(square - f * f), -f);
    return Complex(0, -square / (f + std::sqrt(f * f - square)));
}

Complex TubeWaves::frequency(Real k) const
{
    const auto mismatch = [&](Complex omega) {
        return omega * omega * inertia(k, omega) - stiffness(omega) * k;
    };
    return root(mismatch, first_guess(k));
}

Complex TubeWaves::wave_number(Real omega) const
{
    const auto mismatch = [&](Complex k) {
        return omega * omega * inertia(k, omega) * k - stiffness(omega) * k * k;
    };
    return root(mismatch, omega / long_wave_speed() * Complex(1, 0.1));
}

Real slowest_wave_number(const TubeParameters& tube)
{
    const Real length = tube.length - tube.rigid_inlet - tube.rigid_outlet;
    Real low = 0, high = pi / length;
    for (int n = 0; n < 60; ++n) {
        const Real k = (low + high) / 2;
        const Real phase =
            k * length + std::atan(k * tube.rigid_inlet) + std::atan(k * tube.rigid_outlet);
        (phase < pi ? low : high) = k;
    }
    return low;
}

TubeMode slowest_mode(const TubeWaves& waves, const TubeParameters& tube)
{
    constexpr Real swings = 1e-6; // of the decay rate
    const Real k = slowest_wave_number(tube);
    const Complex omega = waves.frequency(k);
    const bool periodic = std::abs(omega.real()) > swings * std::abs(omega.imag());
    return {k, periodic ? 2 * pi / std::abs(omega.real()) : std::numeric_limits<Real>::quiet_NaN(),
            -1 / omega.imag()};
}

std::string waves_text(const TubeProblem& problem, const GridParameters& box,
                       const Scaling& scaling)
{
    if (problem.tube.rigid) return "";
    const Real Re = problem.fluid.reynolds;
    const TubeWaves waves(problem.material, Re, box);
    const TubeMode mode = slowest_mode(waves, problem.tube);
    const Real speed = scaling.factor(Quantity::velocity), time = scaling.factor(Quantity::time);
    std::string text = "Small waves about the undeformed tube, fluid at rest\n";
    add_line(text, "Moens-Korteweg wave speed with E/(1 - nu^2)",
             wave_speed(problem.material, Re) * speed, scaling.unit(Quantity::velocity));
    add_line(text, "speed with the fluid outside, in this box", waves.long_wave_speed() * speed,
             scaling.unit(Quantity::velocity));
    add_line(text, "slowest mode between the ends: period", mode.period * time,
             scaling.unit(Quantity::time));
    add_line(text, "  falls by a factor e in", mode.decay_time * time,
             scaling.unit(Quantity::time));
    return text;
}

std::string waves_csv(const TubeProblem& problem, const GridParameters& box, const Scaling& scaling)
{
    if (problem.tube.rigid) throw InputError("--csv=waves: a rigid tube carries no waves");
    constexpr int rows = 200;
    constexpr Real largest_wave_number = 2;
    const TubeWaves waves(problem.material, problem.fluid.reynolds, box);
    const Real highest = waves.inviscid_frequency(largest_wave_number);
    const Real speed = scaling.factor(Quantity::velocity);
    const Real length = scaling.factor(Quantity::length);
    std::string text = heading("omega", scaling.unit(Quantity::rate)) + ',' +
                       heading("speed", scaling.unit(Quantity::velocity)) + ',' +
                       heading("attenuation", "1/" + scaling.unit(Quantity::length)) + '\n';
    for (int n = 1; n <= rows; ++n) {
        const Real omega = highest * n / rows;
        const Complex k = waves.wave_number(omega);
        fmt::format_to(std::back_inserter(text), "{:.10g},{:.10g},{:.10g}\n",
                       omega * scaling.factor(Quantity::rate), omega / k.real() * speed,
                       k.imag() / length);
    }
    return text;
}

} // namespace starling
