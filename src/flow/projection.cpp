#include "flow/projection.hpp"

#include "grid/boundary.hpp"
#include "grid/stencils.hpp"

namespace starling {

Projection::Projection(const Grid& g, const FluidParameters& p, const DriveParameters& drive)
    : grid_(g), viscous_(p.theta / p.reynolds), drive_(drive), poisson_(g), phi_(g),
      inside_share_(starling::inside_share(g))
{
}

namespace {

/// u_c -= dt d(phi)/dx_c at all unknowns of the component.
void subtract_gradient(const Grid& g, Location c, ScalarField& field, const ScalarField& phi,
                       Real dt)
{
    const View<Real> u = field.view();
    const View<const Real> f = phi.view();
    const Index back = f.stride(axis(c));
    const Vec3 h = g.spacing();
    const Real scale = dt / (c == Location::u ? h.x : c == Location::v ? h.y : h.z);
    for_each(g.unknowns(c), [=](Index i, Index j, Index k) {
        const Real* p = &f(i, j, k);
        u(i, j, k) -= scale * (p[0] - p[-back]);
    });
    fill_velocity_halo(g, c, field);
}

} // namespace

void Projection::project(FluidState& s, Real dt)
{
    const DivergenceAtCell divergence_at_cell(grid_, s.u);
    const Real inv_dt = 1 / dt;
    poisson_.solve([=](Index i, Index j, Index k) { return inv_dt * divergence_at_cell(i, j, k); },
                   phi_);
    for (Location c : components) subtract_gradient(grid_, c, s.u[c], phi_, dt);

    const View<Real> P = s.P.view();
    const View<const Real> phi = phi_.view();
    const Laplacian laplacian(grid_.spacing());
    const Real rotational = viscous_ * dt;
    for_each(grid_.unknowns(Location::cell), [=](Index i, Index j, Index k) {
        const Index n = phi.offset(i, j, k);
        P(i, j, k) += phi.data[n] - rotational * laplacian(phi, n);
    });
    fill_pressure_halo(s.P);
}

void Projection::initialise_pressure(FluidState& s)
{
    s.P.fill(0);
    fill_pressure_halo(s.P); // with P = 0 inside, the halo carries twice the end pressures
    const Laplacian laplacian(grid_.spacing());
    const View<const Real> P = s.P.view();
    poisson_.solve([=](Index i, Index j, Index k) { return -laplacian(P, P.offset(i, j, k)); },
                   phi_);
    std::swap(s.P, phi_);
    fill_pressure_halo(s.P);
}

void Projection::fill_pressure_halo(ScalarField& field) const
{
    fill_increment_halo(grid_, field);
    const View<Real> P = field.view();
    const Index nx = grid_.nx();
    for (Index j = 0; j < grid_.ny(); ++j)
        for (Index k = 0; k < grid_.nz(); ++k) {
            const Real s = inside_share_[j * grid_.nz() + k],
                       e = (1 - s) * drive_.pressure_external;
            P(-1, j, k) += 2 * (s * drive_.pressure_inlet + e);
            P(nx, j, k) += 2 * (s * drive_.pressure_outlet + e);
        }
}

} // namespace starling
