#include "flow/cosine_transform.hpp"

namespace starling {

namespace {

constexpr Index wide = 16; ///< columns of a block of the product kept in registers

/// Block of out = A in: `rows` rows and `wide` columns, or `width` if it is not whole.
template <Index rows, bool whole>
void multiply_block(const Real* A, Index inner, const Real* in, Index in_stride, Real* out,
                    Index out_stride, Index width)
{
    const Index columns = whole ? wide : width;
    Real sum[rows][wide] = {};
    for (Index j = 0; j < inner; ++j)
        for (Index m = 0; m < rows; ++m) {
            const Real a = A[m * inner + j];
#pragma omp simd
            for (Index k = 0; k < columns; ++k) sum[m][k] += a * in[j * in_stride + k];
        }
    for (Index m = 0; m < rows; ++m)
        for (Index k = 0; k < columns; ++k) out[m * out_stride + k] = sum[m][k];
}

/// The block's columns of out = A in, for a matrix of `height` rows and `inner` columns.
template <bool whole>
void multiply_columns(const Real* A, Index height, Index inner, const Real* in, Index in_stride,
                      Real* out, Index out_stride, Index width)
{
    Index m = 0;
    for (; m + 4 <= height; m += 4)
        multiply_block<4, whole>(A + m * inner, inner, in, in_stride, out + m * out_stride,
                                 out_stride, width);
    for (; m < height; ++m)
        multiply_block<1, whole>(A + m * inner, inner, in, in_stride, out + m * out_stride,
                                 out_stride, width);
}

/// out = A in for a matrix of `height` rows and `inner` columns and `width` right-hand sides; the
/// last block overlaps the one before it, so that all are whole.
void multiply(const Real* A, Index height, Index inner, const Real* in, Index in_stride, Real* out,
              Index out_stride, Index width)
{
    if (width < wide)
        return multiply_columns<false>(A, height, inner, in, in_stride, out, out_stride, width);
    for (Index next = 0; next < width; next += wide) {
        const Index k = std::min(next, width - wide);
        multiply_columns<true>(A, height, inner, in + k, in_stride, out + k, out_stride, wide);
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

// With e_j = x_j + x_{n-1-j} and o_j = x_j - x_{n-1-j}, even m need e alone and
// odd m need o.
void CosineTransform::forward(const Real* x, Index x_stride, Real* X, Index X_stride, Index width,
                              Real* scratch) const
{
    Real *e = scratch, *o = scratch + half_ * width;
    for (Index j = 0; j < half_; ++j) {
        const Real *a = x + j * x_stride, *b = x + (n_ - 1 - j) * x_stride;
        const bool middle = n_ - 1 - j == j;
#pragma omp simd
        for (Index k = 0; k < width; ++k) {
            e[j * width + k] = middle ? a[k] : a[k] + b[k];
            o[j * width + k] = a[k] - b[k];
        }
    }
    multiply(even_.data(), half_, half_, e, width, X, 2 * X_stride, width);
    multiply(odd_.data(), n_ / 2, half_, o, width, X + X_stride, 2 * X_stride, width);
}

void CosineTransform::backward(const Real* X, Index X_stride, Real* x, Index x_stride, Index width,
                               Real* scratch) const
{
    Real *e = scratch, *o = scratch + half_ * width;
    multiply(even_back_.data(), half_, half_, X, 2 * X_stride, e, width, width);
    multiply(odd_back_.data(), half_, n_ / 2, X + X_stride, 2 * X_stride, o, width, width);
    for (Index j = 0; j < half_; ++j) {
        Real *a = x + j * x_stride, *b = x + (n_ - 1 - j) * x_stride;
#pragma omp simd
        for (Index k = 0; k < width; ++k) {
            const Real even = e[j * width + k], odd = o[j * width + k];
            b[k] = even - odd;
            a[k] = even + odd;
        }
    }
}

} // namespace starling
