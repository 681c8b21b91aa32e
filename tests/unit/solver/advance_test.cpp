#include "solver/advance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "grid/stencils.hpp"
#include "unit/grid/random_fields.hpp"
#include "unit/solver/coupled.hpp"

namespace starling {
namespace {

using support::Coupled;
using support::CoupledParameters;

bool same_fields(const FluidState& a, const FluidState& b)
{
    bool same = std::ranges::equal(a.P.values(), b.P.values()) && a.dt_before == b.dt_before;
    for (Location c : components)
        same = same && std::ranges::equal(a.u[c].values(), b.u[c].values()) &&
               std::ranges::equal(a.N_before[c].values(), b.N_before[c].values());
    return same;
}

bool same_node(const NearNode& a, const NearNode& b)
{
    return a.i == b.i && a.j == b.j && a.k == b.k && a.intercept.element == b.intercept.element &&
           a.intercept.point == b.intercept.point;
}

bool same_ghosts(const GhostState& a, const GhostState& b)
{
    return std::ranges::equal(a.inside.values(), b.inside.values()) &&
           std::ranges::equal(a.near_wall, b.near_wall, same_node);
}

bool same_bits(const State& a, const State& b)
{
    bool same = same_fields(a.fluid, b.fluid) && std::ranges::equal(a.wall.x, b.wall.x) &&
                std::ranges::equal(a.wall.velocity, b.wall.velocity) && a.t == b.t &&
                a.step == b.step;
    for (std::size_t c = 0; c < 3; ++c) same = same && same_ghosts(a.ghosts[c], b.ghosts[c]);
    return same;
}

Real largest_displacement(const Coupled& c)
{
    Real most = 0;
    for (std::size_t v = 0; v < c.tube.X.size(); ++v)
        most = std::max(most, norm(c.s.wall.x[static_cast<Index>(v)] - c.tube.X[v]));
    return most;
}

struct Model {
    std::string name;
    Material material;
    CouplingScheme scheme;
};

void PrintTo(const Model& model, std::ostream* out) { *out << model.name; }

std::vector<Model> every_model()
{
    constexpr Real G_s = 1 / (0.1 * 0.02);
    const std::vector<std::pair<std::string, Material>> laws = {
        {"Hooke", Hooke{G_s, 0.5}},
        {"NeoHookean", NeoHookean{G_s}},
        {"MooneyRivlin", MooneyRivlin{G_s, 0.5}},
        {"Skalak", Skalak{G_s, 1}}};
    std::vector<Model> models;
    for (const auto& [name, material] : laws) {
        models.push_back({name + "Printed", material, CouplingScheme::printed});
        models.push_back({name + "Reaction", material, CouplingScheme::reaction});
        models.push_back({name + "Conserving", material, CouplingScheme::conserving});
    }
    return models;
}

struct EveryModel : testing::TestWithParam<Model> {
    CoupledParameters parameters{.material = GetParam().material,
                                 .scheme = GetParam().scheme,
                                 .E_b = 2,
                                 .contact = {.pressure = 1, .range = 1},
                                 .tissue = {.stiffness = 10, .damping = 0.5},
                                 .mu_s = 0.05};
};

TEST_P(EveryModel, OneAndTwoThreadsGiveTheSameBits)
{
    const auto [one, two] = support::with_one_and_two_threads([&] {
        auto c = std::make_unique<Coupled>(parameters);
        EXPECT_TRUE(c->run(20));
        return c;
    });
    EXPECT_GT(largest_displacement(*one), 0.1) << "the wall should move";
    EXPECT_TRUE(same_bits(one->s, two->s));
}

TEST_P(EveryModel, KeepsTheVelocityDivergenceFree)
{
    Coupled c(parameters);
    ASSERT_TRUE(c.run(5));
    const DivergenceAtCell divergence(c.g, c.s.fluid.u);
    EXPECT_LT(support::largest(c.g.unknowns(Location::cell), divergence), 1e-11);
}

// Every face gives h^3 F: the total is the force on the vertices, at the clamps too.
TEST_P(EveryModel, SpreadForceIsTheNodalForce)
{
    auto with_long_ends = parameters; // so that no axial force reaches the end faces
    with_long_ends.tube.length += 2.4;
    with_long_ends.tube.rigid_inlet += 1.2;
    with_long_ends.tube.rigid_outlet += 1.2;
    Coupled c(with_long_ends);
    ASSERT_TRUE(c.run(10));
    c.op.geometry.update(c.s.wall.x);
    c.op.elastic.compute(c.s.wall.x, c.w.f);
    c.op.support.apply(c.op.geometry, c.s.wall, 0.01, c.w.f);
    ASSERT_TRUE(c.op.coupling.weigh(c.s.wall));
    c.op.coupling.spread(c.w.f, c.w.F);

    Vec3 spread, nodal;
    for (Location d : components) {
        Real sum = 0;
        support::visit(c.g.unknowns(d),
                       [&](Index i, Index j, Index k) { sum += c.w.F[d](i, j, k); });
        (d == Location::u   ? spread.x
         : d == Location::v ? spread.y
                            : spread.z) = sum * c.g.cell_volume();
    }
    const RingRange rings = AxialGuide(parameters.scheme).acting_rings(c.tube);
    EXPECT_EQ(rings.begin == 0 && rings.end == c.tube.rings(),
              parameters.scheme == CouplingScheme::conserving);
    Real scale = 0;
    for (VertexIndex v = c.tube.first(rings.begin); v < c.tube.first(rings.end); ++v) {
        nodal += c.w.f[v];
        scale += norm(c.w.f[v]);
    }
    EXPECT_GT(scale, 10);
    EXPECT_LT(norm(spread - nodal), 1e-13 * scale);
}

INSTANTIATE_TEST_SUITE_P(Advance, EveryModel, testing::ValuesIn(every_model()),
                         [](const auto& model) { return model.param.name; });

TEST(Advance, OperatorsRememberNothing)
{
    Coupled c;
    ASSERT_TRUE(c.run(8));
    const State before = c.s;
    ASSERT_TRUE(c.run(6));
    const State after = c.s;
    c.s = before;
    ASSERT_TRUE(c.run(6));
    EXPECT_TRUE(same_bits(c.s, after));
}

TEST(Advance, CountsStepsAndTime)
{
    Coupled c;
    ASSERT_TRUE(advance(c.s, c.op, c.w, 0.01));
    ASSERT_TRUE(advance(c.s, c.op, c.w, 0.02));
    EXPECT_EQ(c.s.step, 2);
    EXPECT_DOUBLE_EQ(c.s.t, 0.03);
    EXPECT_EQ(c.s.fluid.dt_before, 0.02);
}

TEST(Advance, WithoutADriveNothingMoves)
{
    Coupled c({.pressure_ratio = 0});
    ASSERT_TRUE(c.run(3));
    EXPECT_LT(largest_displacement(c), 1e-13);
    for (Location d : components)
        EXPECT_LT(support::largest(c.g.unknowns(d), c.s.fluid.u[d].view()), 1e-11);
}

TEST(Advance, RefusesAWallThatIsNotFiniteAndLeavesTheFlowAlone)
{
    Coupled c;
    ASSERT_TRUE(c.run(2));
    const Vec3 good = c.s.wall.x[c.tube.moving_begin()];
    for (const Vec3& bad :
         {Vec3{good.x, std::numeric_limits<Real>::quiet_NaN(), 0}, Vec3{good.x, 1e3, 0}}) {
        c.s.wall.x[c.tube.moving_begin()] = bad;
        const State before = c.s;
        EXPECT_FALSE(c.run(1));
        EXPECT_TRUE(same_fields(c.s.fluid, before.fluid));
        EXPECT_EQ(c.s.step, 2);
        EXPECT_EQ(c.s.t, before.t);
        for (std::size_t n = 0; n < 3; ++n)
            EXPECT_TRUE(same_ghosts(c.s.ghosts[n], before.ghosts[n]));
    }
}

TEST(Advance, RigidTubeNeverMoves)
{
    Coupled c({.tube = {.length = 4, .rigid = true}});
    ASSERT_TRUE(c.run(10));
    EXPECT_EQ(largest_displacement(c), 0);
    EXPECT_GT(support::largest(c.g.unknowns(Location::u), c.s.fluid.u[Location::u].view()), 1);
}

/// Largest difference of u from its mirror image in y, relative to its largest value.
Real asymmetry(const Coupled& c)
{
    const auto u = c.s.fluid.u[Location::u].view();
    const Box b = c.g.unknowns(Location::u);
    return support::largest(b, [&](Index i, Index j,
                                   Index k) { return u(i, j, k) - u(i, c.g.ny() - 1 - j, k); }) /
           support::largest(b, u);
}

TEST(Advance, SymmetricTubeStaysSymmetric)
{
    for (CouplingScheme scheme :
         {CouplingScheme::printed, CouplingScheme::reaction, CouplingScheme::conserving}) {
        Coupled c({.scheme = scheme, .centred = true});
        ASSERT_TRUE(c.run(60));
        EXPECT_LT(asymmetry(c), 1e-13);
    }
}

} // namespace
} // namespace starling
