#pragma once
/// Removes the shortest waves of the wall's displacement, which the fluid cannot see.
#include "wall/high_pass.hpp"
#include "wall/wall_state.hpp"

namespace starling {

/// The wall carries waves between neighbouring vertices that are shorter than two grid spacings;
/// interpolation and spreading do not see them, so nothing restores them once they are there. The
/// filter takes the part H d of the displacement d = x - X away (HighPass). Vertices on and beyond
/// the clamps do not move.
class MeshFilter {
public:
    /// `rate` is that of the shortest waves (1/time).
    MeshFilter(const Tube& tube, Real rate);

    /// Adds the velocity -rate H d at the moving vertices; a step dt removes at most all of H d.
    void add_velocity(WallState& wall, Real dt);

private:
    const Tube* tube_;
    Real rate_;
    HighPass high_pass_;
};

} // namespace starling
