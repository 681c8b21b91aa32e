#include "simulation/steady.hpp"

#include <algorithm>
#include <limits>

namespace starling {

namespace {

constexpr Real bessel_zero = 2.404825557695773; ///< first zero of J_0
constexpr Real least_displacement = 0.01;       ///< R_max - 1 below which changes count absolutely
constexpr Real least_flow = 1e-6;               ///< Q below which changes count absolutely

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

} // namespace

Real relaxation_time(const Case& c)
{
    if (c.tube.rigid) return c.fluid.reynolds / (bessel_zero * bessel_zero);
    return 0.4 * c.material.eps * c.tube.length * c.tube.length;
}

Real steady_window(const Case& c)
{
    return c.tube.rigid ? c.fluid.reynolds : 0.25 * relaxation_time(c);
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
