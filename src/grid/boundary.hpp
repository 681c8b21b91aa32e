#pragma once
/// Values on the sides of the box: zero normal derivative at the x ends, no-slip walls in y,
/// periodic in z.
#include "grid/field.hpp"

namespace starling {

/// Fills the halo of one velocity component from its unknowns and sets v = 0 on the y walls.
void fill_velocity_halo(const Grid& g, Location c, ScalarField& f);

/// Fills the halos of all three components.
void fill_velocity_halo(const Grid& g, VectorField& u);

/// Fills the halo of a cell field with zero normal derivative in y, periodic in z, and in x odd
/// about the end faces (a homogeneous Dirichlet value on the face).
void fill_increment_halo(const Grid& g, ScalarField& phi);

/// Where the inlet and outlet pressures act on the end faces: 1 in the cells (ny x nz, z fastest)
/// with r < R_0, 0 in the others, where the external pressure acts.
Array<Real> inside_share(const Grid& g);

} // namespace starling
