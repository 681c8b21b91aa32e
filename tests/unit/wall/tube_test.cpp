#include "wall/tube.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/wall/shapes.hpp"
#include "wall/geometry.hpp"

namespace starling {
namespace {

TEST(Tube, HasRingsExactlyOnItsEndsAndClamps)
{
    for (Real edge : {0.07, 0.13, 0.31, 0.5}) {
        const TubeParameters p{.length = 4.3, .rigid_inlet = 1.18, .rigid_outlet = 0.39};
        const Tube tube = make_tube(p, edge);
        EXPECT_EQ(tube.ring_x.front(), 0);
        EXPECT_EQ(tube.ring_x.back(), p.length);
        EXPECT_EQ(tube.x_clamp_in(), p.rigid_inlet);
        EXPECT_EQ(tube.x_clamp_out(), p.length - p.rigid_outlet);
    }
}

TEST(Tube, NumbersVerticesRingByRingWithAscendingX)
{
    const Tube tube = make_tube(support::short_tube(), 0.2);
    EXPECT_EQ(tube.ring_size % 2, 0);
    EXPECT_EQ(static_cast<Index>(tube.X.size()), tube.rings() * tube.ring_size);
    EXPECT_TRUE(std::is_sorted(tube.ring_x.begin(), tube.ring_x.end()));
    EXPECT_EQ(std::adjacent_find(tube.ring_x.begin(), tube.ring_x.end()), tube.ring_x.end());
    for (Index ring = 0; ring < tube.rings(); ++ring)
        for (VertexIndex v = tube.first(ring); v < tube.first(ring + 1); ++v) {
            const Vec3& X = tube.X[static_cast<std::size_t>(v)];
            EXPECT_EQ(X.x, tube.ring_x[static_cast<std::size_t>(ring)]);
            EXPECT_NEAR(std::hypot(X.y, X.z), 1, 1e-15);
        }
}

TEST(Tube, TrianglesAreNearEquilateral)
{
    for (Real edge : {0.06, 0.1, 0.2}) {
        const Tube tube = make_tube({}, edge);
        for (const auto& element : tube.mesh.elements())
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& a = tube.X[static_cast<std::size_t>(element[k])];
                const Vec3& b = tube.X[static_cast<std::size_t>(element[(k + 1) % 3])];
                EXPECT_NEAR(norm(b - a) / edge, 1, 0.15) << "edge " << edge;
            }
    }
}

TEST(Tube, NormalsPointOutwards)
{
    const Tube tube = make_tube(support::short_tube(), 0.2);
    Geometry geometry(tube.mesh);
    geometry.update(WallState(tube).x);
    for (ElementIndex e = 0; e < tube.mesh.element_count(); ++e) {
        const Vec3& a = tube.X[static_cast<std::size_t>(tube.mesh.element(e)[0])];
        const Vec3& area = geometry.element_area()[e];
        EXPECT_GT(a.y * area.y + a.z * area.z, 0.95 * norm(area));
    }
}

TEST(Tube, OnlyRingsStrictlyBetweenTheClampsMove)
{
    const Tube tube = make_tube(support::short_tube(), 0.2);
    for (VertexIndex v = 0; v < tube.mesh.vertex_count(); ++v) {
        const Real x = tube.X[static_cast<std::size_t>(v)].x;
        const bool moves = v >= tube.moving_begin() && v < tube.moving_end();
        EXPECT_EQ(moves, x > tube.x_clamp_in() && x < tube.x_clamp_out());
    }
}

TEST(Tube, RigidTubeHasNoMovingVertices)
{
    const Tube tube = make_tube({.length = 3, .rigid = true}, 0.2);
    EXPECT_EQ(tube.moving_begin(), tube.moving_end());
    EXPECT_EQ(tube.x_clamp_in(), 3);
    EXPECT_EQ(tube.x_clamp_out(), 3);
}

TEST(Tube, WithoutARigidPartHasNoDoubledRing)
{
    for (const auto& [inlet, outlet] : {std::pair{0., 0.5}, {0.5, 0.}, {0., 0.}}) {
        const Tube tube =
            make_tube({.length = 3, .rigid_inlet = inlet, .rigid_outlet = outlet}, 0.2);
        for (std::size_t r = 1; r < tube.ring_x.size(); ++r)
            EXPECT_GT(tube.ring_x[r], tube.ring_x[r - 1] + 0.1) << inlet << " " << outlet;
        EXPECT_EQ(tube.x_clamp_in(), inlet);
        EXPECT_EQ(tube.x_clamp_out(), 3 - outlet);
    }
}

} // namespace
} // namespace starling
