#pragma once
/// The named limits of the time step.
#include <string>
#include <vector>

#include "config/case.hpp"

namespace starling {

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

} // namespace starling
