#include "wall/cross_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/wall/shapes.hpp"
#include "wall/geometry.hpp"

namespace starling {
namespace {

struct Section : testing::Test {
    Tube tube = make_tube(support::short_tube(), 0.3);
    Array<Vec3> x = support::positions(tube, support::random_smooth(2, 0.3));
    CrossSection section{tube};

    Real area_at(Real plane_x)
    {
        section.cut(x, plane_x);
        return section.area();
    }
    /// Area of the three triangles p makes with the sides of an element less the element's own:
    /// zero if p lies in the element.
    Real excess(ElementIndex e, const Vec3& p) const
    {
        const auto& [ia, ib, ic] = tube.mesh.element(e);
        const Vec3 a = x[ia] - p, b = x[ib] - p, c = x[ic] - p;
        return (norm(cross(a, b)) + norm(cross(b, c)) + norm(cross(c, a)) -
                norm(cross(b - a, c - a))) /
               2;
    }
};

TEST_F(Section, AreaAtARingIsThatOfTheRing)
{
    for (Index ring = 0; ring < tube.rings(); ++ring)
        EXPECT_NEAR(area_at(tube.ring_x[static_cast<std::size_t>(ring)]), ring_area(tube, x, ring),
                    1e-13);
}

TEST_F(Section, AreasIntegrateToTheVolume)
{
    // between rings the area is quadratic in x: Simpson's rule is exact
    Real volume = 0;
    for (std::size_t r = 0; r + 1 < tube.ring_x.size(); ++r) {
        const Real a = tube.ring_x[r], b = tube.ring_x[r + 1];
        volume += (b - a) / 6 * (area_at(a) + 4 * area_at((a + b) / 2) + area_at(b));
    }
    EXPECT_NEAR(volume, enclosed_volume(tube, x), 1e-12);
}

TEST_F(Section, SegmentLiesInItsElement)
{
    for (Real plane_x = 0.01; plane_x < 4; plane_x += 0.137) {
        section.cut(x, plane_x);
        const auto& points = section.points();
        for (std::size_t m = 0; m < points.size(); ++m) {
            const auto e = section.first_element() + static_cast<ElementIndex>(m);
            for (const Point2& q : {points[m], points[(m + 1) % points.size()]})
                ASSERT_NEAR(excess(e, {plane_x, q.y, q.z}), 0, 1e-13) << plane_x << " " << m;
        }
    }
}

TEST_F(Section, PlanesBeyondTheEndsGiveTheEnds)
{
    EXPECT_NEAR(area_at(-1), ring_area(tube, x, 0), 1e-13);
    EXPECT_NEAR(area_at(5), ring_area(tube, x, tube.rings() - 1), 1e-13);
}

TEST_F(Section, CrossingsBoundTheInside)
{
    // the lengths of the inner intervals integrate to the area
    x = support::positions(tube, support::lobed(3, 0.6));
    section.cut(x, 2.1);
    const Real h = 1e-4;
    Real area = 0;
    std::size_t most = 0;
    for (Real y = -2 + h / 2; y < 2; y += h) {
        const auto& z = section.crossings(y);
        ASSERT_EQ(z.size() % 2, 0u);
        ASSERT_TRUE(std::is_sorted(z.begin(), z.end()));
        most = std::max(most, z.size());
        for (std::size_t n = 0; n < z.size(); n += 2) area += h * (z[n + 1] - z[n]);
    }
    EXPECT_NEAR(area, section.area(), 1e-6);
    EXPECT_EQ(most, 4u) << "the shape should not be convex";
}

TEST_F(Section, CrossingsOfAWallThatIsNotFiniteAreNone)
{
    for (const Real bad : {std::nan(""), HUGE_VAL}) {
        x = support::positions(tube, support::random_smooth(2, 0.3));
        section.cut(x, 2.1);
        ASSERT_EQ(section.crossings(0).size(), 2U);
        for (VertexIndex v = 0; v < x.size(); ++v) (v % 2 ? x[v].y : x[v].z) = bad;
        section.cut(x, 2.1);
        for (const Real y : {-0.5, 0., 0.5}) EXPECT_TRUE(section.crossings(y).empty());
    }
}

} // namespace
} // namespace starling
