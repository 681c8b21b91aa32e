#pragma once
/// Direct solver of the discrete Poisson equation of the pressure increment.
#include <memory>

#include "flow/cosine_transform.hpp"
#include "grid/field.hpp"
#include "parallel/x_lines.hpp"

namespace starling {

/// Solves Laplacian(phi) = rhs at cell centres: Fourier in z (periodic), cosine
/// in y (zero normal derivative), tridiagonal in x (phi given on the end
/// faces). The discrete Laplacian is the divergence of the gradient, so the
/// projection is exact to round-off. Source: sec. 2.7.
class Poisson {
public:
    explicit Poisson(const Grid& g);
    ~Poisson();
    Poisson(const Poisson&) = delete;
    Poisson& operator=(const Poisson&) = delete;

    /// Calls rhs(i, j, k) for every cell, solves with phi = 0 on the end faces
    /// and writes phi with valid halos.
    template <class Rhs>
    void solve(Rhs rhs, ScalarField& phi)
    {
        const Index ny = grid_.ny(), nz = grid_.nz();
        for_planes(0, grid_.nx(), [=, this](Index i) {
            const Rhs plane_rhs = rhs; // local, so that the loop vectorises
            Real* plane = scratch_plane();
            for (Index m = 0; m < ny; ++m) {
                Real* row = plane + m * row_;
                const Index j = cosine_.row_at(m);
#pragma omp simd
                for (Index k = 0; k < nz; ++k) row[k] = plane_rhs(i, j, k);
            }
            transform_forward(plane, i);
        });
        solve_transformed(phi);
    }

private:
    struct Plans;
    /// The calling thread's plane, its rows in the order of the cosine transform, and another.
    Real* scratch_plane() { return scratch_.data() + 2 * plane_size_ * thread_number(); }
    void transform_forward(Real* plane, Index i);
    void transform_backward(Index i, Real* plane);
    void solve_transformed(ScalarField& phi);

    Grid grid_;
    Index row_;                   ///< reals in a row of the spectrum: 2 (nz/2 + 1)
    Array<Real> transformed_;     ///< nx planes of ny rows
    Array<Real> diagonal_;        ///< of the lines along x, per transformed value of a plane
    Array<Real> diagonal_at_end_; ///< the same in the first and the last plane
    CosineTransform cosine_;
    Index plane_size_; ///< reals in ny rows
    Array<Real> scratch_;
    XLines lines_;
    std::unique_ptr<Plans> plans_;
};

} // namespace starling
