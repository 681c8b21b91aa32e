#include "flow/projection.hpp"

#include <utility>

#include "grid/boundary.hpp"
#include "grid/stencils.hpp"

namespace starling {

Projection::Projection(const Grid& g, const FluidParameters& p, const DriveParameters& drive)
    : grid_(g), theta_(p.theta), viscous_(p.theta / p.reynolds), ends_(g, drive), poisson_(g),
      phi_(g), plane_sums_(g.nx() + 1)
{
    if (ends_.answer_to_flow()) shape_answers();
}

void Projection::set_ends(Array<Real> inside_share, std::array<Array<Real>, 2> flow_weights)
{
    ends_.set_inside_share(std::move(inside_share));
    for (std::size_t end = 0; end < 2; ++end)
        ends_.set_flow_weights(end, std::move(flow_weights[end]));
    if (ends_.answer_to_flow()) shape_answers();
}

void Projection::shape_answers()
{
    ScalarField unit(grid_);
    EndState one(grid_);
    one.pressure[0] = ends_.share();
    ends_.add_pressure(one, unit);
    solve_harmonic(unit);
    ends_.add_pressure(one, unit);
    ends_.set_unit_increment(std::move(unit));
}

void Projection::solve_harmonic(ScalarField& phi)
{
    const Laplacian laplacian(grid_.spacing());
    const View<Real> f = phi.view(); // zero inside
    poisson_.solve([=](Index i, Index j, Index k) { return -laplacian(f, f.offset(i, j, k)); },
                   phi_);
    std::swap(phi, phi_);
    fill_increment_halo(grid_, phi);
}

namespace {

/// u_c -= dt d(phi)/dx_c at all unknowns of the component; the kinetic energy that it has then.
Real subtract_gradient(const Grid& g, Location c, ScalarField& field, const ScalarField& phi,
                       Real dt, Array<Real>& plane_sums)
{
    const View<Real> u = field.view();
    const View<const Real> f = phi.view();
    const Index back = f.stride(axis(c));
    const Vec3 h = g.spacing();
    const Real scale = dt / (c == Location::u ? h.x : c == Location::v ? h.y : h.z);
    const Box box = g.unknowns(c);
    Real* squares = plane_sums.data();
    for_planes(0, box.end[0], [=](Index i) {
        Real sum = 0;
        for (Index j = box.begin[1]; j < box.end[1]; ++j) {
            Real* row = &u(i, j, 0);
            const Real* p = &f(i, j, 0);
#pragma omp simd reduction(+ : sum)
            for (Index k = 0; k < box.end[2]; ++k) {
                row[k] -= scale * (p[k] - p[k - back]);
                sum += row[k] * row[k];
            }
        }
        squares[i] = sum;
    });
    fill_velocity_halo(g, c, field);
    Real sum = 0;
    for (Index i = 0; i < box.end[0]; ++i) sum += squares[i];
    if (c == Location::u) sum -= (squares[0] + squares[box.end[0] - 1]) / 2; // half cells
    return sum * g.cell_volume() / 2;
}

} // namespace

void Projection::project(FluidState& s, Real t, Real dt)
{
    ScalarField& u = s.u[Location::u];
    const bool ends_change = ends_.prescribe(s.ends, u, t + theta_ * dt);
    if (ends_change) ends_.push(u, dt);
    const DivergenceAtCell divergence_at_cell(grid_, s.u);
    const Real inv_dt = 1 / dt;
    poisson_.solve([=](Index i, Index j, Index k) { return inv_dt * divergence_at_cell(i, j, k); },
                   phi_);
    if (ends_.answer_to_flow()) ends_.answer(s.ends, u, t + dt, dt, phi_);
    s.kinetic_energy_before = std::exchange(s.kinetic_energy, 0);
    for (Location c : components)
        s.kinetic_energy += subtract_gradient(grid_, c, s.u[c], phi_, dt, plane_sums_);
    if (ends_change) ends_.add_change(phi_);

    const View<Real> P = s.P.view();
    const View<const Real> phi = phi_.view();
    const Laplacian laplacian(grid_.spacing());
    const Real rotational = viscous_ * dt;
    for_each(grid_.unknowns(Location::cell), [=](Index i, Index j, Index k) {
        const Index n = phi.offset(i, j, k);
        P(i, j, k) += phi.data[n] - rotational * laplacian(phi, n);
    });
    fill_increment_halo(grid_, s.P);
    ends_.add_pressure(s.ends, s.P);
}

void Projection::initialise_pressure(FluidState& s)
{
    ends_.initialise(s.ends);
    s.P.fill(0);
    ends_.add_pressure(s.ends, s.P);
    solve_harmonic(s.P);
    ends_.add_pressure(s.ends, s.P);
}

} // namespace starling
