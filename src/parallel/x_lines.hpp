#pragma once
/// Tridiagonal solves along x: the only algorithm that crosses x-slabs.
#include <algorithm>

#include "core/array.hpp"
#include "core/for_each.hpp"
#include "parallel/tridiagonal.hpp"

namespace starling {

/// Solves along x for the columns of a plane: the lines through its values, in memory order. They
/// are swept in chunks, so that a chunk of all planes stays in cache between the two sweeps.
class XLines {
public:
    static constexpr Index chunk = 256; ///< columns

    /// Scratch for `planes` unknowns along x, one part per thread.
    explicit XLines(Index planes) : size_(planes * chunk), scratch_(size_ * max_threads()) {}

    /// Solves, in place, `columns` lines of `planes` unknowns: data[i * stride_x + column].
    /// rows_of(i, column) gives the function of k for matrix row i of the lines from `column` on.
    template <class Rows>
    void solve(Real* data, Index stride_x, Index planes, Index columns, Rows rows_of)
    {
        for_chunks(columns, [=](Index begin, Index width, Real* scratch) {
            solve_lines(
                data + begin, stride_x, planes, width, [=](Index i) { return rows_of(i, begin); },
                scratch);
        });
    }

    /// Calls solve_chunk(begin, width, scratch) for chunks of columns, each thread with its own
    /// scratch.
    template <class SolveChunk>
    void for_chunks(Index columns, SolveChunk solve_chunk)
    {
        Real* scratch = scratch_.data();
        const Index size = size_;
        for_planes(0, (columns + chunk - 1) / chunk, [=](Index n) {
            const Index begin = n * chunk;
            solve_chunk(begin, std::min(chunk, columns - begin), scratch + size * thread_number());
        });
    }

private:
    Index size_;
    Array<Real> scratch_;
};

} // namespace starling
