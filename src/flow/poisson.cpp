#include "flow/poisson.hpp"

#include <fftw3.h>

#include "grid/boundary.hpp"

namespace starling {

/// FFTW plans of one x-plane. Planned by estimate: measured plans differ from run to run, and
/// with them the last bits of the result.
struct Poisson::Plans {
    Plans(Index ny, Index nz, Real* plane)
    {
        const int n_y = static_cast<int>(ny), n_z = static_cast<int>(nz);
        const int half = n_z / 2 + 1;
        auto* spectrum = reinterpret_cast<fftw_complex*>(plane);
        const unsigned flags = FFTW_ESTIMATE;
        forward_z = fftw_plan_many_dft_r2c(1, &n_z, n_y, plane, nullptr, 1, 2 * half, spectrum,
                                           nullptr, 1, half, flags);
        backward_z = fftw_plan_many_dft_c2r(1, &n_z, n_y, spectrum, nullptr, 1, half, plane,
                                            nullptr, 1, 2 * half, flags);
        const fftw_r2r_kind cosine = FFTW_REDFT10, inverse = FFTW_REDFT01;
        forward_y = fftw_plan_many_r2r(1, &n_y, 2 * half, plane, nullptr, 2 * half, 1, plane,
                                       nullptr, 2 * half, 1, &cosine, flags);
        backward_y = fftw_plan_many_r2r(1, &n_y, 2 * half, plane, nullptr, 2 * half, 1, plane,
                                        nullptr, 2 * half, 1, &inverse, flags);
    }
    ~Plans()
    {
        for (fftw_plan p : {forward_z, backward_z, forward_y, backward_y}) fftw_destroy_plan(p);
    }
    Plans(const Plans&) = delete;
    Plans& operator=(const Plans&) = delete;

    void forward(Real* plane) const
    {
        fftw_execute_dft_r2c(forward_z, plane, reinterpret_cast<fftw_complex*>(plane));
        fftw_execute_r2r(forward_y, plane, plane);
    }
    void backward(Real* plane) const
    {
        fftw_execute_r2r(backward_y, plane, plane);
        fftw_execute_dft_c2r(backward_z, reinterpret_cast<fftw_complex*>(plane), plane);
    }

    fftw_plan forward_z, backward_z, forward_y, backward_y;
};

namespace {

/// Eigenvalue of the second difference for a wave of `phase` radians per spacing.
Real second_difference(Real phase, Real h)
{
    const Real s = 2 * std::sin(phase / 2) / h;
    return -s * s;
}

} // namespace

Poisson::Poisson(const Grid& g)
    : grid_(g), cells_(g.unknowns(Location::cell)), row_(2 * (g.nz() / 2 + 1)),
      buffer_(g.nx() * g.ny() * row_), eigenvalues_y_(g.ny()), eigenvalues_z_(row_),
      lines_(g.nx(), row_), plans_(std::make_unique<Plans>(g.ny(), g.nz(), buffer_.data()))
{
    for (Index j = 0; j < g.ny(); ++j)
        eigenvalues_y_[j] =
            second_difference(pi * static_cast<Real>(j) / static_cast<Real>(g.ny()), g.spacing().y);
    for (Index k = 0; k < row_; ++k)
        eigenvalues_z_[k] = second_difference(
            2 * pi * static_cast<Real>(k / 2) / static_cast<Real>(g.nz()), g.spacing().z);
}

Poisson::~Poisson() = default;

View<Real> Poisson::buffer_view() { return {buffer_.data(), grid_.ny() * row_, row_}; }

void Poisson::solve_buffer(ScalarField& phi)
{
    const View<Real> buffer = buffer_view();
    const Plans* plans = plans_.get();
    for_range(0, grid_.nx(), [=](Index i) { plans->forward(&buffer(i, 0, 0)); });

    const Real ax = 1 / (grid_.spacing().x * grid_.spacing().x);
    const Real *lambda_y = eigenvalues_y_.data(), *lambda_z = eigenvalues_z_.data();
    const Index last = grid_.nx() - 1;
    lines_.solve(buffer.data, buffer.stride_x, buffer.stride_y, grid_.nx(), {0, grid_.ny()}, row_,
                 [=](Index i, Index j) {
                     const Real end = i == 0 || i == last ? ax : 0; // phi = 0 on the end faces
                     const Real diagonal = lambda_y[j] - 2 * ax - end;
                     const Real lower = i == 0 ? 0 : ax, upper = i == last ? 0 : ax;
                     return [=](Index k) {
                         return TridiagonalRow{lower, diagonal + lambda_z[k], upper};
                     };
                 });

    for_range(0, grid_.nx(), [=](Index i) { plans->backward(&buffer(i, 0, 0)); });
    const View<Real> f = phi.view();
    const Real scale = 1 / static_cast<Real>(2 * grid_.ny() * grid_.nz());
    for_each(cells_, [=](Index i, Index j, Index k) { f(i, j, k) = scale * buffer(i, j, k); });
    fill_increment_halo(grid_, phi);
}

} // namespace starling
