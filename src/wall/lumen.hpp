#pragma once
/// Shape of the tube's cross-sections: how wide, how many lobes, whether walls meet. A section is
/// the polygon of a ring of vertices, which keeps its x.
#include <array>

#include "core/array.hpp"
#include "wall/tube.hpp"

namespace starling {

/// No wall opposite.
inline constexpr Real no_gap = 1e30;

/// Distance across the lumen from corner a of the polygon p of n corners, along its inner normal,
/// to the wall opposite; no_gap where that is turned away by more than about 18 degrees from
/// facing the corner: the end of a fold.
Real lumen_width(const Vec3* p, VertexIndex n, VertexIndex a);

/// Smallest lumen width of a ring, and of all rings.
Real smallest_gap(const Tube& tube, const Array<Vec3>& x, Index ring);
Real smallest_gap(const Tube& tube, const Array<Vec3>& x);

/// Whether two sides of a ring's polygon cross: the wall has gone through itself.
bool crosses_itself(const Tube& tube, const Array<Vec3>& x, Index ring);

/// Modes of a ring's radius, as a function of the angle at which its vertices stand undeformed.
struct RadiusModes {
    static constexpr std::size_t count = 13;
    std::array<Real, count> amplitude{}; ///< of cos and sin(n theta), n = 0..12 (R_0)

    /// n >= 2 of the largest amplitude; 0 if that is below a hundredth of the radius.
    Index lobes() const;
};
RadiusModes radius_modes(const Tube& tube, const Array<Vec3>& x, Index ring);

} // namespace starling
