#pragma once
/// What the fluid remembers from one step to the next; part of a checkpoint.
#include "flow/fluid_parameters.hpp"
#include "grid/field.hpp"

namespace starling {

/// What the ends of the box remember (rho U_c^2).
struct EndState {
    std::array<Array<Real>, 2> pressure; ///< on the faces at x = 0 and x = L (ny x nz, z fastest)
    std::array<Real, 2> inside{};        ///< the pressure inside the tube it is made of
    Real stored = 0;                     ///< pressure in the compliance of the Windkessel

    explicit EndState(const Grid& g)
        : pressure{Array<Real>(g.ny() * g.nz()), Array<Real>(g.ny() * g.nz())}
    {
    }
};

/// Velocity on faces (U_c) and pressure in cells (rho U_c^2), with valid halos, and the advection
/// term of the step before for Adams-Bashforth.
struct FluidState {
    VectorField u;
    ScalarField P;
    VectorField N_before; ///< div(u u) of the previous step, at the faces
    Real dt_before = 0;   ///< previous time step; 0 before the first
    Real kinetic_energy = 0, kinetic_energy_before = 0; ///< now and a step ago (rho U_c^2 R_0^3)
    EndState ends;

    explicit FluidState(const Grid& g) : u(g), P(g), N_before(g), ends(g) {}
};

} // namespace starling
