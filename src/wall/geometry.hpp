#pragma once
/// Normals, areas and the enclosed volume of the deformed wall.
#include "core/array.hpp"
#include "wall/wall_state.hpp"

namespace starling {

/// Area vectors of elements and vertices. The area vector of a vertex, a third of those of its
/// elements, is the exact derivative of the enclosed volume with respect to its position.
class Geometry {
public:
    explicit Geometry(const WallMesh& mesh);

    /// Recomputes everything for the positions x.
    void update(const Array<Vec3>& x);

    /// Outward area vector of an element (norm = area).
    const Array<Vec3>& element_area() const { return element_area_; }
    /// Outward area vector of a vertex.
    const Array<Vec3>& vertex_area() const { return vertex_area_; }

private:
    const WallMesh* mesh_;
    Array<Vec3> element_area_, vertex_area_;
};

/// Volume enclosed by a tube and the flat lids on its first and last ring, which lie in planes of
/// constant x.
Real enclosed_volume(const Tube& tube, const Array<Vec3>& x);

/// Volume enclosed between the first ring and each ring.
std::vector<Real> volume_up_to_rings(const Tube& tube, const Array<Vec3>& x);

/// Signed area in the y-z plane of the polygon through the vertices of a ring.
Real ring_area(const Tube& tube, const Array<Vec3>& x, Index ring);

} // namespace starling
