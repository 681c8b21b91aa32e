#include "simulation/stop.hpp"

#include <cmath>
#include <limits>

namespace starling {

namespace {

constexpr Real unknown = std::numeric_limits<Real>::quiet_NaN();
constexpr Real decay_windows = 4;     ///< the decay rate is taken over this many windows
constexpr Real part_of_a_step = 1e-6; ///< an end time missed by less counts as reached

} // namespace

StopCriteria::StopCriteria(const Case& c)
    : stop_(c.stop), window_(steady_window(c)), relaxation_(relaxation_time(c)),
      periodic_at_(unknown)
{
    if (stop_.steady_tolerance) steady_.emplace(*stop_.steady_tolerance, window_);
}

void StopCriteria::add(const Sample& sample)
{
    if (!steady_) return;
    steady_->add(sample);
    const Real measure = steady_->measure();
    if (std::isfinite(measure)) decay_.push_back({sample.t, measure});
    if (steady_->met()) reason_ = "steady";
}

void StopCriteria::look_at(const Cycles& cycles)
{
    if (!stop_.periodic_tolerance || cycles.memory().last.empty()) return;
    periodic_ = cycles.memory().change <= *stop_.periodic_tolerance;
    periodic_at_ = cycles.memory().last.back().t + cycles.time_to(*stop_.periodic_tolerance);
    if (periodic_ && !reason_) reason_ = "periodic";
}

std::vector<Sample> StopCriteria::memory() const
{
    if (!steady_) return {};
    return {steady_->samples().begin(), steady_->samples().end()};
}

void StopCriteria::check(const Moment& now)
{
    if (reason_) return;
    if (stop_.end_time && now.t >= *stop_.end_time - part_of_a_step * now.dt)
        reason_ = "end time";
    else if (stop_.steps && now.steps >= *stop_.steps)
        reason_ = "steps";
    else if (stop_.wall_clock && now.wall_seconds >= *stop_.wall_clock)
        reason_ = "wall clock";
}

void StopCriteria::interrupt()
{
    if (!reason_) reason_ = "interrupted";
}

Real StopCriteria::time_to_steady() const
{
    if (decay_.empty()) return unknown;
    const Point& last = decay_.back();
    auto first = decay_.rbegin();
    while (first + 1 != decay_.rend() && first->t > last.t - decay_windows * window_) ++first;
    // what is expected counts as much as what was seen over two windows
    const Real expected = 2 * window_ / relaxation_;
    const Real rate =
        (expected + std::log(first->measure / last.measure)) / (2 * window_ + last.t - first->t);
    return rate > 0 ? std::max(std::log(last.measure), Real{0}) / rate : unknown;
}

double StopCriteria::seconds_left(const Moment& now) const
{
    // std::fmin passes over what is unknown.
    const double seconds_per_step =
        now.wall_seconds / static_cast<double>(now.steps - now.first_step);
    double time = time_to_steady(), seconds = unknown;
    time = std::fmin(time, periodic_at_ - now.t);
    if (stop_.end_time) time = std::fmin(time, *stop_.end_time - now.t);
    if (stop_.steps) seconds = static_cast<double>(*stop_.steps - now.steps) * seconds_per_step;
    if (stop_.wall_clock) seconds = std::fmin(seconds, *stop_.wall_clock - now.wall_seconds);
    const double left = std::fmin(seconds, time / now.dt * seconds_per_step);
    return left < 0 ? 0 : left; // keeps NaN
}

} // namespace starling
