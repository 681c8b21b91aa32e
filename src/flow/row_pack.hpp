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
    const RowPack* a = tile.pack;
    const RowPack even_01 = __builtin_shufflevector(a[0], a[1], 0, 4, 2, 6);
    const RowPack even_23 = __builtin_shufflevector(a[2], a[3], 0, 4, 2, 6);
    const RowPack odd_01 = __builtin_shufflevector(a[0], a[1], 1, 5, 3, 7);
    const RowPack odd_23 = __builtin_shufflevector(a[2], a[3], 1, 5, 3, 7);
    return {__builtin_shufflevector(even_01, even_23, 0, 1, 4, 5),
            __builtin_shufflevector(odd_01, odd_23, 0, 1, 4, 5),
            __builtin_shufflevector(even_01, even_23, 2, 3, 6, 7),
            __builtin_shufflevector(odd_01, odd_23, 2, 3, 6, 7)};
}

} // namespace starling
