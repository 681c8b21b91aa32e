#pragma once
/// What a case says about the fluid and its drive.
#include "core/types.hpp"
#include "flow/waveform.hpp"

namespace starling {

/// Fluid properties and time discretisation (pressure in rho U_c^2).
struct FluidParameters {
    Real reynolds = 0.1; ///< Re = rho U_c R_0 / mu
    Real theta = 1;      ///< weight of the new time level in diffusion: 1 or 1/2
};

/// Pressures on the end faces (rho U_c^2): inlet and outlet inside the tube, external outside it.
struct EndPressures {
    Real inlet = 0, outlet = 0, external = 0;
};

/// A flow rate that the inlet must have (R_0^2 U_c).
struct InletFlow {
    bool given = false;
    Real mean = 0;
    Waveform waveform = {}; ///< added to it
};

/// Three elements behind the outlet: a resistance R1 in series with a compliance C that drains
/// through a resistance R2 against a distal pressure.
struct Windkessel {
    Real R1 = 0, R2 = 0; ///< (rho U_c/R_0^2); R2 = 0: there is none
    Real C = 0;          ///< (R_0^3/(rho U_c^2))
    Real distal = 0;     ///< (rho U_c^2)

    bool none() const { return R2 == 0; }
};

/// What drives the flow: a steady pressure at each place and a waveform added to it. In place of
/// the pressure the inlet may have a flow rate, the outlet a Windkessel.
struct DriveParameters {
    Real pressure_inlet = 0; ///< rho U_c^2, as all here
    Real pressure_outlet = 0;
    Real pressure_external = 0;
    Waveform inlet_waveform = {}, outlet_waveform = {}, external_waveform = {};
    Real ramp = 0; ///< time in which all of it rises from zero, as sin^2; 0: at once
    InletFlow inlet_flow = {};
    Windkessel windkessel = {};
    bool total_pressure = false; ///< at the ends the pressure is the total one of what flows in

    bool has_waveform() const
    {
        return !(inlet_waveform.none() && outlet_waveform.none() && external_waveform.none() &&
                 inlet_flow.waveform.none());
    }
    /// Whether both ends have a pressure of their own, whatever flows.
    bool gives_pressures() const { return !inlet_flow.given && windkessel.none(); }
    /// The pressures at a time t >= 0.
    EndPressures at(Real t) const;
    /// The flow rate that is asked of the inlet.
    Real inlet_flow_at(Real t) const;
    /// The pressure behind the Windkessel.
    Real distal_pressure_at(Real t) const;
    /// The largest size that flow rate has.
    Real largest_inlet_flow() const;
    /// The steady drives that widen and narrow the tube at least as much as this one ever does.
    DriveParameters widest() const;
    DriveParameters narrowest() const;
    /// The shortest time after which all waveforms repeat, at most 50 times the longest of their
    /// periods; 0: there is none, or a waveform that does not repeat.
    Real period() const;
    /// A time step that follows the waveforms and the ramp; infinite for a drive that is steady.
    Real resolution() const;
};

} // namespace starling
