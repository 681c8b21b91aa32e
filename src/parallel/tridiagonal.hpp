#pragma once
/// Tridiagonal solves of many lines at once: the Thomas algorithm, vectorised across the lines.
#include "core/array.hpp"
#include "core/types.hpp"

namespace starling {

/// One row of a tridiagonal matrix: lower x(n-1) + diagonal x(n) + upper x(n+1).
struct TridiagonalRow {
    Real lower, diagonal, upper;
};

/// Solves `width` independent systems of `n` unknowns in place. Unknown m of line k is
/// x[m * stride + k]; rows(m) gives a function of k that returns row m of line k (the first row's
/// lower and the last row's upper coefficient are ignored). `scratch` holds n * width values. No
/// pivoting: rows must be diagonally dominant. Calls solved(m), last m first, when unknowns m are
/// final.
template <class Rows, class Solved>
void solve_lines(Real* x, Index stride, Index n, Index width, const Rows rows, Real* scratch,
                 Solved solved)
{
    const auto first = rows(Index{0});
#pragma omp simd
    for (Index k = 0; k < width; ++k) {
        const TridiagonalRow r = first(k);
        const Real inverse = 1 / r.diagonal;
        scratch[k] = r.upper * inverse;
        x[k] *= inverse;
    }
    for (Index m = 1; m < n; ++m) {
        const auto row = rows(m);
        Real* x_m = x + m * stride;
        const Real* x_before = x_m - stride;
        Real* c_m = scratch + m * width;
        const Real* c_before = c_m - width;
#pragma omp simd
        for (Index k = 0; k < width; ++k) {
            const TridiagonalRow r = row(k);
            const Real inverse = 1 / (r.diagonal - r.lower * c_before[k]);
            c_m[k] = r.upper * inverse;
            x_m[k] = (x_m[k] - r.lower * x_before[k]) * inverse;
        }
    }
    solved(n - 1);
    for (Index m = n - 2; m >= 0; --m) {
        Real* x_m = x + m * stride;
        const Real* x_after = x_m + stride;
        const Real* c_m = scratch + m * width;
#pragma omp simd
        for (Index k = 0; k < width; ++k) x_m[k] -= c_m[k] * x_after[k];
        solved(m);
    }
}

template <class Rows>
void solve_lines(Real* x, Index stride, Index n, Index width, const Rows rows, Real* scratch)
{
    solve_lines(x, stride, n, width, rows, scratch, [](Index) {});
}

/// One tridiagonal matrix, eliminated once, for any number of lines that share it. The arithmetic
/// is that of `solve_lines`, so both give the same bits.
class EliminatedLine {
public:
    /// Room for up to `n` unknowns.
    explicit EliminatedLine(Index n) : lower_(n), inverse_(n), upper_(n) {}

    /// Eliminates the matrix whose row m is row(m), m < n.
    template <class Row>
    void set(Index n, Row row)
    {
        n_ = n;
        for (Index m = 0; m < n; ++m) {
            const TridiagonalRow r = row(m);
            lower_[m] = r.lower;
            inverse_[m] = 1 / (m == 0 ? r.diagonal : r.diagonal - r.lower * upper_[m - 1]);
            upper_[m] = r.upper * inverse_[m];
        }
    }

    /// Solves `width` lines in place; unknown m of line k is x[m * stride + k]. Calls solved(m),
    /// last m first, when unknowns m are final.
    template <class Solved>
    void solve(Real* x, Index stride, Index width, Solved solved) const
    {
        for (Index k = 0; k < width; ++k) x[k] *= inverse_[0];
        for (Index m = 1; m < n_; ++m) {
            Real* x_m = x + m * stride;
            const Real* x_before = x_m - stride;
            const Real lower = lower_[m], inverse = inverse_[m];
#pragma omp simd
            for (Index k = 0; k < width; ++k) x_m[k] = (x_m[k] - lower * x_before[k]) * inverse;
        }
        solved(n_ - 1);
        for (Index m = n_ - 2; m >= 0; --m) {
            Real* x_m = x + m * stride;
            const Real* x_after = x_m + stride;
            const Real upper = upper_[m];
#pragma omp simd
            for (Index k = 0; k < width; ++k) x_m[k] -= upper * x_after[k];
            solved(m);
        }
    }
    void solve(Real* x, Index stride, Index width) const
    {
        solve(x, stride, width, [](Index) {});
    }

private:
    Index n_ = 0;
    Array<Real> lower_, inverse_, upper_;
};

} // namespace starling
