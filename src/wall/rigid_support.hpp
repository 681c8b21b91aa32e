#pragma once
/// What holds the rigid parts of the tube in place against the fluid.
#include "wall/geometry.hpp"
#include "wall/high_pass.hpp"

namespace starling {

/// Forces on the fluid at the vertices of the rigid parts, f - (Delta/2 dt) |A| U. Every step
/// answers the flow U that passes such a vertex with more force, and takes out the waves that the
/// fluid cannot see,
///     f <- (1 - H) (f + dt f' - 4/sqrt(Re dt) |A| U),
/// so that f comes to rest where no fluid passes the wall. The pressure added is that which stops a
/// layer as thick as viscosity reaches in a step; the part with Delta, half of what stops a layer
/// of one spacing, damps what inertia would make swing. The rate f' learns from the same flow, so
/// that a load that changes steadily is followed with a part of the lag. Derivation and stability:
/// docs/numerics.md.
class RigidSupport {
public:
    /// `tube` must outlive this. A tube that is rigid all along is left to ghost nodes, and so are
    /// the rigid parts if no `support` is wanted.
    RigidSupport(const Tube& tube, bool support, Real reynolds, Real delta);

    /// f of the rigid vertices = the support's force in a step dt.
    void apply(const Geometry& geometry, const WallState& wall, Real dt, Array<Vec3>& f) const;

    /// Turns the fluid's velocity at the rigid vertices into support; they do not move.
    void hold(const Geometry& geometry, WallState& wall, Real dt);

private:
    static void take_out_waves(HighPass& part, const Vec3* area, Vec3* f);

    Real reynolds_, delta_;
    std::vector<HighPass> parts_; ///< one for each rigid part, none without support
};

} // namespace starling
