#pragma once
/// What a case says about the fluid and its drive.
#include "core/types.hpp"

namespace starling {

/// Fluid properties and time discretisation (pressure in rho U_c^2).
struct FluidParameters {
    Real reynolds = 0.1; ///< Re = rho U_c R_0 / mu
    Real theta = 1;      ///< weight of the new time level in diffusion: 1 or 1/2
};

/// Pressures on the end faces (rho U_c^2): inlet and outlet inside the tube, external outside it.
struct DriveParameters {
    Real pressure_inlet = 0;
    Real pressure_outlet = 0;
    Real pressure_external = 0;
};

} // namespace starling
