#include "immersed_boundary/section_flow.hpp"

#include <gtest/gtest.h>

#include "unit/grid/random_fields.hpp"
#include "unit/immersed_boundary/boxed_tube.hpp"
#include "unit/immersed_boundary/wall_shapes.hpp"

namespace starling {
namespace {

using support::BoxedTube;

template <class F>
ScalarField axial_velocity(const Grid& g, F f)
{
    ScalarField u(g);
    support::visit(
        {{-1, -1, -1}, {g.nx() + 2, g.ny() + 1, g.nz() + 1}},
        [&](Index i, Index j, Index k) { u(i, j, k) = f(g.position(Location::u, i, j, k)); });
    return u;
}

struct AnySection : testing::TestWithParam<support::Shape> {
    BoxedTube stage{0.2};
    SectionFlow flow{stage.g, stage.tube};
    CrossSection section{stage.tube};

    AnySection() { stage.place(support::positions(stage.tube, GetParam())); }
};

TEST_P(AnySection, UniformVelocityGivesTheArea)
{
    const ScalarField u = axial_velocity(stage.g, [](const Vec3&) { return 1.; });
    for (Index i = 0; i <= stage.g.nx(); ++i) {
        section.cut(stage.wall.x, stage.g.x(Location::u, i));
        EXPECT_NEAR(flow.inside(u, stage.wall.x, i) / section.area(), 1, 2e-3) << i;
    }
}

TEST_P(AnySection, LinearVelocityGivesTheFirstMomentOfTheArea)
{
    // Green: integral of y = sum over sides of (y_a^2 + y_a y_b + y_b^2)(z_b - z_a)/6
    const ScalarField u = axial_velocity(stage.g, [](const Vec3& p) { return 3 + p.y; });
    for (Index i = 0; i <= stage.g.nx(); ++i) {
        section.cut(stage.wall.x, stage.g.x(Location::u, i));
        const auto& points = section.points();
        Real moment = 0;
        for (std::size_t m = 0; m < points.size(); ++m) {
            const Point2 &a = points[m], &b = points[(m + 1) % points.size()];
            moment += (a.y * a.y + a.y * b.y + b.y * b.y) * (b.z - a.z) / 6;
        }
        EXPECT_NEAR(flow.inside(u, stage.wall.x, i) / (3 * section.area() + moment), 1, 3e-3) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(SectionFlow, AnySection, testing::ValuesIn(support::all_shapes()),
                         support::shape_name);

/// Relative error of the flow rate of 2 (1 - r^2), continued oddly, in the section half-way.
Real poiseuille_error(Real spacing)
{
    BoxedTube stage(spacing);
    const ScalarField u = axial_velocity(stage.g, [](const Vec3& p) {
        const Real r = std::hypot(p.y, p.z);
        return r < 1 ? 1 - r * r : -1 + (2 - r) * (2 - r);
    });
    return SectionFlow(stage.g, stage.tube).inside(u, stage.wall.x, stage.g.nx() / 2) / (pi / 2) -
           1;
}

TEST(SectionFlow, OddlyContinuedPoiseuilleFlowConvergesAtSecondOrder)
{
    for (Real spacing : {0.25, 0.2, 0.125, 0.1, 0.05}) {
        const Real constant = poiseuille_error(spacing) / (spacing * spacing);
        EXPECT_LT(std::abs(constant), 0.4) << spacing;
        RecordProperty("constant_at_" + std::to_string(spacing), std::to_string(constant));
    }
}

TEST(SectionFlow, TotalIsTheSumOverAllFaces)
{
    BoxedTube stage(0.25);
    const ScalarField u = axial_velocity(stage.g, [](const Vec3& p) { return 2 + p.x; });
    const Vec3 size = stage.g.lengths();
    for (Index i : {Index{0}, Index{3}, stage.g.nx()})
        EXPECT_NEAR(SectionFlow(stage.g, stage.tube).total(u, i),
                    (2 + stage.g.x(Location::u, i)) * size.y * size.z, 1e-12);
}

TEST(SectionFlow, InsideAndOutsideMakeTheTotal)
{
    // a velocity that jumps to zero well outside the wall, and one that is zero inside
    BoxedTube stage(0.2);
    SectionFlow flow(stage.g, stage.tube);
    const Index i = stage.g.nx() / 2;
    const auto step = [](const Vec3& p) { return std::hypot(p.y, p.z) < 1.5 ? 1. : 0.; };
    const ScalarField near = axial_velocity(stage.g, step);
    const ScalarField far = axial_velocity(stage.g, [=](const Vec3& p) { return 1 - step(p); });
    EXPECT_EQ(flow.inside(far, stage.wall.x, i), 0);
    EXPECT_NEAR(flow.total(near, i) + flow.total(far, i), 5.1 * 5, 1e-12);
    EXPECT_NEAR(flow.inside(near, stage.wall.x, i), pi, 0.01);
}

TEST(InterpolateAt, IsExactForTrilinearFields)
{
    const Grid g = support::box_around(0.4);
    const auto f = [](const Vec3& p) { return (1 + p.x) * (2 - p.y) * (3 + 2 * p.z); };
    support::Random random;
    for (Location where : {Location::u, Location::v, Location::w, Location::cell}) {
        ScalarField field(g);
        support::visit(
            {{-1, -1, -1}, {g.nx() + 2, g.ny() + 1, g.nz() + 1}},
            [&](Index i, Index j, Index k) { field(i, j, k) = f(g.position(where, i, j, k)); });
        for (int n = 0; n < 100; ++n) {
            const Vec3 p{2 + 2 * random(), 2.2 * random(), 2.2 * random()};
            EXPECT_NEAR(interpolate_at(g, where, field, p), f(p), 1e-12);
        }
    }
}

} // namespace
} // namespace starling
