#pragma once
/// Flow through a rigid tube of radius 1, in the paper's units (viscosity 1/Re).
#include "core/types.hpp"

namespace starling::poiseuille {

/// Q_0, the flow rate through the undeformed tube at Delta P = Delta P_0 = 4 L/Re.
inline constexpr Real baseline_flow_rate = pi / 2;

/// Q through a tube of radius `radius`, Eq. (54) with constant R.
constexpr Real flow_rate(Real pressure_drop, Real length, Real reynolds, Real radius = 1)
{
    return pi * reynolds * pressure_drop * radius * radius * radius * radius / (8 * length);
}

/// dP/dx that drives Q through a section of radius `radius`, Eq. (54).
constexpr Real pressure_gradient(Real flow_rate, Real reynolds, Real radius = 1)
{
    return -8 * flow_rate / (pi * reynolds * radius * radius * radius * radius);
}

/// Axial velocity at distance r from the axis of a section of radius `radius`; 0 outside it.
constexpr Real velocity(Real flow_rate, Real r, Real radius = 1)
{
    const Real s = r / radius;
    return s < 1 ? 2 * flow_rate / (pi * radius * radius) * (1 - s * s) : 0;
}

} // namespace starling::poiseuille
