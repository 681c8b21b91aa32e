#pragma once
/// The constraint that wall vertices never move axially, seen from the fluid.
#include "immersed_boundary/coupling_parameters.hpp"
#include "immersed_boundary/delta.hpp"
#include "wall/geometry.hpp"

namespace starling {

/// What keeps the wall from moving along x pushes back along the wall's normal: with n the normal
/// and n_perp its part across x, the force (0, f_y, f_z) becomes part of a normal force with the
/// axial component f_x = (f_y n_y + f_z n_z) n_x/|n_perp|^2. Its adjoint moves the wall with the
/// fluid's normal velocity: U_perp += u n_x n_perp/|n_perp|^2. Derivation: docs/numerics.md.
/// Deviation: Eq. (35) drops both; the printed scheme is the guide with neither.
class AxialGuide {
public:
    explicit AxialGuide(CouplingScheme scheme) : scheme_(scheme) {}

    bool pushes_back() const { return scheme_ != CouplingScheme::printed; }
    bool follows_normal_velocity() const { return scheme_ == CouplingScheme::conserving; }
    KernelPair kernels() const;
    /// Rings whose forces act on the fluid and that feel its velocity: those that may move, or all.
    RingRange acting_rings(const Tube& tube) const;

    /// Replaces f_x of the acting rings by the guide's reaction (or zero).
    void constrain_force(const Tube& tube, const Geometry& geometry, Array<Vec3>& f) const;

    /// Turns the fluid's velocity at the acting rings into the wall's, with no axial part.
    void constrain_velocity(const Tube& tube, const Geometry& geometry,
                            Array<Vec3>& velocity) const;

private:
    CouplingScheme scheme_;
};

} // namespace starling
