#include "flow/periodic_lines.hpp"

#include <cstring>

#include "flow/row_pack.hpp"

namespace starling {

namespace {

constexpr Index b = PeriodicLines::block;
constexpr Index packs = b / 4; ///< packs of four rows

/// Transposes `rows` rows of nz values, `stride` apart, into nz groups of `packs` packs. Missing
/// rows repeat the first one.
void load_transposed(const Real* x, Index stride, Index rows, Index nz, RowPack* y)
{
    const Real* row[b];
    for (Index r = 0; r < b; ++r) row[r] = x + (r < rows ? r : 0) * stride;
    Index k = 0;
    for (; k + 4 <= nz; k += 4)
        for (Index p = 0; p < packs; ++p) {
            const Real* const* from = row + 4 * p;
            const RowTile tile = transposed(
                {load(from[0] + k), load(from[1] + k), load(from[2] + k), load(from[3] + k)});
            for (Index m = 0; m < 4; ++m) y[(k + m) * packs + p] = tile.pack[m];
        }
    for (; k < nz; ++k)
        for (Index r = 0; r < b; ++r) y[k * packs + r / 4][r % 4] = row[r][k];
}

/// x = y - factor q, back in rows; q(k, p) is a function.
template <class Q>
void store_transposed(const RowPack* y, const RowPack* factor, Q q, Index stride, Index rows,
                      Index nz, Real* x)
{
    const auto value = [=](Index k, Index p) { return y[k * packs + p] - factor[p] * q(k, p); };
    Index k = 0;
    for (; k + 4 <= nz; k += 4)
        for (Index p = 0; p < packs; ++p) {
            const RowTile tile =
                transposed({value(k, p), value(k + 1, p), value(k + 2, p), value(k + 3, p)});
            for (Index r = 4 * p; r < std::min(4 * p + 4, rows); ++r)
                store(tile.pack[r % 4], x + r * stride + k);
        }
    for (; k < nz; ++k)
        for (Index r = 0; r < rows; ++r) x[r * stride + k] = value(k, r / 4)[r % 4];
}

/// Calls found(k) for the prescribed nodes k of one row, eight nodes at a time.
template <class Found>
void for_prescribed(const std::uint8_t* mask, Index nz, Found found)
{
    Index k = 0;
    for (; k + 8 <= nz; k += 8) {
        std::uint64_t eight;
        std::memcpy(&eight, mask + k, 8);
        for (Index m = k; eight != 0; eight >>= 8, ++m)
            if (eight & 255) found(m);
    }
    for (; k < nz; ++k)
        if (mask[k]) found(k);
}

/// The coefficient a, or 0 at prescribed nodes, transposed likewise.
void load_active(const std::uint8_t* mask, Index stride, Index rows, Index nz, Real a, RowPack* c)
{
    for (Index n = 0; n < packs * nz; ++n) c[n] = RowPack{} + a;
    for (Index r = 0; r < rows; ++r)
        for_prescribed(mask + r * stride, nz, [=](Index k) { c[k * packs + r / 4][r % 4] = 0; });
}

bool any_prescribed(const std::uint8_t* mask, Index stride, Index rows, Index nz)
{
    std::uint8_t any = 0;
    for (Index r = 0; r < rows; ++r)
        for (Index k = 0; k < nz; ++k) any |= mask[r * stride + k];
    return any != 0;
}

/// Forward elimination of y and q, from the second to the last but one; c comes in as a. What the
/// next node needs stays in registers.
void eliminate(RowPack* y, RowPack* q, RowPack* c, Index nz)
{
    RowPack y_before[packs], q_before[packs], c_before[packs];
    for (Index p = 0; p < packs; ++p) y_before[p] = y[p], q_before[p] = q[p], c_before[p] = c[p];
    for (Index k = 1; k < nz - 1; ++k)
        for (Index p = 0; p < packs; ++p) {
            const Index m = k * packs + p;
            const RowPack a = c[m], inverse = 1 / (1 + 2 * a + a * c_before[p]);
            y[m] = y_before[p] = (y[m] + a * y_before[p]) * inverse;
            q[m] = q_before[p] = a * q_before[p] * inverse;
            c[m] = c_before[p] = -a * inverse;
        }
}

void substitute_back(RowPack* y, RowPack* q, const RowPack* c, Index nz)
{
    RowPack y_after[packs], q_after[packs];
    for (Index p = 0, n = packs * (nz - 1); p < packs; ++p)
        y_after[p] = y[n + p], q_after[p] = q[n + p];
    for (Index k = nz - 2; k >= 0; --k)
        for (Index p = 0; p < packs; ++p) {
            const Index m = k * packs + p;
            y[m] = y_after[p] = y[m] - c[m] * y_after[p];
            q[m] = q_after[p] = q[m] - c[m] * q_after[p];
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
    auto* y = reinterpret_cast<RowPack*>(scratch); // [k][pack]
    load_transposed(x, stride, rows, nz, y);
    RowPack next[packs] = {}; // y at the node before, then at the node after
    for (Index k = 0; k <= n; ++k)
        for (Index p = 0; p < packs; ++p)
            next[p] = y[k * packs + p] = (y[k * packs + p] + a * next[p]) * inverse[k];
    for (Index k = n - 1; k >= 0; --k)
        for (Index p = 0; p < packs; ++p)
            next[p] = y[k * packs + p] = y[k * packs + p] - upper[k] * next[p];
    const Real divisor = 1 + q[0] + s_n * q[n];
    RowPack factor[packs];
    for (Index p = 0; p < packs; ++p) factor[p] = (y[p] + s_n * y[n * packs + p]) / divisor;
    store_transposed(
        y, factor, [=](Index k, Index) { return q[k]; }, stride, rows, nz, x);
}

void PeriodicLines::solve_masked(Real* x, const std::uint8_t* mask, Index stride, Index rows,
                                 Real* scratch) const
{
    const Index nz = nz_, n = packs * (nz - 1);    // the last group of packs
    auto* y = reinterpret_cast<RowPack*>(scratch); // [k][pack]
    RowPack* q = y + packs * nz;
    RowPack* c = q + packs * nz; // a, then the upper coefficient after elimination
    load_transposed(x, stride, rows, nz, y);
    load_active(mask, stride, rows, nz, a_, c);

    RowPack a_0[packs], gamma[packs], factor[packs];
    for (Index p = 0; p < packs; ++p) {
        a_0[p] = c[p];
        gamma[p] = -(1 + 2 * a_0[p]);
        const RowPack inverse = 1 / (1 + 2 * a_0[p] - gamma[p]);
        y[p] *= inverse;
        q[p] = gamma[p] * inverse;
        c[p] = -a_0[p] * inverse;
    }
    eliminate(y, q, c, nz);
    for (Index p = 0; p < packs; ++p) {
        const RowPack a_n = c[n + p], corner_0 = -a_0[p], corner_n = -a_n;
        const RowPack d = 1 + 2 * a_n - corner_n * corner_0 / gamma[p];
        const RowPack inverse = 1 / (d + a_n * c[n + p - packs]);
        y[n + p] = (y[n + p] + a_n * y[n + p - packs]) * inverse;
        q[n + p] = (corner_n + a_n * q[n + p - packs]) * inverse;
    }
    substitute_back(y, q, c, nz);
    for (Index p = 0; p < packs; ++p) {
        const RowPack s_n = -a_0[p] / gamma[p];
        factor[p] = (y[p] + s_n * y[n + p]) / (1 + q[p] + s_n * q[n + p]);
    }
    store_transposed(
        y, factor, [=](Index k, Index p) { return q[k * packs + p]; }, stride, rows, nz, x);
}

} // namespace starling
