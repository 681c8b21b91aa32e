#pragma once
/// What the theories need to know of a case, and the moduli they share.
#include "flow/fluid_parameters.hpp"
#include "wall/wall_parameters.hpp"

namespace starling {

/// A clamped tube, its wall, its fluid and its drive.
struct TubeProblem {
    TubeParameters tube;
    MaterialParameters material;
    FluidParameters fluid;
    DriveParameters drive;

    Real clamp_inlet() const { return tube.rigid_inlet; }
    Real clamp_outlet() const { return tube.length - tube.rigid_outlet; }
    Real pressure_drop() const { return drive.pressure_inlet - drive.pressure_outlet; }
    /// Delta P / Delta P_0, with the baseline drop 4 L/Re (sec. 2.9).
    Real pressure_ratio() const { return pressure_drop() * fluid.reynolds / (4 * tube.length); }
};

/// Surface Poisson ratio of the law at small strain: nu_s of Hooke, C/(1 + C) of Skalak, 1/2 of the
/// incompressible laws.
Real small_strain_poisson_ratio(const MaterialParameters& material);

/// E'h = E_s/(1 - nu^2) = 2 G_s/(1 - nu) in rho U_c^2 R_0, the modulus of Eqs. (45), (46), (52).
Real effective_modulus(const MaterialParameters& material, Real reynolds);

} // namespace starling
