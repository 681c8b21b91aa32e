#include "flow/projection.hpp"

#include "grid/boundary.hpp"
#include "grid/stencils.hpp"

namespace starling {

Projection::Projection(const Grid& g, const FluidParameters& p, const DriveParameters& drive)
    : grid_(g), theta_(p.theta), viscous_(p.theta / p.reynolds), drive_(drive), poisson_(g),
      phi_(g), inside_share_(starling::inside_share(g)), end_change_{Array<Real>(g.ny() * g.nz()),
                                                                     Array<Real>(g.ny() * g.nz())}
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

void Projection::project(FluidState& s, Real t, Real dt)
{
    const bool ends_change = change_end_pressure(s, drive_.at(t + theta_ * dt));
    if (ends_change) push_on_end_faces(s.u[Location::u], dt);
    const DivergenceAtCell divergence_at_cell(grid_, s.u);
    const Real inv_dt = 1 / dt;
    poisson_.solve([=](Index i, Index j, Index k) { return inv_dt * divergence_at_cell(i, j, k); },
                   phi_);
    for (Location c : components) subtract_gradient(grid_, c, s.u[c], phi_, dt);
    if (ends_change) add_end_values(phi_, end_change_);

    const View<Real> P = s.P.view();
    const View<const Real> phi = phi_.view();
    const Laplacian laplacian(grid_.spacing());
    const Real rotational = viscous_ * dt;
    for_each(grid_.unknowns(Location::cell), [=](Index i, Index j, Index k) {
        const Index n = phi.offset(i, j, k);
        P(i, j, k) += phi.data[n] - rotational * laplacian(phi, n);
    });
    fill_increment_halo(grid_, s.P);
    add_end_values(s.P, s.end_pressure);
}

void Projection::initialise_pressure(FluidState& s)
{
    change_end_pressure(s, drive_.at(0));
    s.P.fill(0);
    add_end_values(s.P, s.end_pressure); // with P = 0 inside, the halo carries twice these
    const Laplacian laplacian(grid_.spacing());
    const View<const Real> P = s.P.view();
    poisson_.solve([=](Index i, Index j, Index k) { return -laplacian(P, P.offset(i, j, k)); },
                   phi_);
    std::swap(s.P, phi_);
    fill_increment_halo(grid_, s.P);
    add_end_values(s.P, s.end_pressure);
}

bool Projection::change_end_pressure(FluidState& s, const EndPressures& to)
{
    const std::array<Real, 2> inside = {to.inlet, to.outlet};
    bool changes = false;
    for (std::size_t end = 0; end < 2; ++end)
        for (Index n = 0; n < inside_share_.size(); ++n) {
            const Real share = inside_share_[n];
            const Real value = share * inside[end] + (1 - share) * to.external;
            Real& held = s.end_pressure[end][n];
            end_change_[end][n] = value - held;
            changes = changes || value != held;
            held = value;
        }
    return changes;
}

void Projection::push_on_end_faces(ScalarField& u_field, Real dt) const
{
    const View<Real> u = u_field.view();
    const Index nx = grid_.nx(), nz = grid_.nz();
    const Real scale = 2 * dt / grid_.spacing().x; // half a spacing from the face to the cell
    for (Index j = 0; j < grid_.ny(); ++j)
        for (Index k = 0; k < nz; ++k) {
            u(0, j, k) += scale * end_change_[0][j * nz + k];
            u(nx, j, k) -= scale * end_change_[1][j * nz + k];
        }
}

void Projection::add_end_values(ScalarField& field, const std::array<Array<Real>, 2>& values) const
{
    const View<Real> f = field.view();
    const Index nx = grid_.nx(), nz = grid_.nz();
    for (Index j = 0; j < grid_.ny(); ++j)
        for (Index k = 0; k < nz; ++k) {
            f(-1, j, k) += 2 * values[0][j * nz + k];
            f(nx, j, k) += 2 * values[1][j * nz + k];
        }
}

} // namespace starling
