#include "flow/poisson.hpp"

#include <fftw3.h>

#include "grid/boundary.hpp"

namespace starling {

/// FFTW plans of the rows of one x-plane, from one array to another. Planned by estimate: measured
/// plans differ from run to run, and with them the last bits of the result.
struct Poisson::Plans {
    Plans(Index ny, Index nz, Real* plane, Real* spectrum)
    {
        const int n_y = static_cast<int>(ny), n_z = static_cast<int>(nz), half = n_z / 2 + 1;
        forward = fftw_plan_many_dft_r2c(1, &n_z, n_y, plane, nullptr, 1, 2 * half,
                                         complex(spectrum), nullptr, 1, half, FFTW_ESTIMATE);
        backward = fftw_plan_many_dft_c2r(1, &n_z, n_y, complex(spectrum), nullptr, 1, half, plane,
                                          nullptr, 1, 2 * half, FFTW_ESTIMATE);
    }
    ~Plans()
    {
        fftw_destroy_plan(forward);
        fftw_destroy_plan(backward);
    }
    Plans(const Plans&) = delete;
    Plans& operator=(const Plans&) = delete;

    static fftw_complex* complex(Real* values) { return reinterpret_cast<fftw_complex*>(values); }

    fftw_plan forward, backward;
};

namespace {

/// Eigenvalue of the second difference for a wave of `phase` radians per
/// spacing.
Real second_difference(Real phase, Real h)
{
    const Real s = 2 * std::sin(phase / 2) / h;
    return -s * s;
}

} // namespace

Poisson::Poisson(const Grid& g)
    : grid_(g), row_(2 * (g.nz() / 2 + 1)), transformed_(g.nx() * g.ny() * row_),
      diagonal_(g.ny() * row_), diagonal_at_end_(g.ny() * row_), cosine_(g.ny(), row_ / 2),
      plane_size_(g.ny() * row_), scratch_(2 * plane_size_ * max_threads()), lines_(g.nx()),
      plans_(
          std::make_unique<Plans>(g.ny(), g.nz(), scratch_.data(), scratch_.data() + plane_size_))
{
    const Real ax = 1 / (g.spacing().x * g.spacing().x);
    for (Index j = 0; j < g.ny(); ++j) {
        const Real phase_y = pi * static_cast<Real>(j) / static_cast<Real>(g.ny());
        for (Index k = 0; k < row_; ++k) {
            const Real phase_z = 2 * pi * static_cast<Real>(k / 2) / static_cast<Real>(g.nz());
            const Real lambda = second_difference(phase_y, g.spacing().y) +
                                second_difference(phase_z, g.spacing().z);
            diagonal_[j * row_ + k] = lambda - 2 * ax;
            diagonal_at_end_[j * row_ + k] = lambda - 3 * ax;
        }
    }
}

Poisson::~Poisson() = default;

void Poisson::transform_forward(Real* plane, Index i)
{
    Real* spectrum = plane + plane_size_;
    fftw_execute_dft_r2c(plans_->forward, plane, Plans::complex(spectrum));
    cosine_.forward(spectrum, plane, &transformed_[i * plane_size_]);
}

void Poisson::transform_backward(Index i, Real* plane)
{
    Real* spectrum = plane + plane_size_;
    cosine_.backward(&transformed_[i * plane_size_], plane, spectrum);
    fftw_execute_dft_c2r(plans_->backward, Plans::complex(spectrum), plane);
}

void Poisson::solve_transformed(ScalarField& phi)
{
    const Real ax = 1 / (grid_.spacing().x * grid_.spacing().x);
    const Real *interior = diagonal_.data(), *at_end = diagonal_at_end_.data();
    const Index last = grid_.nx() - 1;
    lines_.solve(transformed_.data(), plane_size_, grid_.nx(), plane_size_,
                 [=](Index i, Index column) {
                     const Real* diagonal = (i == 0 || i == last ? at_end : interior) + column;
                     return [=](Index k) { return TridiagonalRow{ax, diagonal[k], ax}; };
                 });

    const View<Real> f = phi.view();
    const Index ny = grid_.ny(), nz = grid_.nz();
    const Real scale = 1 / static_cast<Real>(nz);
    for_planes(0, grid_.nx(), [=, this](Index i) {
        Real* plane = scratch_plane();
        transform_backward(i, plane);
        for (Index m = 0; m < ny; ++m) {
            Real* row = &f(i, cosine_.row_at(m), 0);
            const Real* from = plane + m * row_;
#pragma omp simd
            for (Index k = 0; k < nz; ++k) row[k] = scale * from[k];
        }
    });
    fill_increment_halo(grid_, phi);
}

} // namespace starling
