#include "flow/poisson.hpp"

#include <gtest/gtest.h>

#include "grid/stencils.hpp"
#include "unit/grid/random_fields.hpp"

namespace starling {
namespace {

using support::largest;

struct PoissonOn : testing::TestWithParam<std::array<Index, 3>> {};

TEST_P(PoissonOn, InvertsTheDiscreteLaplacianToRoundOff)
{
    const Grid g(GetParam(), {0, -1, -0.7}, {3.1, 2, 1.4});
    support::Random random;
    ScalarField rhs(g), phi(g);
    support::randomise(g, Location::cell, rhs, random);
    Poisson poisson(g);
    poisson.solve(std::as_const(rhs).view(), phi);
    const Laplacian laplacian(g.spacing());
    const View<const Real> f = std::as_const(phi).view();
    EXPECT_LT(largest(g.unknowns(Location::cell),
                      [&](Index i, Index j, Index k) {
                          return laplacian(f, f.offset(i, j, k)) - rhs(i, j, k);
                      }),
              1e-12);
}

TEST_P(PoissonOn, RecoversTheFieldFromItsLaplacian)
{
    const Grid g(GetParam(), {0, -1, -0.7}, {3.1, 2, 1.4});
    support::Random random;
    ScalarField expected(g), phi(g);
    support::randomise(g, Location::cell, expected, random);
    fill_increment_halo(g, expected);
    const Laplacian laplacian(g.spacing());
    const View<const Real> f = std::as_const(expected).view();
    Poisson poisson(g);
    poisson.solve([=](Index i, Index j, Index k) { return laplacian(f, f.offset(i, j, k)); }, phi);
    const Box with_halo{{-1, -1, -1}, {g.nx() + 1, g.ny() + 1, g.nz() + 1}};
    EXPECT_LT(
        largest(with_halo, [&](Index i, Index j, Index k) { return phi(i, j, k) - f(i, j, k); }),
        1e-12);
}

using Cells = std::array<Index, 3>;
std::string name(const Cells& n)
{
    return std::to_string(n[0]) + "x" + std::to_string(n[1]) + "x" + std::to_string(n[2]);
}

INSTANTIATE_TEST_SUITE_P(EvenAndOddCounts, PoissonOn,
                         testing::Values(Cells{12, 8, 10}, Cells{13, 8, 10}, Cells{12, 9, 10},
                                         Cells{12, 8, 15}, Cells{7, 9, 15}, Cells{2, 2, 2},
                                         Cells{3, 3, 3}, Cells{64, 48, 50}),
                         [](const auto& cells) { return name(cells.param); });

/// Largest error for phi = sin(pi x/L) cos(pi y/W) (1 + sin(2 pi z/W)).
Real error_on(Index n)
{
    const Real L = 3, W = 2;
    const Grid g({n, n, n}, {0, 0, 0}, {L, W, W});
    const auto exact = [&](Index i, Index j, Index k) {
        const Vec3 r = g.position(Location::cell, i, j, k);
        return std::sin(pi * r.x / L) * std::cos(pi * r.y / W) * (1 + std::sin(2 * pi * r.z / W));
    };
    const auto rhs = [&](Index i, Index j, Index k) {
        const Vec3 r = g.position(Location::cell, i, j, k);
        const Real mean = -pi * pi * (1 / (L * L) + 1 / (W * W)),
                   wave = mean - 4 * pi * pi / (W * W);
        return std::sin(pi * r.x / L) * std::cos(pi * r.y / W) *
               (mean + wave * std::sin(2 * pi * r.z / W));
    };
    Poisson poisson(g);
    ScalarField phi(g);
    poisson.solve(rhs, phi);
    return largest(g.unknowns(Location::cell),
                   [&](Index i, Index j, Index k) { return phi(i, j, k) - exact(i, j, k); });
}

TEST(Poisson, IsSecondOrder)
{
    const Real coarse = error_on(12), fine = error_on(24);
    RecordProperty("order", std::to_string(std::log2(coarse / fine)));
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.05);
}

TEST(Poisson, OneAndTwoThreadsGiveTheSameBits)
{
    const Grid g({31, 18, 20}, {0, 0, 0}, {3, 2, 2});
    support::Random random;
    ScalarField rhs(g);
    support::randomise(g, Location::cell, rhs, random);
    const int before = omp_get_max_threads();
    std::array<ScalarField, 2> phi{ScalarField(g), ScalarField(g)};
    for (int threads : {1, 2}) {
        omp_set_num_threads(threads);
        Poisson poisson(g);
        poisson.solve(std::as_const(rhs).view(), phi[static_cast<std::size_t>(threads - 1)]);
    }
    omp_set_num_threads(before);
    EXPECT_TRUE(std::ranges::equal(phi[0].values(), phi[1].values()));
}

} // namespace
} // namespace starling
