#pragma once
/// Constant-strain triangles: how they are deformed, and the nodal forces of a stress in them.
#include "core/array.hpp"
#include "core/for_each.hpp"
#include "wall/tube.hpp"

namespace starling {

/// The undeformed triangle: inverse edge matrix and area.
struct ReferenceElement {
    Real m11, m12, m22; ///< inverse of [X_b - X_a, X_c - X_a] in axes along X_b - X_a; m21 = 0
    Real area;
};

/// Symmetric 2 x 2 tensor in the undeformed plane.
struct Symmetric2 {
    Real s11, s12, s22;
};

/// Surface deformation of one element: columns of A-hat along two orthogonal directions of the
/// undeformed plane, and G = A^T A. (1), (14)
struct SurfaceDeformation {
    Vec3 a1, a2;
    Real G11, G12, G22;

    SurfaceDeformation(const ReferenceElement& r, const Vec3& edge_b, const Vec3& edge_c)
        : a1(r.m11 * edge_b), a2(r.m12 * edge_b + r.m22 * edge_c), G11(dot(a1, a1)),
          G12(dot(a1, a2)), G22(dot(a2, a2))
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

/// The elements that touch a vertex that may move.
class ElementForces {
public:
    /// `tube` must outlive the object.
    explicit ElementForces(const Tube& tube);

    /// The range of those elements.
    ElementIndex begin() const { return begin_; }
    ElementIndex end() const { return end_; }
    Real undeformed_area(ElementIndex e) const { return reference(e).area; }

    /// A and G of an element at positions x; its rate of change for velocities in place of x.
    SurfaceDeformation deformation(const Array<Vec3>& x, ElementIndex e) const
    {
        const auto& [a, b, c] = mesh_->element(e);
        return {reference(e), x[b] - x[a], x[c] - x[a]};
    }

    /// Forces of every element on its corners from the second Piola-Kirchhoff stress (Symmetric2)
    /// stress(e, deformation). They do the power -area stress : dG/dt/2.
    template <class Stress>
    void compute(const Array<Vec3>& x, Stress stress)
    {
        std::array<Vec3, 2>* force = corner_force_.data();
        for_range(begin_, end_, [this, &x, force, stress](Index n) {
            const auto e = static_cast<ElementIndex>(n);
            const SurfaceDeformation d = deformation(x, e);
            const Symmetric2 S = stress(e, d);
            const ReferenceElement& r = reference(e);
            // columns of P = A S, times the area
            const Vec3 P1 = r.area * (S.s11 * d.a1 + S.s12 * d.a2);
            const Vec3 P2 = r.area * (S.s12 * d.a1 + S.s22 * d.a2);
            // f_i = -P . grad H_i: the fluid feels -dW/dx (15)
            force[n] = {-(r.m11 * P1 + r.m12 * P2), -(r.m22 * P2)};
        });
    }

    /// f = sum of the forces on the corners that meet in each vertex. (17)
    void gather(Array<Vec3>& f) const;
    /// f += the same.
    void add(Array<Vec3>& f) const;

private:
    const ReferenceElement& reference(ElementIndex e) const
    {
        return reference_[static_cast<std::size_t>(e)];
    }
    Vec3 corner_force(const Corner& c) const
    {
        const auto& [f_b, f_c] = corner_force_[c.element];
        return c.corner == 0 ? -(f_b + f_c) : c.corner == 1 ? f_b : f_c;
    }
    Vec3 sum_at(VertexIndex v) const
    {
        Vec3 sum;
        for (const Corner* c = mesh_->corners_begin(v); c != mesh_->corners_end(v); ++c)
            sum += corner_force(*c);
        return sum;
    }

    const WallMesh* mesh_;
    ElementIndex begin_, end_;
    std::vector<ReferenceElement> reference_;
    Array<std::array<Vec3, 2>> corner_force_; ///< on the second and third; the first balances
};

} // namespace starling
