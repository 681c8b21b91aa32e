#include "flow/poisson.hpp"

#include <fftw3.h>

#include "grid/boundary.hpp"

namespace starling {

/// FFTW plans of the rows of one x-plane. Planned by estimate: measured plans
/// differ from run to run, and with them the last bits of the result.
struct Poisson::Plans {
    Plans(Index ny, Index nz, Real* plane)
    {
        const int n_y = static_cast<int>(ny), n_z = static_cast<int>(nz);
        const int half = n_z / 2 + 1;
        auto* spectrum = reinterpret_cast<fftw_complex*>(plane);
        forward = fftw_plan_many_dft_r2c(1, &n_z, n_y, plane, nullptr, 1, 2 * half, spectrum,
                                         nullptr, 1, half, FFTW_ESTIMATE);
        backward = fftw_plan_many_dft_c2r(1, &n_z, n_y, spectrum, nullptr, 1, half, plane, nullptr,
                                          1, 2 * half, FFTW_ESTIMATE);
    }
    ~Plans()
    {
        fftw_destroy_plan(forward);
        fftw_destroy_plan(backward);
    }
    Plans(const Plans&) = delete;
    Plans& operator=(const Plans&) = delete;

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
    : grid_(g), row_(2 * (g.nz() / 2 + 1)), transformed_(g.cell_count()),
      diagonal_(g.ny() * g.nz()), diagonal_at_end_(g.ny() * g.nz()),
      scratch_size_((2 * g.ny() + 1) * row_), scratch_(scratch_size_ * max_threads()),
      cosine_(g.ny()), lines_(g.nx()),
      plans_(std::make_unique<Plans>(g.ny(), g.nz(), scratch_.data()))
{
    const Real ax = 1 / (g.spacing().x * g.spacing().x);
    Array<Real> lambda_y(g.ny()), lambda_z(g.nz());
    for (Index j = 0; j < g.ny(); ++j)
        lambda_y[j] =
            second_difference(pi * static_cast<Real>(j) / static_cast<Real>(g.ny()), g.spacing().y);
    for (Index k = 0; k < g.nz(); ++k) {
        const Index wave = (k + 1) / 2;
        lambda_z[k] = second_difference(
            2 * pi * static_cast<Real>(wave) / static_cast<Real>(g.nz()), g.spacing().z);
    }
    for (Index j = 0; j < g.ny(); ++j)
        for (Index k = 0; k < g.nz(); ++k) {
            diagonal_[j * g.nz() + k] = lambda_y[j] - 2 * ax + lambda_z[k];
            diagonal_at_end_[j * g.nz() + k] = lambda_y[j] - 2 * ax - ax + lambda_z[k];
        }
}

Poisson::~Poisson() = default;

// The spectrum of a row begins with the mean and a zero and ends, if nz is
// even, with another zero. With the mean moved to the place of the first zero,
// the nz values that count lie side by side.
void Poisson::transform_forward(Real* plane, Index i)
{
    const Index ny = grid_.ny(), nz = grid_.nz();
    fftw_execute_dft_r2c(plans_->forward, plane, reinterpret_cast<fftw_complex*>(plane));
    for (Index j = 0; j < ny; ++j) plane[j * row_ + 1] = plane[j * row_];
    cosine_.forward(plane + 1, row_, &transformed_[i * ny * nz], nz, nz, plane + ny * row_);
}

void Poisson::transform_backward(Index i, Real* plane)
{
    const Index ny = grid_.ny(), nz = grid_.nz();
    cosine_.backward(&transformed_[i * ny * nz], nz, plane + 1, row_, nz, plane + ny * row_);
    for (Index j = 0; j < ny; ++j) {
        Real* row = plane + j * row_;
        row[0] = row[1];
        row[1] = 0;
        if (nz % 2 == 0) row[nz + 1] = 0;
    }
    fftw_execute_dft_c2r(plans_->backward, reinterpret_cast<fftw_complex*>(plane), plane);
}

void Poisson::solve_transformed(ScalarField& phi)
{
    const Real ax = 1 / (grid_.spacing().x * grid_.spacing().x);
    const Real *interior = diagonal_.data(), *at_end = diagonal_at_end_.data();
    const Index last = grid_.nx() - 1;
    const Index plane_size = grid_.ny() * grid_.nz();
    lines_.solve(transformed_.data(), plane_size, grid_.nx(), plane_size,
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
        for (Index j = 0; j < ny; ++j) {
            Real* row = &f(i, j, 0);
            const Real* from = plane + j * row_;
#pragma omp simd
            for (Index k = 0; k < nz; ++k) row[k] = scale * from[k];
        }
    });
    fill_increment_halo(grid_, phi);
}

} // namespace starling
