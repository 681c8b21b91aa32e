#include "immersed_boundary/transfer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "immersed_boundary/axial_guide.hpp"
#include "unit/grid/random_fields.hpp"
#include "unit/immersed_boundary/boxed_tube.hpp"

namespace starling {
namespace {

using support::BoxedTube;

constexpr KernelPair cosine{Kernel::cosine, Kernel::cosine};
constexpr KernelPair splines{Kernel::cubic_bspline, Kernel::quadratic_bspline};
constexpr KernelPair sharpened{Kernel::cubic_bspline, Kernel::quadratic_bspline, 1.0 / 8};

Real component_of(Location c, const Vec3& a)
{
    return c == Location::u ? a.x : c == Location::v ? a.y : a.z;
}

struct AnyPair : testing::TestWithParam<KernelPair> {
    BoxedTube stage{0.25};
    support::Random random;
    Transfer transfer{stage.g, stage.tube, GetParam(), stage.tube.moving_rings()};

    AnyPair()
    {
        stage.place(support::positions(stage.tube, support::random_smooth(1, 0.4)));
        EXPECT_TRUE(transfer.update(stage.wall.x));
    }
    Array<Vec3> random_force()
    {
        Array<Vec3> f(stage.wall.x.size());
        for (Vec3& a : f) a = {random(), random(), random()};
        return f;
    }
    bool moves(Index v) const
    {
        return v >= stage.tube.moving_begin() && v < stage.tube.moving_end();
    }
};

TEST_P(AnyPair, SpreadingConservesTheForce)
{
    Array<Vec3> f = random_force();
    Vec3 total;
    for (Index v = 0; v < f.size(); ++v) {
        if (!moves(v)) f[v] = {};
        total += f[v];
    }
    for (Location c : components) {
        ScalarField rhs(stage.g);
        transfer.spread(c, f, rhs);
        Real sum = 0;
        support::visit(stage.g.unknowns(c),
                       [&](Index i, Index j, Index k) { sum += rhs(i, j, k); });
        EXPECT_NEAR(sum * stage.g.cell_volume(), component_of(c, total), 1e-12);
    }
}

TEST_P(AnyPair, SpreadingAddsToWhatIsThere)
{
    const Array<Vec3> f = random_force();
    ScalarField alone(stage.g), on_top(stage.g);
    on_top.fill(5);
    transfer.spread(Location::v, f, alone);
    transfer.spread(Location::v, f, on_top);
    EXPECT_LT(support::largest(
                  stage.g.unknowns(Location::v),
                  [&](Index i, Index j, Index k) { return on_top(i, j, k) - alone(i, j, k) - 5; }),
              1e-11);
}

// Where all rings act, weights beyond the end faces go to the mirror images of their nodes.
TEST_P(AnyPair, KeepsForceAndUniformFlowAtTheEndsOfTheTube)
{
    Transfer whole(stage.g, stage.tube, GetParam(), {0, stage.tube.rings()});
    ASSERT_TRUE(whole.update(stage.wall.x));
    const Array<Vec3> f = random_force();
    Vec3 total;
    for (const Vec3& a : f) total += a;
    Array<Vec3> U(f.size());
    for (Location c : {Location::v, Location::w}) {
        ScalarField F(stage.g), one(stage.g);
        whole.spread(c, f, F);
        Real sum = 0;
        support::visit(stage.g.unknowns(c), [&](Index i, Index j, Index k) { sum += F(i, j, k); });
        EXPECT_NEAR(sum * stage.g.cell_volume(), component_of(c, total), 1e-12);
        one.fill(1);
        whole.interpolate(c, one, U);
        for (const Vec3& a : U) EXPECT_NEAR(component_of(c, a), 1, 1e-14);
    }
}

TEST_P(AnyPair, SpreadAndInterpolateAreAdjoint)
{
    // sum over faces of u F h^3 = sum over vertices of U f, clamps included
    const Array<Vec3> f = random_force();
    for (Location c : components) {
        ScalarField u(stage.g), F(stage.g);
        support::randomise(stage.g, c, u, random);
        transfer.spread(c, f, F);
        Array<Vec3> U(f.size());
        transfer.interpolate(c, u, U);
        Real at_faces = 0, at_vertices = 0, scale = 0;
        support::visit(stage.g.unknowns(c), [&](Index i, Index j, Index k) {
            at_faces += u(i, j, k) * F(i, j, k) * stage.g.cell_volume();
        });
        for (Index v = stage.tube.moving_begin(); v < stage.tube.moving_end(); ++v) {
            const Real power = component_of(c, f[v]) * component_of(c, U[v]);
            at_vertices += power;
            scale += std::abs(power);
        }
        EXPECT_GT(scale, 10);
        EXPECT_NEAR(at_faces, at_vertices, 1e-14 * scale);
    }
}

TEST_P(AnyPair, ReachesItsHalfWidthBeyondTheClamps)
{
    const Array<Vec3> f = random_force();
    const Real reach = GetParam().reach() * stage.g.spacing().x;
    for (Location c : components) {
        ScalarField rhs(stage.g);
        transfer.spread(c, f, rhs);
        for (Index i = -1; i <= stage.g.nx() + 1; ++i) {
            const Real x = stage.g.x(c, i);
            if (x > stage.tube.x_clamp_in() - reach && x < stage.tube.x_clamp_out() + reach)
                continue;
            support::visit({{i, -1, -1}, {i + 1, stage.g.ny() + 1, stage.g.nz() + 1}},
                           [&](Index, Index j, Index k) { EXPECT_EQ(rhs(i, j, k), 0) << i; });
        }
    }
}

TEST_P(AnyPair, InterpolatesOnlyTheComponentAskedFor)
{
    ScalarField u(stage.g);
    u.fill(2);
    for (Location c : components) {
        Array<Vec3> U(stage.wall.x.size());
        U.fill({7, 7, 7});
        transfer.interpolate(c, u, U);
        for (Index v = 0; v < U.size(); ++v)
            for (Location other : components)
                if (other != c || !moves(v)) {
                    EXPECT_EQ(component_of(other, U[v]), 7);
                }
    }
}

TEST_P(AnyPair, InterpolatesAConstantExactly)
{
    ScalarField u(stage.g);
    u.fill(3);
    Array<Vec3> U(stage.wall.x.size());
    for (Location c : components) transfer.interpolate(c, u, U);
    for (Index v = 0; v < U.size(); ++v)
        if (moves(v)) {
            EXPECT_LT(norm(U[v] - Vec3{3, 3, 3}), 1e-14);
        }
}

TEST_P(AnyPair, InterpolatesALinearFieldUpToTheFirstMoment)
{
    const Vec3 slope{0.7, -1.1, 0.4};
    // the first moment of the cosine kernel is at most 0.0211 spacings in each direction
    const bool exact = GetParam().across == Kernel::quadratic_bspline;
    const Real allowed = exact ? 1e-13 : 0.0211 * stage.g.delta() * 1.02 * (0.7 + 1.1 + 0.4);
    Array<Vec3> U(stage.wall.x.size());
    for (Location c : components) {
        ScalarField u(stage.g);
        support::visit(stage.g.unknowns(c), [&](Index i, Index j, Index k) {
            u(i, j, k) = 2 + dot(slope, stage.g.position(c, i, j, k));
        });
        transfer.interpolate(c, u, U);
        for (Index v = 0; v < U.size(); ++v)
            if (moves(v)) {
                EXPECT_NEAR(component_of(c, U[v]), 2 + dot(slope, stage.wall.x[v]), allowed);
            }
    }
}

TEST_P(AnyPair, DoesNotDependOnThreads)
{
    const Array<Vec3> f = random_force();
    const VectorField u = support::random_velocity(stage.g, random);
    const auto [one, two] = support::with_one_and_two_threads([&] {
        VectorField F(stage.g);
        Array<Vec3> U(f.size());
        transfer.update(stage.wall.x);
        for (Location c : components) {
            transfer.spread(c, f, F[c]);
            transfer.interpolate(c, u[c], U);
        }
        return std::pair{std::move(F), std::move(U)};
    });
    for (Location c : components)
        EXPECT_TRUE(std::ranges::equal(one.first[c].values(), two.first[c].values()));
    EXPECT_TRUE(std::ranges::equal(one.second, two.second));
}

TEST_P(AnyPair, RefusesPositionsThatAreNotFinite)
{
    Array<Vec3> x = stage.wall.x;
    for (Real bad : {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity(),
                     -std::numeric_limits<Real>::infinity(), 1e300}) {
        x[stage.tube.moving_begin() + 7].y = bad;
        EXPECT_FALSE(transfer.update(x));
    }
    EXPECT_TRUE(transfer.update(stage.wall.x));
}

TEST_P(AnyPair, RefusesPositionsAtTheSideOfTheBox)
{
    const Vec3 low = stage.g.origin(), h = stage.g.spacing(), size = stage.g.lengths();
    const Index v = stage.tube.moving_end() - 1;
    const auto accepts = [&](Real y, Real z) {
        Array<Vec3> x = stage.wall.x;
        x[v].y = y;
        x[v].z = z;
        return transfer.update(x);
    };
    for (Real y : {low.y + 1.9 * h.y, low.y + size.y - 1.9 * h.y}) EXPECT_FALSE(accepts(y, 0));
    for (Real z : {low.z + 1.9 * h.z, low.z + size.z - 1.9 * h.z}) EXPECT_FALSE(accepts(0, z));
    EXPECT_TRUE(accepts(low.y + 2.1 * h.y, low.z + 2.1 * h.z));
    EXPECT_TRUE(accepts(low.y + size.y - 2.1 * h.y, low.z + size.z - 2.1 * h.z));
}

INSTANTIATE_TEST_SUITE_P(Transfer, AnyPair, testing::Values(cosine, splines, sharpened),
                         [](const auto& pair) {
                             return pair.param.sharpening > 0            ? "sharpened"
                                    : pair.param.along == Kernel::cosine ? "cosine"
                                                                         : "splines";
                         });

TEST(Transfer, RigidTubeReceivesAndSpreadsNothing)
{
    BoxedTube stage(0.3, {.length = 4, .rigid = true});
    Array<Vec3> f(stage.wall.x.size()), U(stage.wall.x.size());
    f.fill({1, 1, 1});
    for (KernelPair kernels : {cosine, sharpened}) {
        Transfer transfer(stage.g, stage.tube, kernels, stage.tube.moving_rings());
        EXPECT_TRUE(transfer.update(stage.wall.x));
        ScalarField rhs(stage.g);
        for (Location c : components) {
            transfer.spread(c, f, rhs);
            transfer.interpolate(c, rhs, U);
        }
        EXPECT_TRUE(std::ranges::all_of(rhs.values(), [](Real a) { return a == 0; }));
    }
}

/// S f of formula (E') in docs/numerics.md, at the unknowns; f has valid halos.
ScalarField sharpened_field(const Grid& g, Location c, const ScalarField& f, Real a)
{
    ScalarField S(g);
    support::visit(g.unknowns(c), [&](Index i, Index j, Index k) {
        S(i, j, k) =
            (1 + 6 * a) * f(i, j, k) - a * (f(i - 1, j, k) + f(i + 1, j, k) + f(i, j - 1, k) +
                                            f(i, j + 1, k) + f(i, j, k - 1) + f(i, j, k + 1));
    });
    return S;
}

/// Mirror images in the halos of the end planes, as velocities have them.
void mirror_at_ends(const Grid& g, Location c, ScalarField& f)
{
    const Index image = c == Location::u ? 1 : 0, last = g.unknowns(c).end[0] - 1;
    support::visit({{0, -1, -1}, {1, g.ny() + 1, g.nz() + 1}}, [&](Index, Index j, Index k) {
        f(-1, j, k) = f(image, j, k);
        f(last + 1, j, k) = f(last - image, j, k);
    });
}

TEST(Transfer, SharpensAsIfItSharpenedTheField)
{
    BoxedTube stage(0.25);
    const Grid& g = stage.g;
    support::Random random;
    stage.place(support::positions(stage.tube, support::random_smooth(1, 0.4)));
    const RingRange all{0, stage.tube.rings()};
    Transfer blunt(g, stage.tube, splines, all), sharp(g, stage.tube, sharpened, all);
    ASSERT_TRUE(blunt.update(stage.wall.x) && sharp.update(stage.wall.x));
    const VectorField u = support::random_velocity(g, random);
    Array<Vec3> f(stage.wall.x.size()), expected(f.size()), U(f.size());
    for (Vec3& a : f) a = {random(), random(), random()};
    for (Location c : components) {
        ScalarField F(g), spread(g);
        blunt.spread(c, f, F);
        mirror_at_ends(g, c, F);
        const ScalarField S_F = sharpened_field(g, c, F, sharpened.sharpening);
        sharp.spread(c, f, spread);
        const auto value = [&](Index i, Index j, Index k) { return S_F(i, j, k); };
        const auto error = [&](Index i, Index j, Index k) {
            return spread(i, j, k) - S_F(i, j, k);
        };
        EXPECT_LT(support::largest(g.unknowns(c), error),
                  1e-14 * support::largest(g.unknowns(c), value))
            << axis(c);
        blunt.interpolate(c, sharpened_field(g, c, u[c], sharpened.sharpening), expected);
        sharp.interpolate(c, u[c], U);
        for (Index v = 0; v < f.size(); ++v)
            EXPECT_NEAR(component_of(c, U[v]), component_of(c, expected[v]), 1e-13);
    }
}

/// Component c of u at p, in the middle of the deforming part: a tube with a ring through p.
Real interpolated(const Grid& g, KernelPair kernels, Location c, const VectorField& u, Vec3 p)
{
    Tube tube = make_tube(support::short_tube(), 0.5);
    const Index ring = (tube.clamp_in + tube.clamp_out) / 2;
    tube.ring_x[static_cast<std::size_t>(ring)] = p.x;
    Array<Vec3> x = WallState(tube).x, U(x.size());
    const VertexIndex v = tube.first(ring);
    x[v] = p;
    Transfer transfer(g, tube, kernels, tube.moving_rings());
    EXPECT_TRUE(transfer.update(x));
    transfer.interpolate(c, u[c], U);
    return component_of(c, U[v]);
}

/// Divergence at p of the interpolated velocity, by central differences.
Real divergence_at(const Grid& g, KernelPair kernels, const VectorField& u, const Vec3& p)
{
    const Real h = 1e-4;
    Real sum = 0;
    for (Location c : components) {
        const Vec3 step{c == Location::u ? h : 0, c == Location::v ? h : 0,
                        c == Location::w ? h : 0};
        sum +=
            (interpolated(g, kernels, c, u, p + step) - interpolated(g, kernels, c, u, p - step)) /
            (2 * h);
    }
    return sum;
}

TEST(Transfer, SplinesInterpolateASolenoidalFieldToADivergenceFreeOne)
{
    const Grid g = support::box_around(0.25);
    support::Random random;
    const VectorField u = support::random_solenoidal_velocity(g, 1, random);
    Real with_splines = 0, with_cosine = 0;
    for (int n = 0; n < 5; ++n) {
        const Vec3 p{2 + 0.1 * random(), 1.5 * random(), 1.5 * random()};
        with_splines = std::max(with_splines, std::abs(divergence_at(g, splines, u, p)));
        with_cosine = std::max(with_cosine, std::abs(divergence_at(g, cosine, u, p)));
    }
    EXPECT_LT(with_splines, 1e-5);
    EXPECT_GT(with_cosine, 0.1);
}

} // namespace
} // namespace starling
