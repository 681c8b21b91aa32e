#pragma once
/// Rows side by side in SIMD registers, and the transposition that puts them there.
#include <cstring>

#include "core/types.hpp"

namespace starling {

/// One value of each of four rows; arithmetic acts on all four.
using RowPack __attribute__((vector_size(4 * sizeof(Real)), may_alias)) = Real;

/// Four values from and to any address.
inline RowPack load(const Real* x)
{
    RowPack a;
    std::memcpy(&a, x, sizeof a);
    return a;
}
inline void store(RowPack a, Real* x) { std::memcpy(x, &a, sizeof a); }

/// Four packs of four values.
struct RowTile {
    RowPack pack[4];
};

/// The transpose: value r of pack k becomes value k of pack r.
inline RowTile transposed(const RowTile& tile)
{
    using Pick __attribute__((vector_size(4 * sizeof(Real)))) = std::int64_t;
    const Pick even = {0, 4, 2, 6}, odd = {1, 5, 3, 7}, low = {0, 1, 4, 5}, high = {2, 3, 6, 7};
    const RowPack* a = tile.pack;
    const RowPack even_01 = __builtin_shuffle(a[0], a[1], even);
    const RowPack even_23 = __builtin_shuffle(a[2], a[3], even);
    const RowPack odd_01 = __builtin_shuffle(a[0], a[1], odd);
    const RowPack odd_23 = __builtin_shuffle(a[2], a[3], odd);
    return {__builtin_shuffle(even_01, even_23, low), __builtin_shuffle(odd_01, odd_23, low),
            __builtin_shuffle(even_01, even_23, high), __builtin_shuffle(odd_01, odd_23, high)};
}

} // namespace starling
