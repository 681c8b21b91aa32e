#pragma once
/// The named limits of the time step.
#include <string>
#include <vector>

#include "config/case.hpp"

namespace starling {

inline constexpr Real closest_targets = 0.25; ///< in steps: times nearer to each other are one

/// A bound on the time step and what it comes from ("membrane stiffness", "advection", ...).
struct TimeStepLimit {
    std::string name;
    Real dt = 0;
};

/// The limits on dt for a case at largest speed u_max (U_c); the smallest binds. See
/// docs/numerics.md for where each comes from.
std::vector<TimeStepLimit> time_step_limits(const Case& c, Real spacing, Real u_max);

/// The binding one of a list that is not empty.
const TimeStepLimit& smallest(const std::vector<TimeStepLimit>& limits);

/// Time in which waves of the wall as short as the grid spacing relax, about 8 eps Delta, or half
/// their period, pi sqrt(Re eps Delta^3), where inertia carries them (R_0/U_c); eps of its stiffest
/// part.
Real grid_wave_time(const Case& c, Real spacing);

/// A step of at most `dt` (to within a millionth) such that equal steps lead to a time `remaining`
/// (> 0) from now; `remaining` itself if one step does.
Real step_towards(Real remaining, Real dt);

} // namespace starling
