#pragma once
/// The shortest waves of values at the vertices of the wall.
#include "core/array.hpp"
#include "wall/wall_mesh.hpp"

namespace starling {

/// The part of a vector across x.
struct Across {
    Real y, z;
};

/// The operator H = (L/1.5)^4, L d = d - mean of d over the neighbours, on a range of vertices. Its
/// response is at most 1: about 1 at the shortest waves of the mesh and falling with the eighth
/// power of the wave number.
class HighPass {
public:
    /// How neighbours count that are not in the range.
    enum class Beyond { as_zero, not_at_all };

    /// Over the vertices first <= v < last.
    HighPass(const WallMesh& mesh, VertexIndex first, VertexIndex last, Beyond beyond);

    VertexIndex first() const { return first_; }
    VertexIndex last() const { return first_ + static_cast<VertexIndex>(values_.size()); }
    /// The values to be filtered; value of vertex v at [v - first()].
    Across* values() { return values_.data(); }
    /// values = H values.
    void apply();

private:
    void apply_once(const Array<Across>& from, Array<Across>& to) const;

    VertexIndex first_;
    std::vector<std::size_t> begin_;      ///< of a vertex's neighbours
    std::vector<VertexIndex> neighbours_; ///< those in the range, from first_
    std::vector<Real> share_;             ///< of a neighbour in the mean
    Array<Across> values_, other_;
};

} // namespace starling
