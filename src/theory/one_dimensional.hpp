#pragma once
/// Steady one-dimensional model of the clamped tube: membrane rings in equilibrium by virtual work
/// (no axial displacement, both stretches, the law's own tensions) with Poiseuille flow in each
/// section. For steady inflation at low Re; derivation and limits: docs/theory.md.
#include <vector>

#include "theory/tube_problem.hpp"

namespace starling {

/// Solution of the model, in the paper's units.
struct OneDimensionalTube {
    std::vector<Real> x; ///< nodes from 0 to L, closest together at the clamps
    std::vector<Real> R; ///< radius at the nodes; 1 in the rigid ends and at the clamps
    std::vector<Real> P; ///< pressure at the nodes (not transmural)
    Real Q = 0;          ///< flow rate
    Real R_max = 1;      ///< largest radius
    Real x_R_max = 0;    ///< where it is

    /// Radius and pressure between the nodes, linear in x; the end values outside [0, L].
    Real R_at(Real position) const;
    Real P_at(Real position) const;
};

/// Solves the model with 2 x `intervals` elements in the deforming part and, to raise the order
/// from two to four, with `intervals`; about 20 ms. A rigid tube gives Poiseuille flow, section by
/// section where its radius varies. Throws InputError where the wall deforms about a rest radius
/// that varies, NumericalError if loading from zero to the given pressures in small steps meets no
/// solution.
OneDimensionalTube solve_one_dimensional(const TubeProblem& problem, Index intervals = 1000);

/// The same with inertia to all orders in Re times the slope: the profile of the velocity is
/// marched along the tube (boundary_layer.hpp), with first-order accuracy on one mesh. For flows
/// slower than the waves of the wall, from inlet to outlet. Throws NumericalError where it finds no
/// steady tube.
OneDimensionalTube solve_marched(const TubeProblem& problem, Index intervals = 1000);

} // namespace starling
