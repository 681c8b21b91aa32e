#pragma once
/// The cosine transform along y of the Poisson solver.
#include <memory>

#include "core/array.hpp"

namespace starling {

/// Transforms n complex values along one direction for `columns` columns at once:
///     X_m = sum_j x_j cos(pi m (j + 1/2)/n),   x_j = (X_0 + 2 sum_{m>0} X_m cos(...))/n,
/// the eigenvectors of the second difference with zero normal derivative half a cell outside. Real
/// and imaginary parts are transformed alike, by one complex Fourier transform of length n.
/// Source: Makhoul, IEEE Trans. Acoust. Speech Signal Process. 28 (1980), 27-34.
class CosineTransform {
public:
    CosineTransform(Index n, Index columns);
    ~CosineTransform();
    CosineTransform(const CosineTransform&) = delete;
    CosineTransform& operator=(const CosineTransform&) = delete;

    /// The row of x that lies at place m. The transform takes those of even number upwards, then
    /// those of odd number downwards.
    Index row_at(Index m) const { return m < (n_ + 1) / 2 ? 2 * m : 2 * (n_ - 1 - m) + 1; }

    /// All arrays hold n rows of `columns` values, real and imaginary parts alternating, and begin
    /// at a multiple of 16 bytes; the rows of x in the order of `row_at`. X may be x.
    void forward(const Real* x, Real* work, Real* X) const;
    /// The inverse.
    void backward(const Real* X, Real* work, Real* x) const;

private:
    struct Plans;

    Index n_, row_;         ///< row_: reals in a row
    Array<Real> cos_, sin_; ///< of pi m/(2 n)
    std::unique_ptr<Plans> plans_;
};

} // namespace starling
