#include "immersed_boundary/intercept_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/grid/random_fields.hpp"
#include "unit/immersed_boundary/boxed_tube.hpp"
#include "unit/immersed_boundary/wall_shapes.hpp"

namespace starling {
namespace {

/// A node near the wall and the truth about it.
struct Truth {
    Vec3 p;
    Intercept nearest;
    bool inside; ///< by the parity of crossings
};

struct AnyShape : testing::TestWithParam<support::Shape> {
    support::BoxedTube stage{0.25};
    support::Random random;
    InterceptSearch search{stage.tube.mesh, stage.wall.x, stage.geometry};

    AnyShape() { stage.place(support::positions(stage.tube, GetParam())); }

    static bool odd_crossings_below(CrossSection& section, const Vec3& p)
    {
        const auto& z = section.crossings(p.y);
        return (std::upper_bound(z.begin(), z.end(), p.z) - z.begin()) % 2 != 0;
    }
    /// u-nodes less than `reach` from the wall.
    std::vector<Truth> near_wall(Real reach) const
    {
        std::vector<Truth> nodes;
        CrossSection section(stage.tube);
        for (Index i = 0; i <= stage.g.nx(); ++i) {
            section.cut(stage.wall.x, stage.g.x(Location::u, i));
            support::visit(
                {{i, 0, 0}, {i + 1, stage.g.ny(), stage.g.nz()}}, [&](Index, Index j, Index k) {
                    const Vec3 p = stage.g.position(Location::u, i, j, k);
                    if (!is_near(section, p, reach)) return;
                    nodes.push_back({p, search.brute_force(p), odd_crossings_below(section, p)});
                });
        }
        return nodes;
    }
    static bool is_near(const CrossSection& section, const Vec3& p, Real reach)
    {
        return std::ranges::any_of(section.points(), [&](const Point2& q) {
            return std::hypot(q.y - p.y, q.z - p.z) < reach;
        });
    }
    Vec3 within(Real size) { return {size * random(), size * random(), size * random()}; }
};

TEST_P(AnyShape, SideOfTheNearestPointIsThatOfTheCrossingParity)
{
    const std::vector<Truth> nodes = near_wall(0.3);
    EXPECT_GT(nodes.size(), 500u);
    for (const Truth& n : nodes)
        EXPECT_EQ(n.nearest.outside, !n.inside) << n.p.x << " " << n.p.y << " " << n.p.z;
}

TEST_P(AnyShape, InterceptIsTheNearestPointOfItsElement)
{
    for (const Truth& n : near_wall(0.3)) {
        const Vec3 d = n.p - n.nearest.point;
        EXPECT_NEAR(dot(d, d), n.nearest.squared_distance, 1e-14);
        const auto& [a, b, c] = stage.tube.mesh.element(n.nearest.element);
        for (VertexIndex v :
             {a, b, c}) // the element lies behind the plane through its nearest point
            EXPECT_LE(dot(d, stage.wall.x[v] - n.nearest.point), 1e-13);
    }
}

INSTANTIATE_TEST_SUITE_P(InterceptSearch, AnyShape, testing::ValuesIn(support::all_shapes()),
                         support::shape_name);

/// As in a step: the walk starts from the element of a position up to `reach` away.
struct Walked : Truth {
    Intercept found;
};

struct Walk : AnyShape {
    std::vector<Walked> walks(Real reach)
    {
        std::vector<Walked> walks;
        for (const Truth& n : near_wall(0.3))
            walks.push_back({n, search.walk(n.p, search.brute_force(n.p + within(reach)).element)});
        return walks;
    }
    static Real excess(const Walked& n)
    {
        return std::sqrt(n.found.squared_distance) - std::sqrt(n.nearest.squared_distance);
    }
};

struct ConvexShape : Walk {};

// The rings of the triangulated tube are shallow valleys: neighbouring facets can have an intercept
// each, nearly as near.
TEST_P(ConvexShape, WalkFindsWhatBruteForceFindsToWithinAFacet)
{
    for (Real reach : {0.125, 1.})
        for (const Walked& n : walks(reach)) {
            EXPECT_LT(excess(n), 0.04); // of edges up to 0.4 long
            EXPECT_EQ(n.found.outside, !n.inside);
        }
}

INSTANTIATE_TEST_SUITE_P(InterceptSearch, ConvexShape, testing::ValuesIn(support::convex_shapes()),
                         support::shape_name);

struct FoldedShape : Walk {};

// In a fold a node has several intercepts, one per part of the wall; the walk keeps the one it
// came from. (GhostNodes makes sure that it is not hidden behind another part.)
TEST_P(FoldedShape, WalkFindsTheNearestOrAnotherIntercept)
{
    const std::vector<Walked> all = walks(0.125);
    const auto far = std::ranges::count_if(all, [](const Walked& n) { return excess(n) > 0.01; });
    EXPECT_LT(far, static_cast<std::ptrdiff_t>(all.size()) / 50);
    for (const Walked& n : all) {
        EXPECT_EQ(search.walk(n.p, n.found.element).squared_distance, n.found.squared_distance);
        if (excess(n) < 0.01) {
            EXPECT_EQ(n.found.outside, !n.inside);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(InterceptSearch, FoldedShape, testing::ValuesIn(support::folded_shapes()),
                         support::shape_name);

} // namespace
} // namespace starling
