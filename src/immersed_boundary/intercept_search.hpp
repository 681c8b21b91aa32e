#pragma once
/// Boundary intercepts: the point of the wall nearest to a grid node, found by walking over the
/// elements.
#include "core/array.hpp"
#include "wall/geometry.hpp"

namespace starling {

/// Where the normal probe of a node meets the wall.
struct Intercept {
    ElementIndex element = 0; ///< intercept element (IE)
    Vec3 point;               ///< boundary intercept (BI)
    Real squared_distance = 0;
    bool outside = false; ///< the node lies on the outer side of the wall
};

/// From the intercept of the node at p to p, turned outward if p lies on the inner side.
inline Vec3 outward_from_intercept(const Vec3& p, const Intercept& i)
{
    return (i.outside ? 1.0 : -1.0) * (p - i.point);
}

/// The wall at one time, as the search sees it. Holds references: positions and geometry must
/// outlive it and be up to date.
class InterceptSearch {
public:
    InterceptSearch(const WallMesh& mesh, const Array<Vec3>& x, const Geometry& geometry)
        : mesh_(&mesh), x_(&x), geometry_(&geometry)
    {
    }

    /// Walks from element `start` to the intercept of p (Fig. 4): in each element the nearest point
    /// lies inside it (done), on a side (go on with the element across), or on a corner (go on with
    /// the nearest element around it).
    /// Deviation: the paper goes by the signs of s_k . e_k and stops when elements repeat; here a
    /// step must come strictly nearer, so the walk always ends, and ends on the side or corner
    /// itself where no element's projected volume holds the node. Where several intercepts exist
    /// (a fold), the first one reached is taken.
    Intercept walk(const Vec3& p, ElementIndex start) const;

    /// The nearest intercept of all elements: slow, for tests.
    Intercept brute_force(const Vec3& p) const;

private:
    struct Nearest;
    Nearest nearest_in(ElementIndex e, const Vec3& p) const;
    Intercept finish(const Nearest& nearest, const Vec3& p) const;
    Vec3 pseudo_normal(const Nearest& nearest) const;
    Vec3 corner_normal(VertexIndex v) const;

    const WallMesh* mesh_;
    const Array<Vec3>* x_;
    const Geometry* geometry_;
};

} // namespace starling
