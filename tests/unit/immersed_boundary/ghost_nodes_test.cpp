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
    bool update(const BoxedTube& stage)
    {
        if (!nodes.search(search(stage), state)) return false;
        nodes.prescribe(state);
        return true;
    }
    std::vector<Index> list() const
    {
        const auto span = nodes.prescribed().node;
        return {span.begin(), span.end()};
    }
};

/// Nodes of the component with one of their six neighbours in `marked`, without those that are
/// inside or marked themselves.
std::vector<Index> outer_neighbours(const BoxedTube& stage, Location c, const Ghosts& ghosts,
                                    const Field<std::uint8_t>& marked)
{
    const Box b = stage.g.unknowns(c);
    const auto inside = ghosts.state.inside.view(), mark = marked.view();
    const auto is_marked = [&](Index i, Index j, Index k) {
        const std::array<Index, 3> n{i, j, k};
        for (std::size_t d = 0; d < 3; ++d)
            if (n[d] < b.begin[d] || n[d] >= b.end[d]) return false;
        return mark(i, j, k) != 0;
    };
    std::vector<Index> found;
    support::visit(b, [&](Index i, Index j, Index k) {
        if (inside(i, j, k) || mark(i, j, k)) return;
        if (is_marked(i - 1, j, k) || is_marked(i + 1, j, k) || is_marked(i, j - 1, k) ||
            is_marked(i, j + 1, k) || is_marked(i, j, k - 1) || is_marked(i, j, k + 1))
            found.push_back(inside.offset(i, j, k));
    });
    return found;
}

/// What the sides of the nodes ask for: outer nodes with an inner neighbour.
std::vector<Index> expected_ghosts(const BoxedTube& stage, Location c, const Ghosts& ghosts)
{
    return outer_neighbours(stage, c, ghosts, ghosts.state.inside);
}

/// Ghosts and, farther out, their neighbours.
std::vector<Index> expected_list(const BoxedTube& stage, Location c, const Ghosts& ghosts)
{
    std::vector<Index> list = expected_ghosts(stage, c, ghosts);
    Field<std::uint8_t> marked(stage.g);
    for (Index offset : list) marked.view().data[offset] = 1;
    const std::vector<Index> resting = outer_neighbours(stage, c, ghosts, marked);
    list.insert(list.end(), resting.begin(), resting.end());
    std::sort(list.begin(), list.end());
    return list;
}

/// True if the sides of all nodes agree but for those within a twentieth of a spacing of the wall.
bool same_sides(const BoxedTube& stage, Location c, const Ghosts& a, const Ghosts& b)
{
    bool same = true;
    support::visit(stage.g.unknowns(c), [&](Index i, Index j, Index k) {
        if (a.state.inside(i, j, k) == b.state.inside(i, j, k)) return;
        const Intercept nearest = Ghosts::search(stage).brute_force(stage.g.position(c, i, j, k));
        same &= std::sqrt(nearest.squared_distance) < 0.0501 * stage.g.spacing().x;
    });
    return same;
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

TEST_P(Morph, UpdatedSidesAreTheFreshOnesThereAndBack)
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
            ASSERT_TRUE(same_sides(stage, c, updated, fresh))
                << "step " << n << " of " << 2 * steps;
            ASSERT_EQ(updated.list(), expected_list(stage, c, updated));
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
    EXPECT_TRUE(same_sides(stage, Location::u, updated, fresh));
}

