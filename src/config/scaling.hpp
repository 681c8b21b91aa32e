#pragma once
/// Conversion between the solver's dimensionless numbers and the units of the case file.
#include <string>

#include "core/types.hpp"

namespace starling {

/// What a number measures; decides its unit and its scale.
enum class Quantity {
    none,
    length,
    area,
    volume,
    time,
    velocity,
    flow_rate,
    pressure,
    force,
    energy,
    power,
    surface_tension,
    shear_stress,
    rate, ///< rate: 1/time
    density,
    viscosity,
    flow_resistance,    ///< pressure over flow rate
    compliance,         ///< volume over pressure
    stiffness_per_area, ///< pressure over length
    damping_per_area,   ///< pressure over velocity
    surface_viscosity   ///< force per length over a rate
};

/// Scales in SI; all 1 for dimensionless cases. Solver value times `factor` = value to print.
struct Scaling {
    bool si = false;
    Real length = 1;   ///< R_0 in m
    Real velocity = 1; ///< U_c in m/s
    Real density = 1;  ///< rho in kg/m^3

    /// Factor from solver units to the case's units.
    Real factor(Quantity q) const;
    /// Unit of printed values: SI symbol such as "m^3/s", or the paper's scale such as "R_0^2 U_c".
    std::string unit(Quantity q) const;
};

} // namespace starling
