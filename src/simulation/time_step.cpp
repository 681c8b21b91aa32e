#include "simulation/time_step.hpp"

#include <algorithm>
#include <cmath>

namespace starling {

namespace {

constexpr Real part_of_a_step = 1e-6; ///< differences below are round-off

/// Of the stiffest part of the wall.
Real least_eps(const Case& c) { return c.material.eps / c.material.stiffness.highest(); }

// Explicit springs and dampers of the tissue: stable up to 2.3 sqrt(Delta/k) and 2.8 Delta/c, where
// a layer of fluid as thick as the grid's spacing answers. Where viscosity carries the force
// further within a step, and theta = 1, up to 4.4/(k^2 Re)^(1/3) and 30/(c^2 Re). Half of that.
void add_limits_of_support(std::vector<TimeStepLimit>& limits, const Case& c, Real spacing)
{
    const Real Re = c.fluid.reynolds, viscous = c.fluid.theta > 0.75 ? 1 : 0;
    const Real k = c.material.support.stiffness, damping = c.material.support.damping;
    if (k > 0)
        limits.push_back(
            {"tissue stiffness", c.time.safety * std::max(1.1 * std::sqrt(spacing / k),
                                                          viscous * 2 / std::cbrt(k * k * Re))});
    if (damping > 0)
        limits.push_back(
            {"tissue damping", c.time.safety * std::max(1.3 * spacing / damping,
                                                        viscous * 12 / (damping * damping * Re))});
}

// Explicit viscosity of the wall, on waves as short as the grid's spacing: stable up to
// 0.75 Delta^3/mu_s, and without a limit where the fluid's viscosity (theta = 1) outweighs it; half
// of either.
void add_limit_of_wall_viscosity(std::vector<TimeStepLimit>& limits, const Case& c, Real spacing)
{
    const Real of_fluid = c.fluid.theta > 0.75 ? 0.8 * spacing / c.fluid.reynolds : 0;
    const Real excess = c.material.viscosity - of_fluid;
    if (excess > 0)
        limits.push_back({"wall viscosity", c.time.safety * 0.4 * std::pow(spacing, 3) / excess});
}

} // namespace

std::vector<TimeStepLimit> time_step_limits(const Case& c, Real spacing, Real u_max)
{
    const Real Re = c.fluid.reynolds, theta = c.fluid.theta, safety = c.time.safety;
    std::vector<TimeStepLimit> limits;
    // Explicit elastic force on waves as long as the grid resolves, against implicit viscosity:
    // stable up to about 16 eps Delta (theta = 1) and 5 eps Delta (theta = 1/2) at low Re; half of
    // that. The narrower B-splines feel shorter, stiffer waves: with them the wall begins to
    // tremble at 8 eps Delta. At higher Re inertia carries the waves: stable up to
    // 1.1 sqrt(Re eps Delta^3), for theta = 1/2 too; 0.6 of that. Between, the squares add up.
    if (!c.tube.rigid) {
        const Real narrow = c.coupling.scheme == CouplingScheme::conserving ? 0.625 : 1;
        const Real viscous = narrow * (theta > 0.75 ? 8 : 2.5) * least_eps(c) * spacing;
        const Real inertial = 0.65 * std::sqrt(Re * least_eps(c) * spacing * spacing * spacing);
        limits.push_back({"membrane stiffness", safety * std::hypot(viscous, inertial)});
    }
    // Explicit bending force: the shortest waves of the mesh are the stiffest. Against viscosity
    // stable up to 22 eps l^3/B (theta = 1) and 3.5 eps l^3/B (theta = 1/2) for edges l of 0.65 to
    // 1 spacing, against inertia up to 1.65 sqrt(Re eps l^3 Delta^2/B); half of that, as it adds to
    // the membrane's stiffness.
    if (!c.tube.rigid && c.material.bending > 0) {
        const Real edge = c.tube.edge_over_spacing * spacing;
        const Real softness = c.material.eps * edge * edge * edge / c.material.bending;
        const Real viscous = (theta > 0.75 ? 11 : 1.75) * softness;
        const Real inertial = 0.8 * spacing * std::sqrt(Re * softness);
        limits.push_back({"bending stiffness", safety * std::hypot(viscous, inertial)});
    }
    // Explicit surface diffusion: stable up to 0.8 l^4/alpha.
    if (!c.tube.rigid && c.tube.smoothing > 0) {
        const Real edge = c.tube.edge_over_spacing * spacing;
        limits.push_back(
            {"surface smoothing", safety * 0.4 * std::pow(edge, 4) / c.tube.smoothing});
    }
    if (!c.tube.rigid) {
        add_limits_of_support(limits, c, spacing);
        add_limit_of_wall_viscosity(limits, c, spacing);
    }
    // Explicit advection: CFL 0.2; where viscosity rules the cell it damps advection as long as
    // u^2 dt < 2/Re, so the CFL number may rise to 0.5.
    const Real u = std::max(u_max, 1e-12);
    limits.push_back(
        {"advection",
         safety * std::max(0.2 * spacing / u, std::min(0.5 * spacing / u, 0.5 / (Re * u * u)))});
    // Ghost-node values lag by a step: tried stable up to dt/(Re Delta^2) = 52. The pressure behind
    // a rigid wall settles in a number of steps that grows with dt: 5 is near the best.
    limits.push_back({"ghost nodes", safety * (c.tube.rigid ? 5 : 50) * Re * spacing * spacing});
    // A drive that changes in time, for accuracy: 50 steps to its shortest harmonic.
    if (std::isfinite(c.drive.resolution()))
        limits.push_back({"drive", safety * c.drive.resolution()});
    return limits;
}

const TimeStepLimit& smallest(const std::vector<TimeStepLimit>& limits)
{
    return *std::min_element(limits.begin(), limits.end(),
                             [](const auto& a, const auto& b) { return a.dt < b.dt; });
}

Real grid_wave_time(const Case& c, Real spacing)
{
    const Real Re = c.fluid.reynolds, eps = least_eps(c);
    return std::max(8 * eps * spacing, pi * std::sqrt(Re * eps * spacing * spacing * spacing));
}

Real step_towards(Real remaining, Real dt)
{
    const Real steps = std::ceil(remaining / dt - part_of_a_step);
    if (steps <= 1) return remaining;
    const Real equal = remaining / steps;
    return std::abs(equal - dt) < part_of_a_step * dt ? dt : equal;
}

} // namespace starling