TEST_P(Morph, GhostsAreTheOuterNodesWithAnInnerNeighbourAndTheirNeighboursRest)
{
    stage.place(support::positions(stage.tube, shape));
    for (Location c : components) {
        Ghosts ghosts(stage, c);
        ghosts.initialise(stage);
        EXPECT_EQ(ghosts.list(), expected_list(stage, c, ghosts));
        EXPECT_EQ(ghosts.nodes.count(), expected_ghosts(stage, c, ghosts).size());
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
            ASSERT_TRUE(same_sides(stage, Location::u, updated, fresh))
                << "neck " << neck << " step " << n;
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
    EXPECT_EQ(p.plane_begin.back(), p.node.size());
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
    EXPECT_EQ(marked, p.node.size());
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
    EXPECT_EQ(marked, ghosts.list().size());
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
    EXPECT_TRUE(std::ranges::equal(one.state.inside.values(), two.state.inside.values()));
    EXPECT_EQ(one.list(), two.list());
    EXPECT_TRUE(std::ranges::equal(one.state.near_wall, two.state.near_wall,
                                   [](const NearNode& a, const NearNode& b) {
                                       return a.intercept.element == b.intercept.element;
                                   }));
    EXPECT_TRUE(std::ranges::equal(one.nodes.prescribed().value, two.nodes.prescribed().value));
}

/// Calls f(position in the list, node) for every ghost node.
template <class F>
void for_ghosts(const Ghosts& ghosts, F f)
{
    const auto list = ghosts.nodes.prescribed().node;
    for (const NearNode& n : ghosts.state.near_wall) {
        if (ghosts.state.inside(n.i, n.j, n.k)) continue;
        const Index offset = ghosts.state.inside.view().offset(n.i, n.j, n.k);
        const auto at = std::lower_bound(list.begin(), list.end(), offset);
        f(static_cast<std::size_t>(at - list.begin()), n);
    }
}

/// What the no-slip condition at the wall asks for: the prescribed value is half old, half this.
Real condition(const Ghosts& ghosts, std::size_t n, Real old)
{
    return 2 * ghosts.nodes.prescribed().value[n] - old;
}

TEST(GhostNodes, ValueContinuesALinearFlowThroughTheWall)
{
    BoxedTube stage(0.25);
    stage.place(support::positions(stage.tube, support::random_smooth(2, 0.45)));
    support::Random random;
    Index contain_themselves = 0, checked = 0;
    for (Location c : components) {
        Ghosts ghosts(stage, c);
        ghosts.initialise(stage);
        const Vec3 gradient{random(), random(), random()}, h = stage.g.spacing();
        const auto velocity = [&](const Vec3& p) { return dot(gradient, p) + 0.3; };
        ScalarField u(stage.g);
        support::visit(stage.g.unknowns(c), [&](Index i, Index j, Index k) {
            u(i, j, k) = velocity(stage.g.position(c, i, j, k));
        });
        ghosts.nodes.evaluate(u);
        for_ghosts(ghosts, [&](std::size_t n, const NearNode& node) {
            const Vec3 p = stage.g.position(c, node.i, node.j, node.k);
            const Vec3 image = 2 * node.intercept.point - p, d = image - p;
            // beyond the first and last plane values are extrapolated
            if (image.x < stage.g.x(c, 0) || image.x > stage.g.x(c, stage.g.unknowns(c).end[0] - 1))
                return;
            ++checked;
            contain_themselves += std::abs(d.x) < h.x && std::abs(d.y) < h.y && std::abs(d.z) < h.z;
            // the condition holds with the ghost's value in its own place
            Real& own = u(node.i, node.j, node.k);
            const Real before = own, expected = condition(ghosts, n, before);
            own = expected;
            EXPECT_NEAR(interpolate_at(stage.g, c, u, image), -expected, 1e-12);
            own = before;
        });
    }
    EXPECT_GT(checked, 1000);
    EXPECT_GT(contain_themselves, 100);
}

TEST(GhostNodes, ConditionDoesNotDependOnTheOldValueOfTheNode)
{
    BoxedTube stage(0.3);
    Ghosts ghosts(stage);
    ghosts.initialise(stage);
    support::Random random;
    VectorField u = support::random_velocity(stage.g, random);
    for_ghosts(ghosts, [&](std::size_t n, const NearNode& node) {
        Real& own = u[Location::u](node.i, node.j, node.k);
        const Real before = own;
        ghosts.nodes.evaluate(u[Location::u]);
        const Real wanted = condition(ghosts, n, before);
        own = 64;
        ghosts.nodes.evaluate(u[Location::u]);
        EXPECT_NEAR(condition(ghosts, n, own), wanted, 1e-12);
        own = before;
    });
}

TEST(GhostNodes, NodesBehindThemAreAtRest)
{
    BoxedTube stage(0.3);
    Ghosts ghosts(stage);
    ghosts.initialise(stage);
    support::Random random;
    const VectorField u = support::random_velocity(stage.g, random);
    ghosts.nodes.evaluate(u[Location::u]);
    const PrescribedNodes p = ghosts.nodes.prescribed();
    const auto ghost = expected_ghosts(stage, Location::u, ghosts);
    Index resting = 0;
    for (std::size_t n = 0; n < p.node.size(); ++n)
        if (!std::binary_search(ghost.begin(), ghost.end(), p.node[n])) {
            EXPECT_EQ(p.value[n], 0);
            ++resting;
        }
    EXPECT_GT(resting, ghosts.nodes.count() / 2);
}

/// Largest difference of the ghost values from a velocity that is quadratic and vanishes at r = 1.
Real continuation_error(Real spacing, Location c)
{
    BoxedTube stage(spacing);
    Ghosts ghosts(stage, c);
    ghosts.initialise(stage);
    ScalarField u(stage.g);
    const auto velocity = [&](Index i, Index j, Index k) {
        const Vec3 p = stage.g.position(c, i, j, k);
        return 1 - p.y * p.y - p.z * p.z;
    };
    support::visit(stage.g.unknowns(c),
                   [&](Index i, Index j, Index k) { u(i, j, k) = velocity(i, j, k); });
    ghosts.nodes.evaluate(u);
    Real error = 0;
    for_ghosts(ghosts, [&](std::size_t n, const NearNode& node) {
        const Real exact = velocity(node.i, node.j, node.k);
        error = std::max(error, std::abs(condition(ghosts, n, exact) - exact));
    });
    return error;
}

// What is left is the wall's: facets with edges of 0.65 spacings lie up to 0.1 spacing^2 inside.
TEST(GhostNodes, ContinuePoiseuilleFlowUpToTheFacetsOfTheWall)
{
    for (Location c : components)
        for (Real spacing : {0.24, 0.12, 0.08})
            EXPECT_LT(continuation_error(spacing, c), 0.3 * spacing * spacing);
}

} // namespace
} // namespace starling
