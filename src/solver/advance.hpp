#pragma once
/// One time step.
#include "solver/operators.hpp"
#include "solver/state.hpp"

namespace starling {

/// Sets the fields at t = 0: fluid at rest under the end pressures, wall undeformed.
void initialise(State& s, Operators& op);

/// The drive begins at once: pressure and the forces of the rigid parts at t = 0 become those with
/// which a first step of dt lets nothing pass the rigid parts, by steps tried again and again from
/// rest, in `trial`. Returns false like `advance`.
bool load_rigid_parts(State& s, State& trial, Operators& op, Workspace& w, Real dt);

/// Before a step of dt in which the load on the rigid parts changes fast: forces with which it lets
/// nothing pass, by a few trials of it, and their rate. Returns false like `advance`.
bool hold_rigid_parts(State& s, State& trial, Operators& op, Workspace& w, Real dt);

/// Advances the state by dt. Returns false, before fluid and wall change, if the wall is not
/// finite, leaves the box or has moved by more than a spacing since the step before.
bool advance(State& s, Operators& op, Workspace& w, Real dt);

} // namespace starling
