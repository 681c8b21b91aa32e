#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "report/flow_plane.hpp"

namespace starling::report {
namespace {

constexpr std::array<std::size_t, 3> cells = {6, 8, 10};
constexpr Vec3 origin = {0, -2, -2}, spacing = {0.5, 0.5, 0.4};

/// velocity (x + y + 10 z, y, z), pressure x: linear, so that means over layers are exact.
FluidFrame linear_flow(std::array<std::size_t, 3> n = cells)
{
    FluidFrame frame{{"fluid", 0, 0, "s"}, n, origin, spacing, "m", {}};
    FrameArray p{"pressure", "Pa", {n[2], n[1], n[0]}, 1, {}};
    FrameArray u{"velocity", "m/s", p.shape, 3, {}};
    for (std::size_t k = 0; k < n[2]; ++k)
        for (std::size_t j = 0; j < n[1]; ++j)
            for (std::size_t i = 0; i < n[0]; ++i) {
                const Real x = origin.x + spacing.x * (static_cast<Real>(i) + 0.5);
                const Real y = origin.y + spacing.y * (static_cast<Real>(j) + 0.5);
                const Real z = origin.z + spacing.z * (static_cast<Real>(k) + 0.5);
                p.values.push_back(x);
                for (const Real value : {x + y + 10 * z, y, z}) u.values.push_back(value);
            }
    frame.at_cell = {p, u};
    return frame;
}

/// Rings of a circular cylinder about the x axis.
FrameArray cylinder(Real radius)
{
    FrameArray points{"points", "m", {}, 3, {}};
    for (Real x = 0; x < 3.01; x += 0.25)
        for (int n = 0; n < 64; ++n)
            for (const Real value :
                 {x, radius * std::cos(n * pi / 32), radius * std::sin(n * pi / 32)})
                points.values.push_back(value);
    points.shape = {points.values.size() / 3};
    return points;
}

TEST(FlowPlane, LiesOnTheAxisAndIsExactForLinearFlow)
{
    const FlowPlane plane = plane_through_axis(linear_flow(), nullptr);
    EXPECT_EQ(plane.normal, 2);
    EXPECT_NEAR(plane.origin.z, 0, 1e-12);
    ASSERT_EQ(plane.cells, (std::array<std::size_t, 2>{6, 8}));
    const std::size_t at = 3 * 6 + 4; // x = 2.25, y = -0.25
    EXPECT_NEAR(plane.axial_velocity[at], 2.0, 1e-12);
    EXPECT_NEAR(plane.speed[at], std::hypot(2.0, 0.25), 1e-12);
    EXPECT_NEAR(plane.pressure[at], 2.25, 1e-12);
    EXPECT_EQ(plane.unit_of_pressure, "Pa");
}

TEST(FlowPlane, TakesASingleLayerAsItIs)
{
    const FlowPlane plane = plane_through_axis(linear_flow({6, 1, 10}), nullptr);
    EXPECT_EQ(plane.normal, 1);
    EXPECT_NEAR(plane.origin.y, -1.75, 1e-12); // the middle of the layer
    ASSERT_EQ(plane.cells, (std::array<std::size_t, 2>{6, 10}));
    EXPECT_NEAR(plane.axial_velocity[2 * 6 + 1], 0.75 - 1.75 - 10, 1e-12);
}

TEST(FlowPlane, IsBlankOutsideTheWall)
{
    const FrameArray wall = cylinder(1.1);
    const FlowPlane plane = plane_through_axis(linear_flow(), &wall);
    for (std::size_t n = 0; n < plane.speed.size(); ++n) {
        const Real y = -1.75 + 0.5 * static_cast<Real>(n / 6);
        EXPECT_EQ(std::isnan(plane.pressure[n]), std::abs(y) > 1.1) << "y = " << y;
    }
}

TEST(FlowPlane, KeepsToTheLayerThatHoldsNumbers)
{
    FluidFrame frame = linear_flow();
    for (std::size_t n = 0; n < 8 * 6; ++n) // the layer above the axis
        frame.at_cell[0].values[5 * 8 * 6 + n] = std::nan("");
    EXPECT_NEAR(plane_through_axis(frame, nullptr).pressure[4], 2.25, 1e-12);
}

TEST(FlowPlane, RefusesFramesWithoutVelocity)
{
    FluidFrame frame = linear_flow();
    frame.at_cell.pop_back();
    EXPECT_THROW(plane_through_axis(frame, nullptr), InputError);
}

TEST(Rings, ContainWhatIsInsideALobe)
{
    FrameArray points = cylinder(1);
    for (std::size_t v = 0; v < points.count(); ++v) { // three lobes, the first along y
        const Real theta = static_cast<Real>(v % 64) * pi / 32;
        const Real radius = 1 + 0.5 * std::cos(3 * theta);
        points.values[3 * v + 1] *= radius;
        points.values[3 * v + 2] *= radius;
    }
    const Rings rings(points);
    EXPECT_EQ(rings.count(), 13u);
    EXPECT_TRUE(rings.contains({1.3, 1.4, 0}));
    EXPECT_TRUE(rings.contains({1.3, -0.4, 0}));
    EXPECT_FALSE(rings.contains({1.3, -0.6, 0})); // between the other two
    EXPECT_FALSE(rings.contains({1.3, 1.6, 0}));
}

} // namespace
} // namespace starling::report
