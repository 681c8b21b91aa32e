#pragma once
/// Resistance of the wall to bending: Canham and Helfrich's energy, Eqs. (18), (19).
#include <variant>

#include "wall/curvature.hpp"

namespace starling {

/// A membrane: no resistance to bending.
struct NoBending {
    void add(const Array<Vec3>&, const Geometry&, Array<Vec3>&) const {}
    Real energy(const Array<Vec3>&, const Geometry&) const { return 0; }
};

/// The force of W_b = E_b/2 integral (2 kappa - c_0)^2 dS, with n outwards and kappa = div n/2,
///     f_b = E_b [(2 kappa - c_0)(2 kappa^2 - 2 kappa_g + c_0 kappa) + Lap_s (2 kappa - c_0)] n
/// per area. c_0 is 2 kappa of the undeformed mesh, from the same fit and vertex by vertex, so that
/// the undeformed wall carries no force to the last bit.
/// Deviation: the signs of c_0 in (19) as printed belong to no energy; where c_0 is uniform the
/// last term is the printed 2 Lap_s kappa.
class HelfrichBending {
public:
    /// E_b in rho U_c^2 R_0^3. `tube` must outlive the object.
    HelfrichBending(const Tube& tube, Real E_b);

    /// f += bending force on each moving vertex (a force: density times the vertex's area vector);
    /// `geometry` is that of x.
    void add(const Array<Vec3>& x, const Geometry& geometry, Array<Vec3>& f);

    /// W_b of the part between the clamps, both rings on them included. (18)
    Real energy(const Array<Vec3>& x, const Geometry& geometry);

private:
    /// Fits the curvatures and sets bend_ = 2 kappa - c_0.
    void update(const Array<Vec3>& x, const Geometry& geometry);

    const Tube* tube_;
    Real E_b_;
    VertexRange range_;
    CurvatureFit fit_;
    SurfaceLaplacian laplacian_;
    Array<Real> c_0_;            ///< at each vertex
    Array<Real> bend_;           ///< 2 kappa - c_0, zero outside the range
    Array<Real> laplacian_bend_; ///< Lap_s of it
};

/// One of the two: NoBending for E_b = 0 or a rigid tube.
class Bending {
public:
    /// E_b in rho U_c^2 R_0^3. `tube` must outlive the object.
    Bending(const Tube& tube, Real E_b);

    /// f += bending force on each moving vertex; `geometry` is that of x. (23)
    void add(const Array<Vec3>& x, const Geometry& geometry, Array<Vec3>& f);
    /// W_b at the positions x.
    Real energy(const Array<Vec3>& x, const Geometry& geometry);

private:
    std::variant<NoBending, HelfrichBending> model_;
};

} // namespace starling
