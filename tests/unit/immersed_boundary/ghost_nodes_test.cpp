#include "immersed_boundary/ghost_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "immersed_boundary/section_flow.hpp"
#include "unit/grid/random_fields.hpp"
#include "unit/immersed_boundary/boxed_tube.hpp"
#include "unit/immersed_boundary/wall_shapes.hpp"

namespace starling {
namespace {

using support::BoxedTube;

/// Ghost nodes of u in a box, and their state.
struct Ghosts {
    GhostNodes nodes;
    GhostState state;

    explicit Ghosts(const BoxedTube& stage, Location c = Location::u)
        : nodes(stage.g, stage.tube, c,
                std::vector<char>(static_cast<std::size_t>(stage.g.nx() + 1), 1)),
          state(stage.g)
    {
    }
    static InterceptSearch search(const BoxedTube& stage)
    {
        return {stage.tube.mesh, stage.wall.x, stage.geometry};
    }
    void initialise(const BoxedTube& stage)
    {
        nodes.initialise(stage.wall.x, search(stage), state);
    }
    bool update(const BoxedTube& stage) { return nodes.update(search(stage), state); }
    std::vector<Index> list() const
    {
        const auto span = nodes.prescribed().node;
        return {span.begin(), span.end()};
    }
};

bool same_set(const Ghosts& a, const Ghosts& b)
{
    return std::ranges::equal(a.state.inside.values(), b.state.inside.values()) &&
           std::ranges::equal(a.state.near_wall, b.state.near_wall,
                              [](const NearNode& m, const NearNode& n) {
                                  return m.i == n.i && m.j == n.j && m.k == n.k;
                              }) &&
           a.list() == b.list();
}

/// The largest way of a vertex from undeformed to the shape, in spacings.
Real way(const BoxedTube& stage, const support::Shape& shape)
{
    const Array<Vec3> from = support::positions(stage.tube, shape, 0),
                      to = support::positions(stage.tube, shape, 1);
    Real most = 0;
    for (Index v = 0; v < to.size(); ++v) most = std::max(most, norm(to[v] - from[v]));
    return most / stage.g.delta();
}

/// How much farther than the nearest point of the wall an intercept is, at most.
Real largest_excess(const BoxedTube& stage, Location c, const Ghosts& ghosts)
{
    Real most = 0;
    for (const NearNode& n : ghosts.state.near_wall) {
        const Intercept nearest =
            Ghosts::search(stage).brute_force(stage.g.position(c, n.i, n.j, n.k));
        most = std::max(most, std::sqrt(n.intercept.squared_distance) -
                                  std::sqrt(nearest.squared_distance));
    }
    return most;
}

struct Morph : testing::TestWithParam<support::Shape> {
    BoxedTube stage{0.25};
    const support::Shape& shape = GetParam();
};

TEST_P(Morph, UpdatedSetIsTheFreshSetThereAndBack)
{
    for (Location c : {Location::u, Location::v}) {
        Ghosts updated(stage, c), fresh(stage, c);
        stage.place(support::positions(stage.tube, shape, 0));
        updated.initialise(stage);
        const int steps = 1 + static_cast<int>(way(stage, shape) / 0.45);
        for (int n = 1; n <= 2 * steps; ++n) {
            const Real progress = 1 - std::abs(n - steps) / static_cast<Real>(steps);
            stage.place(support::positions(stage.tube, shape, progress));
            ASSERT_TRUE(updated.update(stage)) << "step " << n << " of " << 2 * steps;
            fresh.initialise(stage);
            ASSERT_TRUE(same_set(updated, fresh)) << "step " << n << " of " << 2 * steps;
            if (n == steps && c == Location::u) {
                EXPECT_LT(largest_excess(stage, c, updated), 0.2 * stage.g.delta());
            }
        }
    }
}

TEST_P(Morph, AJumpIsFollowedOrRefused)
{
    Ghosts updated(stage), fresh(stage);
    stage.place(support::positions(stage.tube, shape, 0));
    updated.initialise(stage);
    stage.place(support::positions(stage.tube, shape, 1));
    if (!updated.update(stage)) return;
    fresh.initialise(stage);
    EXPECT_TRUE(same_set(updated, fresh));
}

TEST_P(Morph, GhostsAreTheOuterNodesWithAnInnerNeighbour)
{
    stage.place(support::positions(stage.tube, shape));
    for (Location c : components) {
        Ghosts ghosts(stage, c);
        ghosts.initialise(stage);
        const auto inside = ghosts.state.inside.view();
        std::vector<Index> expected;
        support::visit(stage.g.unknowns(c), [&](Index i, Index j, Index k) {
            const auto at = [&](Index di, Index dj, Index dk) {
                const Box b = stage.g.unknowns(c);
                const std::array<Index, 3> n{i + di, j + dj, k + dk};
                for (std::size_t d = 0; d < 3; ++d)
                    if (n[d] < b.begin[d] || n[d] >= b.end[d]) return false;
                return inside(n[0], n[1], n[2]) != 0;
            };
            if (at(0, 0, 0)) return;
            if (at(-1, 0, 0) || at(1, 0, 0) || at(0, -1, 0) || at(0, 1, 0) || at(0, 0, -1) ||
                at(0, 0, 1))
                expected.push_back(inside.offset(i, j, k));
        });
        EXPECT_EQ(ghosts.list(), expected);
    }
}

INSTANTIATE_TEST_SUITE_P(GhostNodes, Morph, testing::ValuesIn(support::all_shapes()),
                         support::shape_name);

// The old intercept on one side of the channel stays one while the other side passes the node.
TEST(GhostNodes, FollowANarrowChannelThatMovesSideways)
{
    for (Real neck : {0.25, 0.15, 0.1}) { // of half-width 1, 0.6, 0.4 spacings
        BoxedTube stage(0.25);
        const support::Shape channel = support::dumbbell(neck);
        const support::Shape shift{"shift", [](Real, Real) { return Point2{0, 0.6}; }};
        const Array<Vec3> rest = WallState(stage.tube).x, from = positions(stage.tube, channel),
                          way = positions(stage.tube, shift);
        Ghosts updated(stage), fresh(stage);
        stage.place(from);
        updated.initialise(stage);
        for (int n = 1; n <= 36; ++n) {
            Array<Vec3> x = from;
            for (Index v = 0; v < x.size(); ++v) x[v] += std::sin(n / 12.) * (way[v] - rest[v]);
            stage.place(x);
            ASSERT_TRUE(updated.update(stage)) << "neck " << neck << " step " << n;
            fresh.initialise(stage);
            ASSERT_TRUE(same_set(updated, fresh)) << "neck " << neck << " step " << n;
        }
    }
}

TEST(GhostNodes, LiveOnTheEndPlanesToo)
{
    BoxedTube stage(0.25);
    Ghosts ghosts(stage);
    ghosts.initialise(stage);
    const auto begin = ghosts.nodes.prescribed().plane_begin;
    for (Index i : {Index{0}, stage.g.nx()}) {
        const auto n = static_cast<std::size_t>(i);
        EXPECT_GT(begin[n + 1] - begin[n], 20);
    }
}

TEST(GhostNodes, ListIsSplitByPlanesAndMarkedInTheMask)
{
    BoxedTube stage(0.25);
    stage.place(support::positions(stage.tube, support::random_smooth(1, 0.4)));
    Ghosts ghosts(stage);
    ghosts.initialise(stage);
    const PrescribedNodes p = ghosts.nodes.prescribed();
    ASSERT_EQ(p.plane_begin.size(), static_cast<std::size_t>(stage.g.nx() + 2));
    EXPECT_EQ(p.plane_begin.front(), 0);
    EXPECT_EQ(p.plane_begin.back(), ghosts.nodes.count());
    EXPECT_TRUE(std::ranges::is_sorted(p.node));
    Index marked = 0;
    support::visit(stage.g.unknowns(Location::u), [&](Index i, Index j, Index k) {
        if (!p.mask(i, j, k)) return;
        ++marked;
        const auto plane = static_cast<std::size_t>(i);
        const auto begin = p.node.begin() + p.plane_begin[plane],
                   end = p.node.begin() + p.plane_begin[plane + 1];
        EXPECT_NE(std::find(begin, end, p.mask.offset(i, j, k)), end);
    });
    EXPECT_EQ(marked, ghosts.nodes.count());
}

TEST(GhostNodes, MaskForgetsTheGhostsOfTheStepBefore)
{
    BoxedTube stage(0.25);
    Ghosts ghosts(stage);
    ghosts.initialise(stage);
    for (Real size : {0.05, 0.1, 0.15, 0.2, 0.25, 0.3}) {
        stage.place(support::positions(stage.tube, support::inflated(size)));
        ASSERT_TRUE(ghosts.update(stage));
    }
    Index marked = 0;
    support::visit(stage.g.unknowns(Location::u), [&](Index i, Index j, Index k) {
        marked += ghosts.nodes.prescribed().mask(i, j, k);
    });
    EXPECT_EQ(marked, ghosts.nodes.count());
}

TEST(GhostNodes, InactivePlanesHaveNone)
{
    BoxedTube stage(0.25);
    std::vector<char> active(static_cast<std::size_t>(stage.g.nx() + 1), 0);
    active[2] = active[3] = 1;
    GhostNodes nodes(stage.g, stage.tube, Location::v, active);
    GhostState state(stage.g);
    nodes.initialise(stage.wall.x, Ghosts::search(stage), state);
    const auto begin = nodes.prescribed().plane_begin;
    for (std::size_t i = 0; i + 1 < begin.size(); ++i)
        EXPECT_EQ(begin[i + 1] > begin[i], i == 2 || i == 3) << i;
}

TEST(GhostNodes, DoNotDependOnThreads)
{
    const auto shape = support::random_smooth(2, 0.45);
    const auto [one, two] = support::with_one_and_two_threads([&] {
        BoxedTube stage(0.25);
        Ghosts ghosts(stage);
        ghosts.initialise(stage);
        for (int n = 1; n <= 8; ++n) {
            stage.place(support::positions(stage.tube, shape, n / 8.));
            EXPECT_TRUE(ghosts.update(stage));
        }
        support::Random random;
        const VectorField u = support::random_velocity(stage.g, random);
        ghosts.nodes.evaluate(u[Location::u]);
        return ghosts;
    });
    EXPECT_TRUE(same_set(one, two));
    EXPECT_TRUE(std::ranges::equal(one.state.near_wall, two.state.near_wall,
                                   [](const NearNode& a, const NearNode& b) {
                                       return a.intercept.element == b.intercept.element;
                                   }));
    EXPECT_TRUE(std::ranges::equal(one.nodes.prescribed().value, two.nodes.prescribed().value));
}

/// Calls f(position in the list, i, j, k) for every ghost node.
template <class F>
void for_ghosts(const BoxedTube& stage, const Ghosts& ghosts, Location c, F f)
{
    const PrescribedNodes p = ghosts.nodes.prescribed();
    std::size_t n = 0;
    support::visit(stage.g.unknowns(c), [&](Index i, Index j, Index k) {
        if (p.mask(i, j, k)) f(n++, i, j, k);
    });
}

TEST(GhostNodes, ValueIsMinusTheInterpolatedValueAtTheImagePoint)
{
    BoxedTube stage(0.25);
    stage.place(support::positions(stage.tube, support::random_smooth(2, 0.45)));
    support::Random random;
    VectorField u = support::random_velocity(stage.g, random);
    Index contain_themselves = 0, checked = 0;
    for (Location c : components) {
        Ghosts ghosts(stage, c);
        ghosts.initialise(stage);
        ghosts.nodes.evaluate(u[c]);
        const auto value = ghosts.nodes.prescribed().value;
        const Vec3 h = stage.g.spacing();
        std::size_t n = 0;
        for (const NearNode& node : ghosts.state.near_wall) {
            if (ghosts.state.inside(node.i, node.j, node.k)) continue;
            const Real expected = value[n++];
            const Vec3 p = stage.g.position(c, node.i, node.j, node.k);
            const Vec3 image = 2 * node.intercept.point - p, d = image - p;
            // beyond the first and last plane values are extrapolated
            if (image.x < stage.g.x(c, 0) || image.x > stage.g.x(c, stage.g.unknowns(c).end[0] - 1))
                continue;
            ++checked;
            contain_themselves += std::abs(d.x) < h.x && std::abs(d.y) < h.y && std::abs(d.z) < h.z;
            // the condition holds with the ghost's value in its own place
            Real& own = u[c](node.i, node.j, node.k);
            const Real before = own;
            own = expected;
            EXPECT_NEAR(interpolate_at(stage.g, c, u[c], image), -expected, 1e-12);
            own = before;
        }
    }
    EXPECT_GT(checked, 1000);
    EXPECT_GT(contain_themselves, 100);
}

TEST(GhostNodes, ValueDoesNotDependOnTheOldValueOfTheNode)
{
    BoxedTube stage(0.3);
    Ghosts ghosts(stage);
    ghosts.initialise(stage);
    support::Random random;
    VectorField u = support::random_velocity(stage.g, random);
    ghosts.nodes.evaluate(u[Location::u]);
    const auto span = ghosts.nodes.prescribed().value;
    const std::vector<Real> value(span.begin(), span.end());
    for_ghosts(stage, ghosts, Location::u, [&](std::size_t n, Index i, Index j, Index k) {
        Real& own = u[Location::u](i, j, k);
        const Real before = own;
        own = 1e6;
        ghosts.nodes.evaluate(u[Location::u]);
        EXPECT_EQ(ghosts.nodes.prescribed().value[n], value[n]);
        own = before;
    });
}

/// Largest difference of the ghost values from r - 1, given a velocity r - 1.
Real odd_extension_error(Real spacing, Location c)
{
    BoxedTube stage(spacing);
    Ghosts ghosts(stage, c);
    ghosts.initialise(stage);
    ScalarField u(stage.g);
    const auto distance = [&](Index i, Index j, Index k) {
        const Vec3 p = stage.g.position(c, i, j, k);
        return std::hypot(p.y, p.z) - 1;
    };
    support::visit(stage.g.unknowns(c),
                   [&](Index i, Index j, Index k) { u(i, j, k) = distance(i, j, k); });
    ghosts.nodes.evaluate(u);
    Real error = 0;
    for_ghosts(stage, ghosts, c, [&](std::size_t n, Index i, Index j, Index k) {
        error = std::max(error, std::abs(ghosts.nodes.prescribed().value[n] - distance(i, j, k)));
    });
    return error;
}

TEST(GhostNodes, ContinueAVelocityOddlyThroughTheWallToSecondOrder)
{
    for (Location c : components) {
        const Real coarse = odd_extension_error(0.24, c), fine = odd_extension_error(0.08, c);
        EXPECT_LT(fine, 0.5 * 0.08 * 0.08);
        EXPECT_NEAR(std::log(coarse / fine) / std::log(3.), 2, 0.3);
    }
}

} // namespace
} // namespace starling
