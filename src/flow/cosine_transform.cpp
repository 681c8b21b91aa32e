#include "flow/cosine_transform.hpp"

namespace starling {

namespace {

constexpr Index columns = 8; ///< of a block of the product kept in registers
constexpr Index rows = 4;

/// Block of out = A in: `height` rows (at most `rows`), `count` columns (at most `columns`).
template <bool full>
void multiply_block(const Real* A, Index inner, const Real* in, Index in_stride, Real* out,
                    Index out_stride, Index height, Index count)
{
    Real sum[rows][columns] = {};
    const Index last_row = full ? rows : height, last_column = full ? columns : count;
    for (Index j = 0; j < inner; ++j)
        for (Index m = 0; m < last_row; ++m) {
            const Real a = A[m * inner + j];
#pragma omp simd
            for (Index k = 0; k < last_column; ++k) sum[m][k] += a * in[j * in_stride + k];
        }
    for (Index m = 0; m < last_row; ++m)
        for (Index k = 0; k < last_column; ++k) out[m * out_stride + k] = sum[m][k];
}

/// out = A in for a matrix of `height` rows and `inner` columns and `width` right-hand sides.
void multiply(const Real* A, Index height, Index inner, const Real* in, Index in_stride, Real* out,
              Index out_stride, Index width)
{
    for (Index k = 0; k < width; k += columns)
        for (Index m = 0; m < height; m += rows) {
            const Index h = std::min(rows, height - m), w = std::min(columns, width - k);
            const auto block =
                h == rows && w == columns ? multiply_block<true> : multiply_block<false>;
            block(A + m * inner, inner, in + k, in_stride, out + m * out_stride + k, out_stride, h,
                  w);
        }
}

} // namespace

CosineTransform::CosineTransform(Index n)
    : n_(n), half_((n + 1) / 2), even_(half_ * half_), odd_((n / 2) * half_),
      even_back_(half_ * half_), odd_back_(half_ * (n / 2))
{
    const auto cosine = [n](Index m, Index j) {
        return std::cos(pi * static_cast<Real>(m) * (static_cast<Real>(j) + 0.5) /
                        static_cast<Real>(n));
    };
    const Real scale = 1 / static_cast<Real>(n);
    for (Index j = 0; j < half_; ++j) {
        for (Index m = 0; m < half_; ++m) {
            even_[m * half_ + j] = cosine(2 * m, j);
            even_back_[j * half_ + m] = (m == 0 ? 1 : 2) * scale * cosine(2 * m, j);
        }
        for (Index m = 0; m < n / 2; ++m) {
            odd_[m * half_ + j] = cosine(2 * m + 1, j);
            odd_back_[j * (n / 2) + m] = 2 * scale * cosine(2 * m + 1, j);
        }
    }
}

// With e_j = x_j + x_{n-1-j} and o_j = x_j - x_{n-1-j}, even m need e alone and odd m need o.
void CosineTransform::forward(Real* x, Index width, Real* scratch) const
{
    Real *e = scratch, *o = scratch + half_ * width;
    for (Index j = 0; j < half_; ++j) {
        const Real *a = x + j * width, *b = x + (n_ - 1 - j) * width;
        const bool middle = n_ - 1 - j == j;
#pragma omp simd
        for (Index k = 0; k < width; ++k) {
            e[j * width + k] = middle ? a[k] : a[k] + b[k];
            o[j * width + k] = a[k] - b[k];
        }
    }
    multiply(even_.data(), half_, half_, e, width, x, 2 * width, width);
    multiply(odd_.data(), n_ / 2, half_, o, width, x + width, 2 * width, width);
}

void CosineTransform::backward(Real* x, Index width, Real* scratch) const
{
    Real *e = scratch, *o = scratch + half_ * width;
    multiply(even_back_.data(), half_, half_, x, 2 * width, e, width, width);
    multiply(odd_back_.data(), half_, n_ / 2, x + width, 2 * width, o, width, width);
    for (Index j = 0; j < half_; ++j) {
        Real *a = x + j * width, *b = x + (n_ - 1 - j) * width;
#pragma omp simd
        for (Index k = 0; k < width; ++k) {
            const Real even = e[j * width + k], odd = o[j * width + k];
            b[k] = even - odd;
            a[k] = even + odd;
        }
    }
}

} // namespace starling
