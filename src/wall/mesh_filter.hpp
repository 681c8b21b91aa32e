#pragma once
/// Removes the shortest waves of the wall's displacement, which the fluid cannot see.
#include "core/array.hpp"
#include "wall/wall_state.hpp"

namespace starling {

/// The wall carries waves between neighbouring vertices that are shorter than two grid spacings;
/// interpolation and spreading do not see them, so nothing restores them once they are there. The
/// filter takes them out of the displacement d = x - X with the high-pass operator H = (L/1.5)^4,
/// L d = d - mean of d over the neighbours, whose response is at most 1: about 1 at the shortest
/// waves and falling with the eighth power of the wave number. Vertices on and beyond the clamps
/// do not move.
class MeshFilter {
public:
    /// `rate` is that of the shortest waves (1/time).
    MeshFilter(const Tube& tube, Real rate);

    /// Adds the velocity -rate H d at the moving vertices; a step dt removes at most all of H d.
    void add_velocity(WallState& wall, Real dt);

private:
    /// The part across x: vertices never leave their x.
    struct Across {
        Real y, z;
    };
    void high_pass(const Array<Across>& in, Array<Across>& out) const;

    const Tube* tube_;
    Real rate_;
    std::vector<VertexIndex> neighbours_; ///< of the moving vertices
    std::vector<std::size_t> begin_;
    Array<Across> a_, b_;
};

} // namespace starling
