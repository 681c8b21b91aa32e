#pragma once
/// Spreading wall forces to the grid and interpolating the fluid's velocity to the wall.
#include "grid/field.hpp"
#include "immersed_boundary/delta.hpp"
#include "wall/wall_state.hpp"

namespace starling {

/// The discrete delta function between vertices and the faces of the grid, Eqs. (28) and (30). Both
/// directions use the same weights, so that spreading is the adjoint of interpolation. Results do
/// not depend on the number of threads: every plane of the grid gathers from the rings in its reach
/// in a fixed order.
/// A pair with `sharpening` a has the weights S D instead of D, S = 1 - a (delta_x^2 + delta_y^2 +
/// delta_z^2) with second differences: no second moment across the component, hence no error of
/// second order from smearing. S commutes with the differences of the grid, so a divergence-free
/// interpolated velocity stays so.
/// Deviation: the paper spreads to nodes of the deforming part only (sec. 2.5). A stencil cut off
/// at the clamp loses force and volume: behind the inlet clamp 3 % of the flow left the tube at
/// Delta P/Delta P_0 = 3. Here stencils are whole; at the end faces of the tube, where nothing
/// changes along x, the weights beyond go to the mirror images of their nodes.
class Transfer {
public:
    /// `acting`: rings that spread forces and follow the fluid, all that may move among them.
    Transfer(const Grid& g, const Tube& tube, KernelPair kernels, RingRange acting);

    /// Computes the weights for positions x. Returns false (and leaves unusable weights) if a
    /// vertex is not finite or too close to the side of the box.
    bool update(const Array<Vec3>& x);

    /// F += force density at the faces of component c: sum of f_c D. f is a force per vertex.
    void spread(Location c, const Array<Vec3>& f, ScalarField& F) const;

    /// Component c of `velocity` at every vertex of the acting rings = sum of u_c D h^3. Needs
    /// valid halos of u.
    void interpolate(Location c, const ScalarField& u, Array<Vec3>& velocity) const;

private:
    /// Weights of all vertices along one direction: for components along it and across it.
    struct Stencils {
        Array<Stencil4> along, across;
    };
    static constexpr int planes = 6; ///< that the weights of a ring reach at most
    /// Factors along x of the weights of a ring: D, and S D in either direction.
    struct PlaneWeights {
        Index first = 0; ///< plane of the first one
        std::array<Real, planes> blunt{}, spread{}, interpolate{};
    };
    PlaneWeights plane_weights(const Stencil4& s, Index last, Index image) const;
    const PlaneWeights& weights_x(Location c, Index ring) const;
    /// The plane after those that the next ring reaches.
    Index end_of_next_ring(Location c, Index ring) const;
    /// Whether all vertices that act are finite and away from the sides of the box.
    bool fits(const Array<Vec3>& x, Real Vec3::*coordinate, Real origin, Real h, Index cells) const;
    void weigh(const Array<Vec3>& x, Real Vec3::*coordinate, Real origin, Real h, Stencils& s);
    /// Adds the forces of a ring to the planes begin <= i < end, all within its reach.
    void add_ring(Location c, Index ring, const Array<Vec3>& f, Index begin, Index end,
                  View<Real> F) const;
    const Stencil4* stencils_y(Location c) const
    {
        return c == Location::v ? y_.along.data() : y_.across.data();
    }
    const Stencil4* stencils_z(Location c) const
    {
        return c == Location::w ? z_.along.data() : z_.across.data();
    }

    Grid grid_;
    const Tube* tube_;
    KernelPair kernels_;
    RingRange acting_;
    std::vector<PlaneWeights> at_cells_, at_faces_; ///< of each ring: x never changes
    Stencils y_, z_;
};

} // namespace starling
