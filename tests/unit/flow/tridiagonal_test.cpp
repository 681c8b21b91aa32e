#include "parallel/tridiagonal.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "parallel/x_lines.hpp"
#include "unit/grid/random_fields.hpp"

namespace starling {
namespace {

using support::Random;

constexpr Real round_off = 1e-13;

std::size_t at(Index n) { return static_cast<std::size_t>(n); }

/// Random diagonally dominant rows for n unknowns of `width` lines.
std::vector<TridiagonalRow> random_rows(Index n, Index width, Random& random)
{
    std::vector<TridiagonalRow> rows(at(n * width));
    for (TridiagonalRow& r : rows) {
        r.lower = random();
        r.upper = random();
        r.diagonal = 1.1 * (std::abs(r.lower) + std::abs(r.upper)) + 0.1;
    }
    return rows;
}

/// Row m of the matrix times the line whose unknowns are `stride` apart.
Real multiply(const TridiagonalRow& r, const Real* x, Index stride, Index m, Index n)
{
    return r.diagonal * x[m * stride] + (m > 0 ? r.lower * x[(m - 1) * stride] : 0) +
           (m < n - 1 ? r.upper * x[(m + 1) * stride] : 0);
}

TEST(Tridiagonal, SolutionTimesMatrixIsTheRightHandSide)
{
    Random random;
    for (Index n : {1, 2, 3, 17})
        for (Index width : {1, 2, 7, 8, 13}) {
            const Index stride = width + 3;
            const auto rows = random_rows(n, width, random);
            std::vector<Real> x(at(n * stride)), scratch(at(n * width));
            for (Real& value : x) value = random();
            const std::vector<Real> rhs = x;
            solve_lines(
                x.data(), stride, n, width,
                [&](Index m) { return [&, m](Index k) { return rows[at(m * width + k)]; }; },
                scratch.data());
            for (Index m = 0; m < n; ++m)
                for (Index k = 0; k < width; ++k)
                    EXPECT_NEAR(multiply(rows[at(m * width + k)], x.data() + k, stride, m, n),
                                rhs[at(m * stride + k)], 10 * round_off);
            for (Index m = 0; m < n; ++m) // between the lines
                for (Index k = width; k < stride; ++k)
                    EXPECT_EQ(x[at(m * stride + k)], rhs[at(m * stride + k)]);
        }
}

TEST(Tridiagonal, IdentityRowsKeepTheirValue)
{
    Random random;
    const Index n = 12, width = 9;
    auto rows = random_rows(n, width, random);
    std::vector<Real> x(at(n * width)), scratch(at(n * width));
    for (std::size_t e = 0; e < x.size(); ++e) {
        x[e] = random();
        if (e % 3 == 0 || e < 2 || e + 2 > x.size()) rows[e] = {0, 1, 0};
    }
    const std::vector<Real> rhs = x;
    solve_lines(
        x.data(), width, n, width,
        [&](Index m) { return [&, m](Index k) { return rows[at(m * width + k)]; }; },
        scratch.data());
    for (std::size_t e = 0; e < x.size(); ++e)
        if (rows[e].diagonal == 1 && rows[e].upper == 0) {
            EXPECT_EQ(x[e], rhs[e]);
        }
}

TEST(Tridiagonal, ALineDoesNotDependOnTheOthers)
{
    Random random;
    const Index n = 20, width = 11;
    const auto rows = random_rows(n, width, random);
    std::vector<Real> together(at(n * width)), scratch(at(n * width));
    for (Real& value : together) value = random();
    std::vector<Real> alone = together;
    solve_lines(
        together.data(), width, n, width,
        [&](Index m) { return [&, m](Index k) { return rows[at(m * width + k)]; }; },
        scratch.data());
    for (Index k = 0; k < width; ++k)
        solve_lines(
            alone.data() + k, width, n, 1,
            [&](Index m) { return [&, m](Index) { return rows[at(m * width + k)]; }; },
            scratch.data());
    EXPECT_EQ(together, alone);
}

class XLinesOnThreads : public testing::TestWithParam<int> {
protected:
    void SetUp() override { omp_set_num_threads(GetParam()); }
    void TearDown() override { omp_set_num_threads(before_); }

private:
    int before_ = omp_get_max_threads();
};

TEST_P(XLinesOnThreads, SolveTheColumnsAskedForAndNoOther)
{
    Random random;
    for (Index columns : {5, 256, 700}) {
        const Index planes = 9, stride = columns + 3;
        std::vector<Real> x(at(planes * stride));
        for (Real& value : x) value = random();
        const std::vector<Real> rhs = x;
        const auto row = [](Index i, Index column) {
            const auto real = [](Index n) { return static_cast<Real>(n); };
            return TridiagonalRow{0.1 * real(i), 3 + 0.1 * real(column % 7), 0.3 * real(i % 3)};
        };
        XLines(planes).solve(x.data(), stride, planes, columns, [=](Index i, Index begin) {
            return [=](Index k) { return row(i, begin + k); };
        });
        for (Index i = 0; i < planes; ++i)
            for (Index k = 0; k < stride; ++k) {
                const Index n = i * stride + k;
                const bool solved = k < columns;
                const Real value =
                    solved ? multiply(row(i, k), x.data() + k, stride, i, planes) : x[at(n)];
                EXPECT_NEAR(value, rhs[at(n)], solved ? 10 * round_off : 0);
            }
    }
}

INSTANTIATE_TEST_SUITE_P(OneAndTwo, XLinesOnThreads, testing::Values(1, 2));

} // namespace
} // namespace starling
