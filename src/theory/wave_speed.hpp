#pragma once
/// Speed of small pressure pulses along the tube.
#include "theory/tube_problem.hpp"

namespace starling {

/// Moens-Korteweg speed c in U_c of long pulses about a uniform tube of radius R, with E/(1 - nu^2)
/// for E because there is no axial strain: c^2 = (R/2) dP/dR with P = tau_2(1, R)/R +
/// k (R - 1)/R, k the stiffness of the tissue around. For Hooke at R = 1 and k = 0:
/// 1/sqrt(Re eps (1 - nu_s)). NaN where the pressure falls with the radius (no waves: the tube is
/// unstable).
Real wave_speed(const MaterialParameters& material, Real reynolds, Real R = 1);

} // namespace starling
