#include <algorithm>
#include <cmath>
#include <limits>

#include "flow/fluid_parameters.hpp"

namespace starling {

namespace {

Real rise_at(Real t, Real ramp)
{
    const Real sine = t < ramp ? std::sin(pi / 2 * t / ramp) : 1;
    return sine * sine;
}

} // namespace

Real DriveParameters::inlet_flow_at(Real t) const
{
    return rise_at(t, ramp) * (inlet_flow.mean + inlet_flow.waveform(t));
}

Real DriveParameters::distal_pressure_at(Real t) const
{
    return rise_at(t, ramp) * windkessel.distal;
}

Real DriveParameters::largest_inlet_flow() const
{
    const InletFlow& q = inlet_flow;
    return std::max(std::abs(q.mean + q.waveform.lowest()),
                    std::abs(q.mean + q.waveform.highest()));
}

EndPressures DriveParameters::at(Real t) const
{
    const Real rise = rise_at(t, ramp);
    return {rise * (pressure_inlet + inlet_waveform(t)),
            rise * (pressure_outlet + outlet_waveform(t)),
            rise * (pressure_external + external_waveform(t))};
}

DriveParameters DriveParameters::widest() const
{
    return {pressure_inlet + inlet_waveform.highest(), pressure_outlet + outlet_waveform.highest(),
            pressure_external + external_waveform.lowest()};
}

DriveParameters DriveParameters::narrowest() const
{
    return {pressure_inlet + inlet_waveform.lowest(), pressure_outlet + outlet_waveform.lowest(),
            pressure_external + external_waveform.highest()};
}

Real DriveParameters::period() const
{
    constexpr Index most = 50;
    constexpr Real round_off = 1e-9;
    Real longest = 0;
    std::vector<Real> periods;
    for (const Waveform* w :
         {&inlet_waveform, &outlet_waveform, &external_waveform, &inlet_flow.waveform}) {
        if (w->none()) continue;
        if (w->period == 0) return 0;
        periods.push_back(w->period);
        longest = std::max(longest, w->period);
    }
    for (Index n = 1; n <= most && !periods.empty(); ++n) {
        const Real T = static_cast<Real>(n) * longest;
        const auto fits = [=](Real period) {
            const Real times = T / period;
            return std::abs(times - std::round(times)) <= round_off * times;
        };
        if (std::ranges::all_of(periods, fits)) return T;
    }
    return 0;
}

Real DriveParameters::resolution() const
{
    constexpr Real steps_of_ramp = 25;
    const Real rise = ramp > 0 ? ramp / steps_of_ramp : std::numeric_limits<Real>::infinity();
    return std::min({inlet_waveform.resolution(), outlet_waveform.resolution(),
                     external_waveform.resolution(), inlet_flow.waveform.resolution(), rise});
}

} // namespace starling
