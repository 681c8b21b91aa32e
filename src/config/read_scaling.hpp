#pragma once
/// The scales of a case file: R_0, U_c and rho.
#include "config/case_values.hpp"

namespace starling {

/// The scales of an SI file, all 1 in a dimensionless one; a scale that cannot be found is NaN
/// and has been reported. U_c is drive.velocity_scale where it is given; else the centreline speed
/// |P_in - P_out| R_0^2/(4 mu L) for which the applied pressure drop is 4 L/Re (sec. 2.9).
Scaling read_scaling(CaseValues& values);

/// Re = rho U_c R_0/mu, from the file or from SI values; keeps its default where it cannot be
/// found, which has been reported.
void read_reynolds(CaseValues& values, const Scaling& scaling, Real& reynolds);

} // namespace starling
