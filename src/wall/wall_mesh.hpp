#pragma once
/// Connectivity of the triangulated wall; where its vertices are is not known here.
#include <vector>

#include "core/types.hpp"

namespace starling {

/// One corner of an element.
struct Corner {
    ElementIndex element;
    std::int32_t corner; ///< 0, 1, 2
};

/// An orientable triangle mesh, possibly with boundary. Corners of an element run counter-clockwise
/// seen from outside; side k is opposite corner k.
class WallMesh {
public:
    WallMesh() = default;
    /// Throws std::invalid_argument if an edge has more than two elements or two elements disagree
    /// on its direction.
    WallMesh(VertexIndex vertices, std::vector<std::array<VertexIndex, 3>> elements);

    VertexIndex vertex_count() const { return vertex_count_; }
    ElementIndex element_count() const { return static_cast<ElementIndex>(elements_.size()); }
    const std::vector<std::array<VertexIndex, 3>>& elements() const { return elements_; }
    const std::array<VertexIndex, 3>& element(ElementIndex e) const
    {
        return elements_[static_cast<std::size_t>(e)];
    }
    /// Element across side k, or -1 on the boundary.
    ElementIndex neighbour(ElementIndex e, int side) const
    {
        return neighbours_[static_cast<std::size_t>(e)][static_cast<std::size_t>(side)];
    }
    /// The corners that meet in a vertex, in ascending element order.
    const Corner* corners_begin(VertexIndex v) const
    {
        return corners_.data() + corner_begin_[static_cast<std::size_t>(v)];
    }
    const Corner* corners_end(VertexIndex v) const
    {
        return corners_.data() + corner_begin_[static_cast<std::size_t>(v) + 1];
    }

private:
    void collect_corners();
    void connect_neighbours();

    VertexIndex vertex_count_ = 0;
    std::vector<std::array<VertexIndex, 3>> elements_;
    std::vector<std::array<ElementIndex, 3>> neighbours_;
    std::vector<Corner> corners_;
    std::vector<std::size_t> corner_begin_;
};

} // namespace starling
