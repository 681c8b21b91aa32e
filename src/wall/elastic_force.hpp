#pragma once
/// In-plane elastic forces of the wall: constant-strain triangles.
#include "core/array.hpp"
#include "wall/materials.hpp"
#include "wall/tube.hpp"

namespace starling {

/// The undeformed triangle: inverse edge matrix and area.
struct ReferenceElement {
    Real m11, m12, m21, m22; ///< inverse of [X_b - X_a, X_c - X_a] in the element's plane
    Real area;
};

/// Surface deformation of one element: columns of A-hat along two orthogonal directions of the
/// undeformed plane, and G = A^T A. (1), (14)
struct SurfaceDeformation {
    Vec3 a1, a2;
    Real G11, G12, G22;

    SurfaceDeformation(const ReferenceElement& r, const Vec3& edge_b, const Vec3& edge_c)
        : a1(r.m11 * edge_b + r.m21 * edge_c), a2(r.m12 * edge_b + r.m22 * edge_c),
          G11(dot(a1, a1)), G12(dot(a1, a2)), G22(dot(a2, a2))
    {
    }
    /// Squares of the principal stretches, the larger first. (14)
    std::array<Real, 2> squared_stretches() const
    {
        const Real half_difference = 0.5 * (G11 - G22);
        const Real root = std::sqrt(half_difference * half_difference + G12 * G12);
        const Real mean = 0.5 * (G11 + G22);
        return {mean + root, mean - root};
    }
};

/// Forces of all elements that touch a vertex that may move, summed at the vertices.
class ElasticForce {
public:
    ElasticForce(const Tube& tube, const Material& material);

    /// f = elastic force on each vertex (a force, not a density), from the first Piola-Kirchhoff
    /// stress, Eq. (15). Zero on vertices without an element that can deform.
    void compute(const Array<Vec3>& x, Array<Vec3>& f);

    /// The same from the strain energy, Eq. (16): an independent check. Throws
    /// std::invalid_argument for a law without energy (Hooke).
    void compute_from_energy(const Array<Vec3>& x, Array<Vec3>& f);

    /// Total strain energy; NaN for a law without energy.
    Real energy(const Array<Vec3>& x) const;

    /// Principal stretches of an element, the larger first.
    std::array<Real, 2> stretches(const Array<Vec3>& x, ElementIndex e) const;

    const Material& material() const { return material_; }

private:
    template <class SecondPiolaKirchhoff>
    void element_forces(const Array<Vec3>& x, SecondPiolaKirchhoff stress);
    SurfaceDeformation deformation(const Array<Vec3>& x, ElementIndex e) const;
    void gather(Array<Vec3>& f) const;

    const WallMesh* mesh_;
    Material material_;
    ElementIndex begin_, end_; ///< elements with a vertex that may move
    std::vector<ReferenceElement> reference_;
    Array<std::array<Vec3, 3>> corner_force_;
};

} // namespace starling
