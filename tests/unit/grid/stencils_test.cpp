#include "grid/stencils.hpp"

#include <gtest/gtest.h>

#include "unit/grid/random_fields.hpp"

namespace starling {
namespace {

using support::largest;
using support::visit;

constexpr Real round_off = 1e-13;

class Stencils : public testing::Test {
protected:
    Grid g{{9, 8, 7}, {0, 0, 0}, {2.7, 1.6, 1.9}};
    support::Random random;

    /// Sum over the unknowns of C of weight * advection of C, relative to the sum of |terms|.
    template <Location C, class Weight>
    Real relative_sum(const VectorField& u, Weight weight) const
    {
        const Advection<C> N(g, u);
        Real sum = 0, size = 0;
        visit(g.unknowns(C), [&](Index i, Index j, Index k) {
            const Real term = weight(i, j, k) * N(u[C].view().offset(i, j, k));
            sum += term;
            size += std::abs(term);
        });
        return sum / size;
    }
};

TEST_F(Stencils, DivergenceOfTheGradientIsTheLaplacian)
{
    ScalarField phi(g);
    support::randomise(g, Location::cell, phi, random);
    fill_increment_halo(g, phi);
    const Vec3 h = g.spacing();
    VectorField gradient(g);
    visit({{0, 0, 0}, {g.nx() + 1, g.ny() + 1, g.nz() + 1}}, [&](Index i, Index j, Index k) {
        gradient[Location::u](i, j, k) = (phi(i, j, k) - phi(i - 1, j, k)) / h.x;
        gradient[Location::v](i, j, k) = (phi(i, j, k) - phi(i, j - 1, k)) / h.y;
        gradient[Location::w](i, j, k) = (phi(i, j, k) - phi(i, j, k - 1)) / h.z;
    });
    const DivergenceAtCell divergence_at_cell(g, gradient);
    const Laplacian laplacian(h);
    const View<const Real> f = phi.view();
    const Real size = 4 / (h.y * h.y);
    EXPECT_LT(largest(g.unknowns(Location::cell),
                      [&](Index i, Index j, Index k) {
                          return laplacian(f, f.offset(i, j, k)) - divergence_at_cell(i, j, k);
                      }),
              round_off * size);
}

TEST_F(Stencils, DivergenceOfADiscreteCurlVanishes)
{
    const VectorField u = support::random_solenoidal_velocity(g, 1, random);
    const DivergenceAtCell divergence_at_cell(g, u);
    EXPECT_GT(largest(g.unknowns(Location::u), u[Location::u].view()), 1);
    EXPECT_LT(largest(g.unknowns(Location::cell), divergence_at_cell), 100 * round_off);
}

TEST_F(Stencils, LaplacianIsExactForQuadratics)
{
    ScalarField f(g);
    visit({{-1, -1, -1}, {g.nx() + 1, g.ny() + 1, g.nz() + 1}}, [&](Index i, Index j, Index k) {
        const Vec3 r = g.position(Location::cell, i, j, k);
        f(i, j, k) = r.x * r.x - 3 * r.y * r.y + 0.5 * r.z * r.z + r.x * r.y - r.z;
    });
    const Laplacian laplacian(g.spacing());
    const View<const Real> view = std::as_const(f).view();
    EXPECT_LT(largest(g.unknowns(Location::cell),
                      [&](Index i, Index j, Index k) {
                          return laplacian(view, view.offset(i, j, k)) - (2 - 6 + 1);
                      }),
              1e-10);
}

TEST_F(Stencils, AdvectionConservesMomentumAwayFromBoundaries)
{
    const VectorField u = support::random_solenoidal_velocity(g, 2, random);
    const auto one = [](Index, Index, Index) { return 1.; };
    EXPECT_LT(std::abs(relative_sum<Location::u>(u, one)), round_off);
    EXPECT_LT(std::abs(relative_sum<Location::v>(u, one)), round_off);
    EXPECT_LT(std::abs(relative_sum<Location::w>(u, one)), round_off);
}

TEST_F(Stencils, AdvectionConservesTheEnergyOfEachComponentInAClosedBox)
{
    const VectorField u = support::random_solenoidal_velocity(g, 1, random);
    EXPECT_LT(std::abs(relative_sum<Location::u>(u, u[Location::u].view())), round_off);
    EXPECT_LT(std::abs(relative_sum<Location::v>(u, u[Location::v].view())), round_off);
    EXPECT_LT(std::abs(relative_sum<Location::w>(u, u[Location::w].view())), round_off);
}

TEST_F(Stencils, AdvectionOfAUniformFlowThroughTheEndsVanishes)
{
    VectorField u(g);
    for (Location c : components) u[c].fill(c == Location::u ? 2 : 0);
    const Advection<Location::u> N(g, u);
    const View<const Real> view = std::as_const(u)[Location::u].view();
    EXPECT_EQ(largest(g.unknowns(Location::u),
                      [&](Index i, Index j, Index k) { return N(view.offset(i, j, k)); }),
              0);
}

/// Largest error of div(u c) for a smooth divergence-free flow, n cells per direction.
template <Location C>
Real advection_error(Index n)
{
    const Grid g({n, n, n}, {0, 0, 0}, {1, 1.2, 0.9});
    const auto flow = [](const Vec3& r) {
        return Vec3{std::sin(r.x + r.y) + std::cos(r.z), -std::sin(r.x + r.y) + std::sin(r.z),
                    std::cos(2 * r.x) + std::sin(r.y)};
    };
    const auto exact = [](const Vec3& r) { // u . grad of each component
        const Real u = std::sin(r.x + r.y) + std::cos(r.z);
        const Real v = -std::sin(r.x + r.y) + std::sin(r.z);
        const Real w = std::cos(2 * r.x) + std::sin(r.y), slope = (u + v) * std::cos(r.x + r.y);
        return Vec3{slope - w * std::sin(r.z), -slope + w * std::cos(r.z),
                    -2 * u * std::sin(2 * r.x) + v * std::cos(r.y)};
    };
    const auto part = [](const Vec3& a, Location c) {
        return c == Location::u ? a.x : c == Location::v ? a.y : a.z;
    };
    VectorField u(g);
    visit({{-1, -1, -1}, {n + 2, n + 1, n + 1}}, [&](Index i, Index j, Index k) {
        for (Location c : components) u[c](i, j, k) = part(flow(g.position(c, i, j, k)), c);
    });
    const Advection<C> N(g, u);
    const View<const Real> view = std::as_const(u)[C].view();
    return largest({{1, 1, 1}, {n - 1, n - 1, n - 1}}, [&](Index i, Index j, Index k) {
        return N(view.offset(i, j, k)) - part(exact(g.position(C, i, j, k)), C);
    });
}

TEST(Advection, IsSecondOrderInEveryComponent)
{
    using enum Location;
    EXPECT_NEAR(std::log2(advection_error<u>(16) / advection_error<u>(32)), 2, 0.2);
    EXPECT_NEAR(std::log2(advection_error<v>(16) / advection_error<v>(32)), 2, 0.2);
    EXPECT_NEAR(std::log2(advection_error<w>(16) / advection_error<w>(32)), 2, 0.2);
}

} // namespace
} // namespace starling
