#pragma once
/// Flow rate through cross-sections of the tube, and values of the fluid at points.
#include "grid/field.hpp"
#include "wall/cross_section.hpp"

namespace starling {

/// Integrates u over the inside of the wall's cross-section with a face plane: midpoint rule in
/// cells that lie inside entirely, bilinear interpolation over the covered part of cut cells
/// (second order; u is continued oddly through the wall by the ghost nodes).
class SectionFlow {
public:
    SectionFlow(const Grid& g, const Tube& tube);

    /// Flow rate inside the tube through face plane i (R_0^2 U_c).
    Real inside(const ScalarField& u, const Array<Vec3>& x, Index i);

    /// Flow rate, through the plane `plane_x`, of the velocity that composite B-splines
    /// reconstruct, without divergence at any point (docs/numerics.md, "Kernels" and "Leak"). Its
    /// differences between planes are what passes the wall or changes the volume, and no error of
    /// quadrature.
    Real reconstructed(const ScalarField& u, const Array<Vec3>& x, Real plane_x);

    /// The same as inside() as a sum of weight times u over the faces of the plane: ny x nz weights
    /// (R_0^2), z fastest. The tube must keep a spacing from the sides of the box.
    Array<Real> weights(const Array<Vec3>& x, Index i);

    /// Flow rate through the whole plane, inside and outside.
    Real total(const ScalarField& u, Index i) const;

private:
    /// A piece of a sub-row inside a cell k: where u is taken in the cell of nodes from (j, n).
    struct Span {
        Index k, j, n;
        Real b, c, area;
    };
    void add_spans(Real y, Real z_begin, Real z_end);
    template <class Add>
    void for_reconstruction_weights(const Array<Vec3>& x, Real plane_x, Add add);
    /// Calls add(j, k, weight) for all nodes that count, some several times.
    template <class Add>
    void for_weights(const Array<Vec3>& x, Index i, Add add);

    static constexpr Index sub_rows = 8;
    Grid grid_;
    CrossSection section_;
    std::vector<Real> covered_; ///< per cell of the present row
    std::vector<Span> spans_;   ///< of the present row
};

/// Trilinear interpolation of a field at a point at least half a cell inside the box.
Real interpolate_at(const Grid& g, Location where, const ScalarField& field, const Vec3& p);

} // namespace starling
