#include "flow/periodic_lines.hpp"

namespace starling {

namespace {

constexpr Index b = PeriodicLines::block;

/// Transposes `rows` rows of nz values, `stride` apart, into nz groups of b values. Missing rows
/// repeat the first one.
void load_transposed(const Real* x, Index stride, Index rows, Index nz, Real* __restrict y)
{
    const Real* row[b];
    for (Index r = 0; r < b; ++r) row[r] = x + (r < rows ? r : 0) * stride;
    for (Index k = 0; k < nz; ++k)
        for (Index r = 0; r < b; ++r) y[k * b + r] = row[r][k];
}

/// The coefficient a, or 0 at prescribed nodes, transposed likewise.
void load_active(const std::uint8_t* mask, Index stride, Index rows, Index nz, Real a,
                 Real* __restrict c)
{
    for (Index n = 0; n < b * nz; ++n) c[n] = a;
    for (Index r = 0; r < rows; ++r)
        for (Index k = 0; k < nz; ++k)
            if (mask[r * stride + k]) c[k * b + r] = 0;
}

bool any_prescribed(const std::uint8_t* mask, Index stride, Index rows, Index nz)
{
    std::uint8_t any = 0;
    for (Index r = 0; r < rows; ++r)
        for (Index k = 0; k < nz; ++k) any |= mask[r * stride + k];
    return any != 0;
}

/// x = y - factor q, back in rows; factor(r) and q(k, r) are functions.
template <class Factor, class Q>
void store_transposed(const Real* y, Factor factor, Q q, Index stride, Index rows, Index nz,
                      Real* x)
{
    for (Index r = 0; r < rows; ++r) {
        const Real f = factor(r);
        for (Index k = 0; k < nz; ++k) x[r * stride + k] = y[k * b + r] - f * q(k, r);
    }
}

} // namespace

PeriodicLines::PeriodicLines(Real a, Index nz) : a_(-1), nz_(nz), q_(nz), upper_(nz), inverse_(nz)
{
    set(a);
}

// With corners c_0 = -a_0 (row 0, column nz-1) and c_n = -a_n (row nz-1, column 0), the matrix is
// T + g s^T with g = (gamma, 0, ..., c_n), s = (1, 0, ..., c_0/gamma); T is tridiagonal. Then
// x = y - q (s.y)/(1 + s.q) with T y = rhs and T q = g.
void PeriodicLines::set(Real a)
{
    if (a == a_) return;
    a_ = a;
    const Index n = nz_ - 1;
    const Real gamma = -(1 + 2 * a), corner = -a;
    inverse_[0] = 1 / (1 + 2 * a - gamma);
    q_[0] = gamma * inverse_[0];
    upper_[0] = -a * inverse_[0];
    for (Index k = 1; k < n; ++k) {
        inverse_[k] = 1 / (1 + 2 * a + a * upper_[k - 1]);
        q_[k] = a * q_[k - 1] * inverse_[k];
        upper_[k] = -a * inverse_[k];
    }
    const Real d = 1 + 2 * a - corner * corner / gamma;
    inverse_[n] = 1 / (d + a * upper_[n - 1]);
    q_[n] = (corner + a * q_[n - 1]) * inverse_[n];
    for (Index k = n - 1; k >= 0; --k) q_[k] -= upper_[k] * q_[k + 1];
}

void PeriodicLines::solve(Real* x, const std::uint8_t* mask, Index stride, Index rows,
                          Real* scratch) const
{
    if (any_prescribed(mask, stride, rows, nz_))
        solve_masked(x, mask, stride, rows, scratch);
    else
        solve_free(x, stride, rows, scratch);
}

void PeriodicLines::solve_free(Real* x, Index stride, Index rows, Real* scratch) const
{
    const Index nz = nz_, n = nz - 1;
    const Real a = a_, s_n = -a / -(1 + 2 * a);
    const Real *q = q_.data(), *upper = upper_.data(), *inverse = inverse_.data();
    Real* __restrict y = scratch;
    load_transposed(x, stride, rows, nz, y);
    for (Index r = 0; r < b; ++r) y[r] *= inverse[0];
    for (Index k = 1; k <= n; ++k) {
        Real* y_k = y + k * b;
#pragma omp simd
        for (Index r = 0; r < b; ++r) y_k[r] = (y_k[r] + a * y_k[r - b]) * inverse[k];
    }
    for (Index k = n - 1; k >= 0; --k) {
        Real* y_k = y + k * b;
#pragma omp simd
        for (Index r = 0; r < b; ++r) y_k[r] -= upper[k] * y_k[r + b];
    }
    const Real divisor = 1 + q[0] + s_n * q[n];
    store_transposed(
        y, [&](Index r) { return (y[r] + s_n * y[n * b + r]) / divisor; },
        [&](Index k, Index) { return q[k]; }, stride, rows, nz, x);
}

void PeriodicLines::solve_masked(Real* x, const std::uint8_t* mask, Index stride, Index rows,
                                 Real* scratch) const
{
    const Real a = a_;
    const Index nz = nz_;
    Real* __restrict y = scratch;              // [k][row]
    Real* __restrict q = scratch + b * nz;     // [k][row]
    Real* __restrict c = scratch + 2 * b * nz; // upper coefficient after elimination
    const Index n = nz - 1;

    load_transposed(x, stride, rows, nz, y);
    load_active(mask, stride, rows, nz, a, c); // turned into the upper coefficient below
    Real corner_0[b], corner_n[b], gamma[b];
#pragma omp simd
    for (Index r = 0; r < b; ++r) {
        const Real a_0 = c[r], a_n = c[n * b + r];
        corner_0[r] = -a_0;
        corner_n[r] = -a_n;
        gamma[r] = -(1 + 2 * a_0);
        const Real inverse = 1 / (1 + 2 * a_0 - gamma[r]);
        y[r] *= inverse;
        q[r] = gamma[r] * inverse;
        c[r] = -a_0 * inverse;
    }
    for (Index k = 1; k < n; ++k) {
        Real *y_k = y + k * b, *q_k = q + k * b, *c_k = c + k * b;
#pragma omp simd
        for (Index r = 0; r < b; ++r) {
            const Real a_k = c_k[r];
            const Real inverse = 1 / (1 + 2 * a_k + a_k * c_k[r - b]);
            y_k[r] = (y_k[r] + a_k * y_k[r - b]) * inverse;
            q_k[r] = a_k * q_k[r - b] * inverse;
            c_k[r] = -a_k * inverse;
        }
    }
    Real factor[b];
    {
        Real *y_n = y + n * b, *q_n = q + n * b, *c_n = c + n * b;
#pragma omp simd
        for (Index r = 0; r < b; ++r) {
            const Real a_n = c_n[r];
            const Real d = 1 + 2 * a_n - corner_n[r] * corner_0[r] / gamma[r];
            const Real inverse = 1 / (d + a_n * c_n[r - b]);
            y_n[r] = (y_n[r] + a_n * y_n[r - b]) * inverse;
            q_n[r] = (corner_n[r] + a_n * q_n[r - b]) * inverse;
        }
    }
    for (Index k = n - 1; k >= 0; --k) {
        Real *y_k = y + k * b, *q_k = q + k * b;
        const Real* c_k = c + k * b;
#pragma omp simd
        for (Index r = 0; r < b; ++r) {
            y_k[r] -= c_k[r] * y_k[r + b];
            q_k[r] -= c_k[r] * q_k[r + b];
        }
    }
#pragma omp simd
    for (Index r = 0; r < b; ++r) {
        const Real s_n = corner_0[r] / gamma[r];
        factor[r] = (y[r] + s_n * y[n * b + r]) / (1 + q[r] + s_n * q[n * b + r]);
    }
    store_transposed(
        y, [&](Index r) { return factor[r]; }, [&](Index k, Index r) { return q[k * b + r]; },
        stride, rows, nz, x);
}

} // namespace starling
