#pragma once
/// Spreading wall forces to the grid and interpolating the fluid's velocity to the wall.
#include "grid/field.hpp"
#include "immersed_boundary/delta.hpp"
#include "wall/wall_state.hpp"

namespace starling {

/// The discrete delta function between the vertices that may move and the faces of the grid,
/// Eqs. (28) and (30). Both directions use the same weights, so that spreading is the adjoint of
/// interpolation. Results do not depend on the number of threads: every plane of the grid gathers
/// from the rings in its reach in a fixed order.
/// Deviation: the paper spreads to nodes of the deforming part only (sec. 2.5). A stencil cut off
/// at the clamp loses force and volume: behind the inlet clamp 3 % of the flow left the tube at
/// Delta P/Delta P_0 = 3. Here the rings next to a clamp reach into the rigid part.
class Transfer {
public:
    Transfer(const Grid& g, const Tube& tube, KernelPair kernels);

    /// Computes the weights for positions x. Returns false (and leaves unusable weights) if a
    /// vertex is not finite or too close to the side of the box.
    bool update(const Array<Vec3>& x);

    /// rhs(c) += force density at the faces of component c: sum of f_c D. f is a force per vertex.
    void spread(Location c, const Array<Vec3>& f, ScalarField& rhs) const;

    /// Component c of `velocity` at every moving vertex = sum of u_c D h^3.
    void interpolate(Location c, const ScalarField& u, Array<Vec3>& velocity) const;

private:
    /// Weights across x of one vertex; along y for v, along z for w.
    struct VertexStencils {
        Stencil4 y_cell, y_face, z_cell, z_face;
    };
    struct RingStencils {
        Stencil4 x_cell, x_face;
    };
    /// Rings that reach a plane: [begin, end).
    struct RingRange {
        Index begin = 0, end = 0;
    };

    const Stencil4& stencil_x(Location c, Index ring) const;
    const Stencil4& stencil_y(Location c, const VertexStencils& s) const
    {
        return c == Location::v ? s.y_face : s.y_cell;
    }
    const Stencil4& stencil_z(Location c, const VertexStencils& s) const
    {
        return c == Location::w ? s.z_face : s.z_cell;
    }

    Grid grid_;
    const Tube* tube_;
    KernelPair kernels_;
    std::vector<RingStencils> ring_stencils_;     ///< x never changes: computed once
    std::array<std::vector<RingRange>, 2> reach_; ///< per plane; 0: cells, 1: faces
    Array<VertexStencils> stencils_;
};

} // namespace starling
