#pragma once
/// Tridiagonal solves of many lines at once: the Thomas algorithm, vectorised across the lines.
#include "core/types.hpp"

namespace starling {

/// One row of a tridiagonal matrix: lower x(n-1) + diagonal x(n) + upper x(n+1).
struct TridiagonalRow {
    Real lower, diagonal, upper;
};

/// Solves `width` independent systems of `n` unknowns in place. Unknown m of line k is
/// x[m * stride + k]; coefficients(m, k) gives its row (the first row's lower and the last row's
/// upper coefficient are ignored). `scratch` holds n * width values. No pivoting: rows must be
/// diagonally dominant.
template <class Coefficients>
void solve_lines(Real* __restrict x, Index stride, Index n, Index width,
                 const Coefficients coefficients, Real* __restrict scratch)
{
#pragma omp simd
    for (Index k = 0; k < width; ++k) {
        const TridiagonalRow r = coefficients(Index{0}, k);
        const Real inverse = 1 / r.diagonal;
        scratch[k] = r.upper * inverse;
        x[k] *= inverse;
    }
    for (Index m = 1; m < n; ++m) {
        Real* __restrict x_m = x + m * stride;
        const Real* x_before = x_m - stride;
        Real* __restrict c_m = scratch + m * width;
        const Real* c_before = c_m - width;
#pragma omp simd
        for (Index k = 0; k < width; ++k) {
            const TridiagonalRow r = coefficients(m, k);
            const Real inverse = 1 / (r.diagonal - r.lower * c_before[k]);
            c_m[k] = r.upper * inverse;
            x_m[k] = (x_m[k] - r.lower * x_before[k]) * inverse;
        }
    }
    for (Index m = n - 2; m >= 0; --m) {
        Real* __restrict x_m = x + m * stride;
        const Real* x_after = x_m + stride;
        const Real* c_m = scratch + m * width;
#pragma omp simd
        for (Index k = 0; k < width; ++k) x_m[k] -= c_m[k] * x_after[k];
    }
}

} // namespace starling
