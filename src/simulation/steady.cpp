#include "simulation/steady.hpp"

#include <algorithm>
#include <limits>

#include "theory/wave_speed.hpp"

namespace starling {

namespace {

constexpr Real bessel_zero = 2.404825557695773; ///< first zero of J_0
constexpr Real least_displacement = 0.01;       ///< R_max - 1 below which changes count absolutely
constexpr Real least_flow = 1e-6;               ///< Q below which changes count absolutely
constexpr Real least_slowing = 0.25;            ///< of waves on a stream nearly as fast as they

/// Largest minus smallest value over the samples.
template <class Value>
Real variation(const std::deque<Sample>& samples, Value value)
{
    Real low = value(samples.front()), high = low;
    for (const Sample& s : samples) {
        low = std::min(low, value(s));
        high = std::max(high, value(s));
    }
    return high - low;
}

/// The slowest wave of the tube: the time in which it falls by e, and half its period (zero where
/// friction does not let it oscillate).
struct SlowestWave {
    Real relaxation, half_period;
};

// Volume and momentum of long waves about the undeformed tube, with Poiseuille's profile:
// A_t + Q_x = 0 and (4/3) u_t = -p_x - (8/Re) u, between ends of given pressure:
// s^2 + 2 f s + omega^2 = 0 with omega = c pi/L and f = 3/Re. The fluid outside moves the other way
// and has its share of the inertia, by which omega^2 and f fall. Boundary layers thinner than the
// profile damp a fast wave at sqrt(omega/2 Re). On a stream, waves with and against it need
// 1/(1 - U^2/c^2) times as long for the way there and back.
SlowestWave slowest_wave(const Case& c)
{
    const Real Re = c.fluid.reynolds;
    const Real share = 1 - pi / (c.grid.width_y * c.grid.width_z);
    const Real speed_squared = share * 3 / 4 * std::pow(wave_speed(c.material, Re), 2);
    const Real U = 2 * c.pressure_ratio() / 3; // 4/3 of the mean velocity
    const Real slowing = std::max(1 - U * U / speed_squared, least_slowing);
    const Real omega = std::sqrt(speed_squared) * pi / c.tube.length, f = share * 3 / Re;
    if (omega < f) return {(f + std::sqrt(f * f - omega * omega)) / (omega * omega), 0};
    const Real rate = std::max(f, share * std::sqrt(omega / (2 * Re)));
    return {1 / (slowing * rate), pi / (slowing * omega)};
}

Real start_up_time(const Case& c) { return c.fluid.reynolds / (bessel_zero * bessel_zero); }

} // namespace

Real relaxation_time(const Case& c)
{
    if (c.tube.rigid) return start_up_time(c);
    return std::max(slowest_wave(c).relaxation, start_up_time(c));
}

Real steady_window(const Case& c)
{
    if (c.tube.rigid) return c.fluid.reynolds;
    const SlowestWave wave = slowest_wave(c);
    return std::max({0.25 * wave.relaxation, 0.25 * start_up_time(c), wave.half_period});
}

void SteadyCriterion::add(const Sample& sample)
{
    samples_.push_back(sample);
    while (samples_.size() > 1 && samples_[1].t <= sample.t - window_) samples_.pop_front();
}

Real SteadyCriterion::measure() const
{
    if (samples_.size() < 2 || samples_.front().t > samples_.back().t - window_)
        return std::numeric_limits<Real>::infinity();
    const Sample& last = samples_.back();
    const Real Q = std::max(std::abs(last.Q_mid), least_flow);
    const Real displacement = std::max(std::abs(last.R_max - 1), least_displacement);
    const Real flow = variation(samples_, [](const Sample& s) { return s.Q_mid; });
    const Real radius = variation(samples_, [](const Sample& s) { return s.R_max; });
    const Real balance =
        variation(samples_, [](const Sample& s) { return s.Q_in - s.Q_out - s.dV_dt; });
    return std::max({std::abs(last.dV_dt) / Q, flow / Q, balance / Q, radius / displacement}) /
           tolerance_;
}

} // namespace starling
