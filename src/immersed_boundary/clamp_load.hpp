#pragma once
/// The load on the rigid rows beside the clamps.
#include "wall/geometry.hpp"
#include "wall/tube.hpp"

namespace starling {

/// Kernels reach across a clamp. If only the rows that may move spread their forces, the force
/// fades out over a kernel's width while the pressure goes on: next to the clamp nothing holds the
/// fluid. So the row on the clamp and the rigid rows within reach carry on the transmural pressure
/// of the moving rows next to them: f = -[P] A with [P] fitted to the forces of those rows. They do
/// not move: their forces do no work on the wall.
class ClampLoad {
public:
    /// `reach`: half width of the kernels along x (R_0); 0 for none. `tube` must outlive this.
    ClampLoad(const Tube& tube, Real reach);

    /// Rings that spread forces: those that may move and the rigid ones within reach.
    RingRange spreading_rings() const { return {inlet_.rigid.begin, outlet_.rigid.end}; }

    /// Sets the forces f of the rigid vertices within reach from those of the moving ones.
    void apply(const Geometry& geometry, Array<Vec3>& f) const;

private:
    struct Side {
        RingRange rigid;  ///< rings that take up load, the clamp's among them
        RingRange moving; ///< rings that tell how much
    };
    void apply(const Side& side, const Geometry& geometry, Array<Vec3>& f) const;

    const Tube* tube_;
    Side inlet_, outlet_;
};

} // namespace starling
