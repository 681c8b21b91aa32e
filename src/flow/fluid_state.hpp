#pragma once
/// What the fluid remembers from one step to the next; part of a checkpoint.
#include "flow/fluid_parameters.hpp"
#include "grid/field.hpp"

namespace starling {

/// Velocity on faces (U_c) and pressure in cells (rho U_c^2), with valid halos, and the advection
/// term of the step before for Adams-Bashforth.
struct FluidState {
    VectorField u;
    ScalarField P;
    VectorField N_before; ///< div(u u) of the previous step, at the faces
    Real dt_before = 0;   ///< previous time step; 0 before the first
    /// What P takes on the faces at x = 0 and x = L (rho U_c^2; ny x nz each, z fastest).
    std::array<Array<Real>, 2> end_pressure;

    explicit FluidState(const Grid& g)
        : u(g), P(g),
          N_before(g), end_pressure{Array<Real>(g.ny() * g.nz()), Array<Real>(g.ny() * g.nz())}
    {
    }
};

} // namespace starling
