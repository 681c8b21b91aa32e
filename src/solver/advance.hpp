#pragma once
/// One time step.
#include "solver/operators.hpp"
#include "solver/state.hpp"

namespace starling {

/// Sets the fields at t = 0: fluid at rest under the end pressures, wall undeformed.
void initialise(State& s, Operators& op);

/// Advances the state by dt. Returns false, before fluid and wall change, if the wall is not
/// finite, leaves the box or has moved by more than a spacing since the step before.
bool advance(State& s, Operators& op, Workspace& w, Real dt);

} // namespace starling
