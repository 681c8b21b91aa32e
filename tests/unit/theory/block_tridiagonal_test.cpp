#include "theory/block_tridiagonal.hpp"

#include <gtest/gtest.h>

#include <random>

namespace starling {
namespace {

Pair times(const Block& m, const Pair& v)
{
    return {m[0][0] * v[0] + m[0][1] * v[1], m[1][0] * v[0] + m[1][1] * v[1]};
}

TEST(BlockTridiagonal, ReproducesBothSolutionsToRoundOff)
{
    constexpr std::size_t n = 40;
    std::mt19937 generator(1);
    std::uniform_real_distribution<Real> number(-1, 1);
    BlockTridiagonal matrix(n);
    std::vector<Pair> a(n), b(n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t r : {0u, 1u}) {
            a[i][r] = number(generator);
            b[i][r] = number(generator);
            for (std::size_t c : {0u, 1u}) {
                matrix.lower[i][r][c] = number(generator);
                matrix.upper[i][r][c] = number(generator);
                matrix.diagonal[i][r][c] = number(generator) + (r == c ? 5 : 0);
            }
        }
    const auto product = [matrix](const std::vector<Pair>& y) {
        std::vector<Pair> result(n);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t r : {0u, 1u}) {
                result[i][r] = times(matrix.diagonal[i], y[i])[r];
                if (i > 0) result[i][r] += times(matrix.lower[i], y[i - 1])[r];
                if (i + 1 < n) result[i][r] += times(matrix.upper[i], y[i + 1])[r];
            }
        return result;
    };
    std::vector<Pair> of_a = product(a), of_b = product(b);
    matrix.solve(of_a, of_b);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t r : {0u, 1u}) {
            EXPECT_NEAR(of_a[i][r], a[i][r], 1e-13);
            EXPECT_NEAR(of_b[i][r], b[i][r], 1e-13);
        }
}

} // namespace
} // namespace starling
