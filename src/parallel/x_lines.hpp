#pragma once
/// Tridiagonal solves along x: the only algorithm that crosses x-slabs.
#include "core/array.hpp"
#include "core/for_each.hpp"
#include "parallel/tridiagonal.hpp"

namespace starling {

/// Solves along x for all rows j in [j_begin, j_end), each row `width` lines wide, in place.
/// `data` points at plane 0, row 0; rows(i, j) gives
/// the function of k for matrix row i of the lines of row j.
class XLines {
public:
    /// Scratch for `planes` unknowns along x and rows of `width` values, one part per thread.
    XLines(Index planes, Index width) : size_(planes * width), scratch_(size_ * max_threads()) {}

    template <class Rows>
    void solve(Real* data, Index stride_x, Index stride_y, Index planes, std::array<Index, 2> rows,
               Index width, Rows rows_of)
    {
        for_rows(rows, [=](Index j, Real* scratch) {
            solve_lines(
                data + j * stride_y, stride_x, planes, width,
                [=](Index i) { return rows_of(i, j); }, scratch);
        });
    }

    /// Calls solve_row(j, scratch) for the rows, each thread with its own scratch.
    template <class SolveRow>
    void for_rows(std::array<Index, 2> rows, SolveRow solve_row)
    {
        Real* scratch = scratch_.data();
        const Index size = size_;
        for_range(rows[0], rows[1],
                  [=](Index j) { solve_row(j, scratch + size * thread_number()); });
    }

private:
    Index size_;
    Array<Real> scratch_;
};

} // namespace starling
