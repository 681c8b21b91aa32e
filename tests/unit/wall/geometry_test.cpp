#include "wall/geometry.hpp"

#include <gtest/gtest.h>

#include <omp.h>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

/// Area of the regular polygon with n corners on a circle of radius r.
Real polygon_area(Real n, Real r = 1) { return n / 2 * r * r * std::sin(2 * pi / n); }

TEST(Geometry, AreaVectorOfAMovingVertexIsTheGradientOfTheVolume)
{
    const Tube tube = make_tube(support::short_tube(), 0.5);
    Array<Vec3> x = support::positions(tube, support::random_smooth(3, 0.3));
    support::shake(tube, x, 0.05);
    Geometry geometry(tube.mesh);
    geometry.update(x);
    // the volume is linear in every single coordinate: differences are exact for any step
    const Real h = 0.1;
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v)
        for (const Vec3& e : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
            const Vec3 before = x[v];
            x[v] = before + h * e;
            const Real up = enclosed_volume(tube, x);
            x[v] = before - h * e;
            const Real down = enclosed_volume(tube, x);
            x[v] = before;
            EXPECT_NEAR(dot(geometry.vertex_area()[v], e), (up - down) / (2 * h), 1e-12);
        }
}

TEST(Geometry, AreaVectorsOfElementsAndVerticesHaveTheSameSum)
{
    const Tube tube = make_tube(support::short_tube(), 0.3);
    Geometry geometry(tube.mesh);
    geometry.update(support::positions(tube, support::random_smooth(4, 0.3)));
    Vec3 difference;
    for (const Vec3& a : geometry.element_area()) difference += a;
    for (const Vec3& a : geometry.vertex_area()) difference -= a;
    EXPECT_LT(norm(difference), 1e-13);
}

TEST(Geometry, RingAreaIsThatOfARegularPolygon)
{
    const Tube tube = make_tube(support::short_tube(), 0.3);
    for (Index ring = 0; ring < tube.rings(); ++ring)
        EXPECT_NEAR(ring_area(tube, WallState(tube).x, ring), polygon_area(tube.ring_size), 1e-13);
}

// Between two rings the section is a polygon of 2n corners; its area is quadratic in x, so
// Simpson's rule over rings and half-way section is exact.
TEST(Geometry, VolumeOfTheUndeformedTubeIsThatOfItsAntiprisms)
{
    const TubeParameters p = support::short_tube();
    const Tube tube = make_tube(p, 0.3);
    const Real n = tube.ring_size, half_way = polygon_area(2 * n, std::cos(pi / (2 * n)));
    EXPECT_NEAR(enclosed_volume(tube, WallState(tube).x),
                p.length * (polygon_area(n) + 2 * half_way) / 3, 1e-12);
}

TEST(Geometry, VolumeUpToRingsIsThatOfTheTubesThatEndThere)
{
    const Tube tube = make_tube(support::short_tube(), 0.3);
    const Array<Vec3> x = support::positions(tube, support::random_smooth(3, 0.3));
    const std::vector<Real> volume = volume_up_to_rings(tube, x);
    ASSERT_EQ(volume.size(), static_cast<std::size_t>(tube.rings()));
    EXPECT_EQ(volume.front(), 0);
    EXPECT_NEAR(volume.back(), enclosed_volume(tube, x), 1e-12);
    // up to a ring in the rigid part, whose section does not change
    const Real step = tube.ring_x[1] - tube.ring_x[0], n = tube.ring_size;
    const Real half_way = polygon_area(2 * n, std::cos(pi / (2 * n)));
    EXPECT_NEAR(volume[1], step * (polygon_area(n) + 2 * half_way) / 3, 1e-12);
}

TEST(Geometry, VolumeConvergesToThatOfTheCylinder)
{
    const auto error = [](Real edge) {
        const Tube tube = make_tube(support::short_tube(), edge);
        return 4 * pi - enclosed_volume(tube, WallState(tube).x);
    };
    EXPECT_NEAR(error(0.1) / error(0.2), 0.25, 0.02);
}

TEST(Geometry, DoesNotDependOnThreads)
{
    const Tube tube = make_tube(support::short_tube(), 0.2);
    const Array<Vec3> x = support::positions(tube, support::random_smooth(5, 0.3));
    Geometry one(tube.mesh), two(tube.mesh);
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    one.update(x);
    omp_set_num_threads(2);
    two.update(x);
    omp_set_num_threads(before);
    EXPECT_TRUE(std::ranges::equal(one.vertex_area(), two.vertex_area()));
}

} // namespace
} // namespace starling
