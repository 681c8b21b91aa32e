#include "wall/wall_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

using Elements = std::vector<std::array<VertexIndex, 3>>;

/// A strip of two triangles: side 0 of the first is side 2 of the second.
Elements two_triangles() { return {{0, 1, 2}, {2, 1, 3}}; }

std::pair<VertexIndex, VertexIndex> side(const WallMesh& mesh, ElementIndex e, std::size_t k)
{
    return {mesh.element(e)[(k + 1) % 3], mesh.element(e)[(k + 2) % 3]};
}

TEST(WallMesh, KnowsTheElementAcrossASide)
{
    const WallMesh mesh(4, two_triangles());
    EXPECT_EQ(mesh.neighbour(0, 0), 1);
    EXPECT_EQ(mesh.neighbour(1, 2), 0);
    for (int k : {1, 2}) EXPECT_EQ(mesh.neighbour(0, k), -1);
    for (int k : {0, 1}) EXPECT_EQ(mesh.neighbour(1, k), -1);
}

TEST(WallMesh, NeighboursShareTheirSideInOppositeDirections)
{
    const Tube tube = make_tube(support::short_tube(), 0.3);
    const WallMesh& mesh = tube.mesh;
    Index boundary_sides = 0;
    for (ElementIndex e = 0; e < mesh.element_count(); ++e)
        for (int k = 0; k < 3; ++k) {
            const ElementIndex other = mesh.neighbour(e, k);
            if (other < 0) {
                ++boundary_sides;
                continue;
            }
            const auto [a, b] = side(mesh, e, static_cast<std::size_t>(k));
            int found = 0;
            for (int m = 0; m < 3; ++m)
                if (mesh.neighbour(other, m) == e) {
                    ++found;
                    EXPECT_EQ(side(mesh, other, static_cast<std::size_t>(m)), (std::pair{b, a}));
                }
            EXPECT_EQ(found, 1);
        }
    EXPECT_EQ(boundary_sides, 2 * tube.ring_size);
}

TEST(WallMesh, ListsEveryCornerOnceInAscendingElements)
{
    const Tube tube = make_tube(support::short_tube(), 0.3);
    Index corners = 0;
    for (VertexIndex v = 0; v < tube.mesh.vertex_count(); ++v) {
        const Corner *begin = tube.mesh.corners_begin(v), *end = tube.mesh.corners_end(v);
        corners += end - begin;
        for (const Corner* c = begin; c != end; ++c)
            EXPECT_EQ(tube.mesh.element(c->element)[static_cast<std::size_t>(c->corner)], v);
        EXPECT_TRUE(std::is_sorted(
            begin, end, [](const Corner& a, const Corner& b) { return a.element < b.element; }));
    }
    EXPECT_EQ(corners, 3 * tube.mesh.element_count());
}

TEST(WallMesh, OpenTubeHasEulerCharacteristicZero)
{
    const Tube tube = make_tube(support::short_tube(), 0.25);
    std::set<std::pair<VertexIndex, VertexIndex>> edges;
    for (ElementIndex e = 0; e < tube.mesh.element_count(); ++e)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] = side(tube.mesh, e, k);
            edges.insert(std::minmax(a, b));
        }
    EXPECT_EQ(
        tube.mesh.vertex_count() - static_cast<Index>(edges.size()) + tube.mesh.element_count(), 0);
}

TEST(WallMesh, RefusesTwoElementsAlongAnEdgeInTheSameDirection)
{
    Elements elements = two_triangles();
    std::swap(elements[1][0], elements[1][1]);
    EXPECT_THROW(WallMesh(4, elements), std::invalid_argument);
}

TEST(WallMesh, RefusesThreeElementsOnAnEdge)
{
    EXPECT_THROW(WallMesh(5, {{0, 1, 2}, {2, 1, 3}, {2, 1, 4}}), std::invalid_argument);
    EXPECT_THROW(WallMesh(5, {{0, 1, 2}, {1, 2, 3}, {2, 1, 4}}), std::invalid_argument);
}

} // namespace
} // namespace starling
