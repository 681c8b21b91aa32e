#include "immersed_boundary/section_flow.hpp"

#include <gtest/gtest.h>

#include "immersed_boundary/delta.hpp"
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

TEST_P(AnySection, ReconstructedFlowOfALinearVelocityIsExact)
{
    const ScalarField u =
        axial_velocity(stage.g, [](const Vec3& p) { return 3 + p.y - 0.5 * p.z + 0.2 * p.x; });
    for (Index i = 2; i <= stage.g.nx() - 2; ++i)
        EXPECT_NEAR(flow.reconstructed(u, stage.wall.x, stage.g.x(Location::u, i)) /
                        flow.inside(u, stage.wall.x, i),
                    1, 5e-3)
            << i;
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

/// A smooth flow without divergence in any cell: differences of a potential on the edges.
VectorField smooth_solenoidal_velocity(const Grid& g)
{
    const Vec3 h = g.spacing();
    const auto A_x = [](const Vec3& p) { return std::cos(p.z) * std::sin(1.3 * p.y + 0.4 * p.x); };
    const auto A_z = [](const Vec3& p) { return std::sin(1.2 * p.y + 0.3) * std::sin(1.1 * p.x); };
    VectorField velocity(g);
    for (Location c : components)
        support::visit(
            {{-1, -1, -1}, {g.nx() + 2, g.ny() + 1, g.nz() + 1}}, [&](Index i, Index j, Index k) {
                const Vec3 p = g.position(c, i, j, k);
                const Vec3 x{h.x / 2, 0, 0}, y{0, h.y / 2, 0}, z{0, 0, h.z / 2};
                Real& u = velocity[c](i, j, k);
                if (c == Location::u) u = (A_z(p + y) - A_z(p - y)) / h.y;
                if (c == Location::v)
                    u = (A_x(p + z) - A_x(p - z)) / h.z - (A_z(p + x) - A_z(p - x)) / h.x;
                if (c == Location::w) u = -(A_x(p + y) - A_x(p - y)) / h.y;
            });
    return velocity;
}

/// The velocity that composite B-splines reconstruct at a point.
Vec3 reconstruct(const Grid& g, const VectorField& velocity, const Vec3& p)
{
    const KernelPair& kernels = composite_bsplines;
    const Vec3 h = g.spacing();
    std::array<Real, 3> value{};
    for (Location c : components) {
        const auto& u = velocity[c];
        const Vec3 s = p - g.position(c, 0, 0, 0);
        const auto weights = [&](Location along, Real at) {
            return delta_weights(c == along ? kernels.along : kernels.across, at);
        };
        const Stencil4 x = weights(Location::u, s.x / h.x), y = weights(Location::v, s.y / h.y),
                       z = weights(Location::w, s.z / h.z);
        for (std::size_t l = 0; l < 64; ++l) {
            const std::size_t a = l / 16, b = l / 4 % 4, d = l % 4;
            const auto at = [&](std::size_t n, const Stencil4& t) {
                return t.first + static_cast<Index>(n);
            };
            const Index i = at(a, x), j = at(b, y), k = at(d, z);
            const Real neighbours = u(i - 1, j, k) + u(i + 1, j, k) + u(i, j - 1, k) +
                                    u(i, j + 1, k) + u(i, j, k - 1) + u(i, j, k + 1);
            value[static_cast<std::size_t>(axis(c))] +=
                x.weight[a] * y.weight[b] * z.weight[d] *
                (u(i, j, k) - kernels.sharpening * (neighbours - 6 * u(i, j, k)));
        }
    }
    return {value[0], value[1], value[2]};
}

// The difference between two sections is what passes the wall between them: Gauss' theorem, which
// holds because there is no divergence at any point. The wall's part is summed over 36 points in
// each element, whole rings of elements.
TEST(SectionFlow, ReconstructedFlowChangesByWhatPassesTheWall)
{
    BoxedTube stage(0.2);
    stage.place(support::positions(stage.tube, support::random_smooth(2, 0.3)));
    SectionFlow flow(stage.g, stage.tube);
    const VectorField velocity = smooth_solenoidal_velocity(stage.g);
    const Index first = 3, last = stage.tube.rings() - 4;
    const Real x_from = stage.tube.ring_x[first], x_to = stage.tube.ring_x[last];
    constexpr int n = 24;
    Real passed = 0, largest = 0;
    for (const auto& [a, b, c] : stage.tube.mesh.elements()) {
        const Vec3 A = stage.wall.x[a], ab = stage.wall.x[b] - A, ac = stage.wall.x[c] - A;
        const Vec3 area = 0.5 * cross(ab, ac);
        for (int m = 0; m < n * n; ++m) { // centroids of n^2 similar triangles
            const int row = m / n, column = m % n;
            const bool up = row + column < n;
            const Real s = (up ? row + 1. / 3 : n - row - 1. / 3) / n;
            const Real t = (up ? column + 1. / 3 : n - column - 1. / 3) / n;
            const Vec3 p = A + s * ab + t * ac;
            if (p.x < x_from || p.x > x_to) continue;
            passed += dot(reconstruct(stage.g, velocity, p), (1. / (n * n)) * area);
        }
    }
    const ScalarField& u = velocity[Location::u];
    for (Index i = 3; i <= stage.g.nx() - 3; ++i)
        largest = std::max(
            largest, std::abs(flow.reconstructed(u, stage.wall.x, stage.g.x(Location::u, i))));
    const Real difference =
        flow.reconstructed(u, stage.wall.x, x_from) - flow.reconstructed(u, stage.wall.x, x_to);
    EXPECT_GT(largest, 0.3);
    EXPECT_NEAR(difference / largest, passed / largest, 2e-4);
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
