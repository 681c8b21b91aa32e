#include "wall/wall_mesh.hpp"

#include <stdexcept>

namespace starling {

WallMesh::WallMesh(VertexIndex vertices, std::vector<std::array<VertexIndex, 3>> elements)
    : vertex_count_(vertices), elements_(std::move(elements))
{
    collect_corners();
    connect_neighbours();
}

void WallMesh::collect_corners()
{
    corner_begin_.assign(static_cast<std::size_t>(vertex_count_) + 1, 0);
    for (const auto& element : elements_)
        for (VertexIndex v : element) ++corner_begin_[static_cast<std::size_t>(v) + 1];
    for (std::size_t v = 1; v < corner_begin_.size(); ++v) corner_begin_[v] += corner_begin_[v - 1];

    corners_.resize(3 * elements_.size());
    std::vector<std::size_t> next(corner_begin_.begin(), corner_begin_.end() - 1);
    for (ElementIndex e = 0; e < element_count(); ++e)
        for (std::int32_t c = 0; c < 3; ++c)
            corners_[next[static_cast<std::size_t>(element(e)[static_cast<std::size_t>(c)])]++] = {
                e, c};
}

void WallMesh::connect_neighbours()
{
    neighbours_.assign(elements_.size(), {-1, -1, -1});
    for (ElementIndex e = 0; e < element_count(); ++e)
        for (std::size_t k = 0; k < 3; ++k) {
            const VertexIndex a = element(e)[(k + 1) % 3], b = element(e)[(k + 2) % 3];
            for (const Corner* c = corners_begin(a); c != corners_end(a); ++c) {
                const auto& other = element(c->element);
                const auto corner = static_cast<std::size_t>(c->corner);
                if (c->element == e) continue;
                if (other[(corner + 1) % 3] == b)
                    throw std::invalid_argument("wall mesh: two elements run along one edge in the "
                                                "same direction");
                if (other[(corner + 2) % 3] != b) continue;
                auto& neighbour = neighbours_[static_cast<std::size_t>(e)][k];
                if (neighbour >= 0)
                    throw std::invalid_argument("wall mesh: more than two elements on an edge");
                neighbour = c->element;
            }
        }
}

} // namespace starling
