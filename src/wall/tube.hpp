#pragma once
/// The undeformed tube: rings of vertices, staggered so that the triangles are near-equilateral.
#include <algorithm>

#include "wall/wall_mesh.hpp"
#include "wall/wall_parameters.hpp"

namespace starling {

/// Rings [begin, end).
struct RingRange {
    Index begin = 0, end = 0;
};

/// A triangulated tube about the x axis, of radius 1 but where the rest radius varies. Vertices are
/// numbered ring by ring with ascending x: vertex = ring * ring_size + position. Vertices never
/// leave their x.
struct Tube {
    WallMesh mesh;
    std::vector<Vec3> X;               ///< undeformed positions
    std::vector<Real> ring_x;          ///< x of each ring; a ring lies exactly on each clamp
    std::vector<Real> ring_radius;     ///< undeformed radius of each ring
    VertexIndex ring_size = 0;         ///< vertices per ring, even
    Index clamp_in = 0, clamp_out = 0; ///< rings on the clamps; rings strictly between may move

    Index rings() const { return static_cast<Index>(ring_x.size()); }
    VertexIndex first(Index ring) const { return static_cast<VertexIndex>(ring) * ring_size; }
    /// Whether any vertex may move.
    bool deforms() const { return clamp_out > clamp_in + 1; }
    /// Range of vertices that may move (empty for a rigid tube).
    VertexIndex moving_begin() const { return first(clamp_in + 1); }
    VertexIndex moving_end() const { return std::max(moving_begin(), first(clamp_out)); }
    RingRange moving_rings() const { return {clamp_in + 1, std::max(clamp_in + 1, clamp_out)}; }
    Real x_clamp_in() const { return ring_x[static_cast<std::size_t>(clamp_in)]; }
    Real x_clamp_out() const { return ring_x[static_cast<std::size_t>(clamp_out)]; }
};

/// Makes the tube with triangle edges of about `edge` (R_0). A rigid tube has both clamps on its
/// last ring.
Tube make_tube(const TubeParameters& p, Real edge);

} // namespace starling
