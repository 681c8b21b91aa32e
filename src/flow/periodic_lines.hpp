#pragma once
/// Periodic implicit diffusion along z for blocks of rows.
#include <cstdint>

#include "core/types.hpp"

namespace starling {

/// Solves (1 - a d^2) x = rhs along z, periodic, for up to `block` rows side by side: the rows are
/// transposed into `scratch`, swept with SIMD across the rows, and put back. The corner entries
/// are removed by the Sherman-Morrison formula. Prescribed nodes have identity rows.
struct PeriodicLines {
    static constexpr Index block = 8;
    static Index scratch_size(Index nz) { return 3 * block * nz; }

    Real a;
    Index nz;

    void solve(Real* x, const std::uint8_t* mask, Index stride, Index rows, Real* scratch) const;
};

} // namespace starling
