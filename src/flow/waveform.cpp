#include "flow/waveform.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace starling {

Real Waveform::operator()(Real t) const
{
    if (none()) return 0;
    return amplitude * (times.empty() ? series(t) : table(t));
}

Real Waveform::series(Real t) const
{
    const Real phase = 2 * pi * std::fmod(t, period) / period;
    Real sum = 0;
    for (std::size_t n = 0; n < cosine.size(); ++n)
        sum += cosine[n] * std::cos(static_cast<Real>(n + 1) * phase);
    for (std::size_t n = 0; n < sine.size(); ++n)
        sum += sine[n] * std::sin(static_cast<Real>(n + 1) * phase);
    return sum;
}

Real Waveform::table(Real t) const
{
    const std::size_t last = times.size() - 1;
    if (period > 0) t = std::fmod(t, period);
    const auto after = std::upper_bound(times.begin(), times.end(), t);
    const bool before_first = after == times.begin(), past_last = after == times.end();
    if (period == 0 && before_first) return values.front();
    if (period == 0 && past_last) return values.back();
    const auto n = static_cast<std::size_t>(after - times.begin());
    const std::size_t left = before_first ? last : n - 1, right = past_last ? 0 : n;
    const Real begin = times[left] - (before_first ? period : 0);
    const Real end = times[right] + (past_last ? period : 0);
    return values[left] + (t - begin) / (end - begin) * (values[right] - values[left]);
}

Real Waveform::level() const
{
    if (none() || times.empty()) return 0;
    if (period == 0) return amplitude * values.back();
    Real sum = 0;
    for (std::size_t n = 0; n < times.size(); ++n) {
        const bool past = n + 1 == times.size();
        const Real next = past ? times.front() + period : times[n + 1];
        sum += (next - times[n]) * (values[n] + (past ? values.front() : values[n + 1])) / 2;
    }
    return amplitude * sum / period;
}

std::vector<Real> Waveform::extremes() const
{
    if (!times.empty()) return values;
    std::vector<Real> all(64 * harmonics());
    for (std::size_t n = 0; n < all.size(); ++n)
        all[n] = series(period * static_cast<Real>(n) / static_cast<Real>(all.size()));
    return all;
}

Real Waveform::lowest() const
{
    if (none()) return 0;
    const auto [low, high] = std::ranges::minmax(extremes());
    return std::min(amplitude * low, amplitude * high);
}

Real Waveform::highest() const
{
    if (none()) return 0;
    const auto [low, high] = std::ranges::minmax(extremes());
    return std::max(amplitude * low, amplitude * high);
}

Real Waveform::resolution() const
{
    constexpr Real steps = 50;
    if (none()) return std::numeric_limits<Real>::infinity();
    if (times.empty()) return period / (steps * static_cast<Real>(harmonics()));
    const Real span = period > 0 ? period : times.back() - times.front();
    if (span == 0) return std::numeric_limits<Real>::infinity(); // one row: constant
    return span / std::max(steps, 2 * static_cast<Real>(times.size()));
}

} // namespace starling
