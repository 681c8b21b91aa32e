#pragma once
/// Tridiagonal solves along x: the only algorithm that crosses x-slabs.
#include "core/array.hpp"
#include "core/for_each.hpp"
#include "parallel/tridiagonal.hpp"

namespace starling {

/// Solves along x for all rows j in [j_begin, j_end), each row `width` lines wide, in place.
/// `data` points at plane 0, row 0; coefficients(i, j, k) gives the matrix rows.
class XLines {
public:
    /// Scratch for `planes` unknowns along x and rows of `width` values, one part per thread.
    XLines(Index planes, Index width) : size_(planes * width), scratch_(size_ * max_threads()) {}

    template <class Coefficients>
    void solve(Real* data, Index stride_x, Index stride_y, Index planes, std::array<Index, 2> rows,
               Index width, Coefficients coefficients)
    {
        Real* scratch = scratch_.data();
        const Index size = size_;
        for_range(rows[0], rows[1], [=](Index j) {
            solve_lines(
                data + j * stride_y, stride_x, planes, width,
                [=](Index i, Index k) { return coefficients(i, j, k); },
                scratch + size * thread_number());
        });
    }

private:
    Index size_;
    Array<Real> scratch_;
};

} // namespace starling
