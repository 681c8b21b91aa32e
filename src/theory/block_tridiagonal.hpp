#pragma once
/// Direct solution of block tridiagonal systems with blocks of 2 x 2.
#include <array>
#include <vector>

#include "core/types.hpp"

namespace starling {

using Pair = std::array<Real, 2>;
using Block = std::array<Pair, 2>; ///< block[row][column]

/// Row i reads lower[i] y[i-1] + diagonal[i] y[i] + upper[i] y[i+1].
struct BlockTridiagonal {
    std::vector<Block> lower, diagonal, upper;

    explicit BlockTridiagonal(std::size_t rows) : lower(rows), diagonal(rows), upper(rows) {}

    /// Replaces both right-hand sides by the solutions and spoils the matrix. Block elimination
    /// without exchange of rows: a singular leading part gives non-finite results.
    void solve(std::vector<Pair>& a, std::vector<Pair>& b);
};

} // namespace starling
