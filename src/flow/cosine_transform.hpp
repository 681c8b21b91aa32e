#pragma once
/// The cosine transform along y of the Poisson solver.
#include "core/array.hpp"

namespace starling {

/// Transforms n values along one direction for `width` columns at once:
///     X_m = sum_j x_j cos(pi m (j + 1/2)/n),   x_j = (X_0 + 2 sum_{m>0} X_m
///     cos(...))/n,
/// the eigenvectors of the second difference with zero normal derivative half a
/// cell outside. Each is a product with a dense matrix, halved by the symmetry
/// of the cosines about the middle and vectorised across the columns: it
/// allocates nothing, and up to about a hundred values it is faster than a
/// scalar fast transform.
class CosineTransform {
public:
    explicit CosineTransform(Index n);

    /// From n rows of `width` values, each so many `stride` apart, to others or,
    /// where both strides agree, in place. `scratch` holds (n + 1) * width
    /// values.
    void forward(const Real* x, Index x_stride, Real* X, Index X_stride, Index width,
                 Real* scratch) const;
    void backward(const Real* X, Index X_stride, Real* x, Index x_stride, Index width,
                  Real* scratch) const;

private:
    Index n_, half_; ///< half_: rows up to and including the middle one
    /// cos(pi m (j + 1/2)/n) for j < half_: even m, then odd m; [m/2][j] forward,
    /// [j][m/2] with the factors of the inverse backward.
    Array<Real> even_, odd_, even_back_, odd_back_;
};

} // namespace starling
