#include "flow/cosine_transform.hpp"

#include <algorithm>

#include <fftw3.h>

namespace starling {

/// FFTW plans of all columns. Planned by estimate: measured plans differ from run to run, and with
/// them the last bits of the result. From one array to another: estimated plans in place are
/// slower, and some allocate in every call.
struct CosineTransform::Plans {
    Plans(Index n, Index columns)
        : forward(plan(n, columns, FFTW_FORWARD)), backward(plan(n, columns, FFTW_BACKWARD))
    {
    }
    ~Plans()
    {
        fftw_destroy_plan(forward);
        fftw_destroy_plan(backward);
    }
    Plans(const Plans&) = delete;
    Plans& operator=(const Plans&) = delete;

    static fftw_complex* complex(Real* values) { return reinterpret_cast<fftw_complex*>(values); }
    static fftw_plan plan(Index n, Index columns, int direction)
    {
        const int length = static_cast<int>(n), count = static_cast<int>(columns);
        Array<Real> from(2 * n * columns), to(from.size());
        return fftw_plan_many_dft(1, &length, count, complex(from.data()), nullptr, count, 1,
                                  complex(to.data()), nullptr, count, 1, direction, FFTW_ESTIMATE);
    }

    fftw_plan forward, backward;
};

CosineTransform::CosineTransform(Index n, Index columns)
    : n_(n), row_(2 * columns), cos_(n), sin_(n), plans_(std::make_unique<Plans>(n, columns))
{
    for (Index m = 0; m < n; ++m) {
        const Real phase = pi * static_cast<Real>(m) / (2 * static_cast<Real>(n));
        cos_[m] = std::cos(phase);
        sin_[m] = std::sin(phase);
    }
}

CosineTransform::~CosineTransform() = default;

// V is the Fourier transform of the rows in the order of row_at, w = exp(-i pi m/(2 n)). Of real
// values, w V_m = X_m - i X_{n-m}. Of complex ones, with X = A + i B and q = n - m, therefore
//     w_m V_m = (A_m + B_q) + i (B_m - A_q),   w_q V_q = (A_q + B_m) + i (B_q - A_m).
void CosineTransform::forward(const Real* x, Real* work, Real* X) const
{
    // FFTW takes no const pointer, but leaves its input alone.
    fftw_execute_dft(plans_->forward, Plans::complex(const_cast<Real*>(x)), Plans::complex(work));
    std::copy_n(work, row_, X);
    for (Index m = 1; m <= n_ / 2; ++m) {
        const Index q = n_ - m;
        const Real *V_m = work + m * row_, *V_q = work + q * row_;
        Real *X_m = X + m * row_, *X_q = X + q * row_;
        const Real c = cos_[m] / 2, s = sin_[m] / 2;
#pragma omp simd
        for (Index k = 0; k < row_; k += 2) {
            const Real re_m = c * V_m[k] + s * V_m[k + 1], im_m = c * V_m[k + 1] - s * V_m[k];
            const Real re_q = s * V_q[k] + c * V_q[k + 1], im_q = s * V_q[k + 1] - c * V_q[k];
            X_m[k] = re_m - im_q;
            X_m[k + 1] = re_q + im_m;
            X_q[k] = re_q - im_m;
            X_q[k + 1] = re_m + im_q;
        }
    }
}

void CosineTransform::backward(const Real* X, Real* work, Real* x) const
{
    const Real scale = 1 / static_cast<Real>(n_);
    for (Index k = 0; k < row_; ++k) work[k] = scale * X[k];
    for (Index m = 1; m <= n_ / 2; ++m) {
        const Index q = n_ - m;
        const Real *X_m = X + m * row_, *X_q = X + q * row_;
        Real *V_m = work + m * row_, *V_q = work + q * row_;
        const Real c = scale * cos_[m], s = scale * sin_[m];
#pragma omp simd
        for (Index k = 0; k < row_; k += 2) {
            const Real re_m = X_m[k] + X_q[k + 1], im_m = X_m[k + 1] - X_q[k];
            const Real re_q = X_q[k] + X_m[k + 1], im_q = X_q[k + 1] - X_m[k];
            V_m[k] = c * re_m - s * im_m;
            V_m[k + 1] = c * im_m + s * re_m;
            V_q[k] = s * re_q - c * im_q;
            V_q[k + 1] = s * im_q + c * re_q;
        }
    }
    fftw_execute_dft(plans_->backward, Plans::complex(work), Plans::complex(x));
}

} // namespace starling
