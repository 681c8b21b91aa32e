#pragma once
/// Removes the shortest waves of the wall's displacement, which the fluid cannot see.
#include "wall/geometry.hpp"
#include "wall/high_pass.hpp"
#include "wall/wall_state.hpp"

namespace starling {

/// The wall carries waves between neighbouring vertices that are shorter than two grid spacings;
/// interpolation and spreading do not see them, so nothing restores them once they are there. The
/// filter takes the part H d of the displacement d = x - X away (HighPass). Waves around a ring
/// that are folds of the tube lose volume with it, or gain it: that is given back along the normal.
/// Vertices on and beyond the clamps do not move.
class MeshFilter {
public:
    /// `rate` is that of the shortest waves (1/time).
    MeshFilter(const Tube& tube, Real rate);

    /// Adds the velocity -rate (H d - c A) at the moving vertices, A the vertex area vector and c
    /// of each ring such that waves around the ring move no volume; a step dt removes at most all
    /// of H d. Geometry must be that of the wall's positions.
    void add_velocity(const Geometry& geometry, WallState& wall, Real dt);

private:
    void find_volume_back(const Geometry& geometry);

    const Tube* tube_;
    Real rate_;
    HighPass high_pass_;
    Array<Real> back_; ///< c per moving ring
};

} // namespace starling
