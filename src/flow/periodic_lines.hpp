#pragma once
/// Periodic implicit diffusion along z for blocks of rows.
#include <cstdint>

#include "core/array.hpp"

namespace starling {

/// Solves (1 - a d^2) x = rhs along z, periodic, for up to `block` rows side by side: the rows are
/// transposed into `scratch`, swept with SIMD across the rows, and put back. The corner entries
/// are removed by the Sherman-Morrison formula. Prescribed nodes have identity rows; blocks
/// without any use a matrix eliminated beforehand, with the same arithmetic.
class PeriodicLines {
public:
    static constexpr Index block = 8;
    /// Of `scratch`, which begins on a cache line.
    static Index scratch_size(Index nz) { return 3 * block * nz; }

    PeriodicLines(Real a, Index nz);

    /// Changes the coefficient a.
    void set(Real a);

    void solve(Real* x, const std::uint8_t* mask, Index stride, Index rows, Real* scratch) const;

private:
    void solve_free(Real* x, Index stride, Index rows, Real* scratch) const;
    void solve_masked(Real* x, const std::uint8_t* mask, Index stride, Index rows,
                      Real* scratch) const;

    Real a_;
    Index nz_;
    Array<Real> q_, upper_, inverse_; ///< of the matrix without prescribed nodes
};

} // namespace starling
