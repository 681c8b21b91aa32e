#include "flow/periodic_lines.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "unit/grid/random_fields.hpp"

namespace starling {
namespace {

using support::Random;

std::size_t at(Index n) { return static_cast<std::size_t>(n); }

/// Rows of random values with some of them prescribed.
struct Rows {
    Index rows, nz, stride;
    std::vector<Real> x;
    std::vector<std::uint8_t> mask;

    Rows(Index rows_, Index nz_, Real share_prescribed, Random& random)
        : rows(rows_), nz(nz_), stride(nz_ + 2), x(at(rows_ * stride)), mask(x.size())
    {
        for (std::size_t n = 0; n < x.size(); ++n) {
            x[n] = random();
            mask[n] = (1 + random()) / 2 < share_prescribed ? 1 : 0;
        }
    }
    void solve(Real a)
    {
        Array<Real> scratch(PeriodicLines::scratch_size(nz));
        PeriodicLines(a, nz).solve(x.data(), mask.data(), stride, rows, scratch.data());
    }
    /// The matrix times x at node k of a row.
    Real multiply(Real a, Index row, Index k) const
    {
        const Real* r = x.data() + row * stride;
        if (mask[at(row * stride + k)]) return r[k];
        return r[k] - a * (r[(k + nz - 1) % nz] - 2 * r[k] + r[(k + 1) % nz]);
    }
};

void expect_solved(const Rows& before, Real a)
{
    Rows after = before;
    after.solve(a);
    for (Index row = 0; row < after.rows; ++row) {
        for (Index k = 0; k < after.nz; ++k) {
            const std::size_t n = at(row * after.stride + k);
            EXPECT_NEAR(after.multiply(a, row, k), before.x[n], 1e-15 * (20 + 40 * a));
            if (before.mask[n]) {
                EXPECT_EQ(after.x[n], before.x[n]);
            }
        }
        for (Index k = after.nz; k < after.stride; ++k)
            EXPECT_EQ(after.x[at(row * after.stride + k)], before.x[at(row * after.stride + k)]);
    }
}

TEST(PeriodicLines, SolutionTimesMatrixIsTheRightHandSide)
{
    Random random;
    for (Index rows = 1; rows <= PeriodicLines::block; ++rows)
        for (Index nz : {2, 3, 4, 15, 48})
            for (Real a : {1e-3, 0.7, 60.}) expect_solved(Rows(rows, nz, 0, random), a);
}

TEST(PeriodicLines, PrescribedNodesKeepTheirValue)
{
    Random random;
    for (Index rows : {1, 5, 8})
        for (Real share : {0.1, 0.5, 1.})
            for (Real a : {0.7, 60.}) expect_solved(Rows(rows, 24, share, random), a);
}

TEST(PeriodicLines, PrescribedNodesMayBeFirstAndLast)
{
    Random random;
    for (Index nz : {2, 3, 16})
        for (bool first : {true, false})
            for (bool last : {true, false}) {
                Rows lines(3, nz, 0, random);
                for (Index row = 0; row < 3; ++row) {
                    lines.mask[at(row * lines.stride)] = first;
                    lines.mask[at(row * lines.stride + nz - 1)] = last;
                }
                expect_solved(lines, 2.5);
            }
}

TEST(PeriodicLines, KeepsAConstant)
{
    Random random;
    Rows lines(6, 20, 0, random);
    std::ranges::fill(lines.x, 0.3);
    lines.solve(1e4);
    for (Real value : lines.x) EXPECT_NEAR(value, 0.3, 1e-12);
}

TEST(PeriodicLines, BitsOfARowDoNotDependOnItsNeighbours)
{
    Random random;
    const Rows before(PeriodicLines::block, 30, 0.2, random);
    Rows together = before;
    together.solve(1.3);
    for (Index rows : {1, 3, 7})
        for (Index first = 0; first + rows <= before.rows; ++first) {
            Rows part(rows, before.nz, 0, random);
            std::copy_n(before.x.begin() + first * before.stride, part.x.size(), part.x.begin());
            std::copy_n(before.mask.begin() + first * before.stride, part.mask.size(),
                        part.mask.begin());
            part.solve(1.3);
            EXPECT_TRUE(std::equal(part.x.begin(), part.x.end(),
                                   together.x.begin() + first * before.stride));
        }
}

} // namespace
} // namespace starling
