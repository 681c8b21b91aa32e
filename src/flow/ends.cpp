#include "flow/ends.hpp"

#include <utility>

#include "grid/boundary.hpp"

namespace starling {

Ends::Ends(const Grid& g, const DriveParameters& drive)
    : grid_(g), drive_(drive),
      share_(inside_share(g)), change_{Array<Real>(g.ny() * g.nz()), Array<Real>(g.ny() * g.nz())}
{
    const Real face = g.spacing().y * g.spacing().z;
    for (Array<Real>& weights : weights_) {
        weights = inside_share(g);
        for (Real& w : weights) w *= face;
    }
}

void Ends::initialise(EndState& ends)
{
    const EndPressures p = drive_.at(0);
    external_ = p.external;
    const bool by_pressure = drive_.gives_pressures();
    const Real outlet = by_pressure ? p.outlet : drive_.pressure_outlet;
    ends.stored = outlet;
    const ScalarField at_rest(grid_);
    set_pressure(ends, 0, inlet_answers() ? outlet : p.inlet, at_rest);
    set_pressure(ends, 1, outlet, at_rest);
}

bool Ends::prescribe(EndState& ends, const ScalarField& u_hat, Real t)
{
    const EndPressures p = drive_.at(t);
    external_ = p.external;
    const bool inlet = set_pressure(ends, 0, inlet_answers() ? ends.inside[0] : p.inlet, u_hat);
    const bool outlet = set_pressure(ends, 1, outlet_answers() ? ends.inside[1] : p.outlet, u_hat);
    return inlet || outlet;
}

bool Ends::set_pressure(EndState& ends, std::size_t end, Real inside, const ScalarField& u_hat)
{
    ends.inside[end] = inside;
    const View<const Real> u = u_hat.view();
    const Index face = end == 0 ? 0 : grid_.nx(), nz = grid_.nz();
    const Real inwards = end == 0 ? 1 : -1;
    const bool total = drive_.total_pressure;
    bool changes = false;
    for (Index j = 0; j < grid_.ny(); ++j)
        for (Index k = 0; k < nz; ++k) {
            const Index n = j * nz + k;
            const Real entering = total ? std::max(inwards * u(face, j, k), Real{0}) : 0;
            const Real value =
                share_[n] * (inside - entering * entering / 2) + (1 - share_[n]) * external_;
            Real& held = ends.pressure[end][n];
            change_[end][n] = value - held;
            changes = changes || value != held;
            held = value;
        }
    return changes;
}

void Ends::push(ScalarField& u_field, Real dt) const
{
    const View<Real> u = u_field.view();
    const Index nx = grid_.nx(), nz = grid_.nz();
    const Real scale = 2 * dt / grid_.spacing().x; // half a spacing from the face to the cell
    for (Index j = 0; j < grid_.ny(); ++j)
        for (Index k = 0; k < nz; ++k) {
            u(0, j, k) += scale * change_[0][j * nz + k];
            u(nx, j, k) -= scale * change_[1][j * nz + k];
        }
}

void Ends::add_end_values(ScalarField& field, const std::array<Array<Real>, 2>& values) const
{
    const View<Real> f = field.view();
    const Index nx = grid_.nx(), nz = grid_.nz();
    for (Index j = 0; j < grid_.ny(); ++j)
        for (Index k = 0; k < nz; ++k) {
            f(-1, j, k) += 2 * values[0][j * nz + k];
            f(nx, j, k) += 2 * values[1][j * nz + k];
        }
}

void Ends::set_unit_increment(ScalarField unit)
{
    unit_ = std::move(unit);
    const ScalarField at_rest(grid_);
    const View<const Real> phi = std::as_const(unit_).view();
    const Index nx = grid_.nx(), nz = grid_.nz();
    const Real h = grid_.spacing().x;
    conductance_ = other_conductance_ = {};
    for (std::size_t end = 0; end < 2; ++end)
        for (Index j = 0; j < grid_.ny(); ++j)
            for (Index k = 0; k < nz; ++k) {
                const Real w = weights_[end][j * nz + k];
                conductance_[end] += w * (phi(-1, j, k) - phi(0, j, k)) / h;
                other_conductance_[end] += w * (phi(nx - 1, j, k) - phi(nx, j, k)) / h;
            }
}

Real Ends::flow(std::size_t end, const ScalarField& u_hat, const ScalarField& phi_field,
                Real dt) const
{
    const View<const Real> u = u_hat.view(), phi = phi_field.view();
    const Index face = end == 0 ? 0 : grid_.nx(), nz = grid_.nz();
    const Real scale = dt / grid_.spacing().x;
    Real Q = 0;
    for (Index j = 0; j < grid_.ny(); ++j)
        for (Index k = 0; k < nz; ++k)
            Q += weights_[end][j * nz + k] *
                 (u(face, j, k) - scale * (phi(face, j, k) - phi(face - 1, j, k)));
    return Q;
}

// With more pressure d at the inlet and e at the outlet the flows are
//   Q_in = q_in + dt (G_in d - H_in e),  Q_out = q_out + dt (H_out d - G_out e).
// The inlet asks for Q_in, the Windkessel for p + e = a + b Q_out.
void Ends::answer(EndState& ends, const ScalarField& u_hat, Real t, Real dt, ScalarField& phi)
{
    const Real q_in = flow(0, u_hat, phi, dt), q_out = flow(1, u_hat, phi, dt);
    const auto [G_in, G_out] = conductance_;
    const auto [H_in, H_out] = other_conductance_;
    const Windkessel& w = drive_.windkessel;
    const Real memory = w.C * w.R2 / dt, b = w.R1 + w.R2 / (1 + memory);
    const Real distal = drive_.distal_pressure_at(t);
    const Real a = (memory * ends.stored + distal) / (1 + memory);
    // rows of the two equations for (d, e); an end that does not answer keeps its pressure
    const bool inlet = inlet_answers(), outlet = outlet_answers();
    const Real A00 = inlet ? dt * G_in : 1, A01 = inlet ? -dt * H_in : 0;
    const Real r0 = inlet ? drive_.inlet_flow_at(t) - q_in : 0;
    const Real A10 = outlet ? -b * dt * H_out : 0, A11 = outlet ? 1 + b * dt * G_out : 1;
    const Real r1 = outlet ? a + b * q_out - ends.inside[1] : 0;
    const Real determinant = A00 * A11 - A01 * A10;
    const Real d = (r0 * A11 - A01 * r1) / determinant, e = (A00 * r1 - A10 * r0) / determinant;
    if (outlet) {
        const Real Q_out = q_out + dt * (H_out * d - G_out * e);
        ends.stored = (memory * ends.stored + w.R2 * Q_out + distal) / (1 + memory);
    }
    add_answer(ends, {d, e}, phi);
}

void Ends::add_answer(EndState& ends, const std::array<Real, 2>& more, ScalarField& phi)
{
    for (std::size_t end = 0; end < 2; ++end) {
        ends.inside[end] += more[end];
        for (Index n = 0; n < share_.size(); ++n) ends.pressure[end][n] += more[end] * share_[n];
    }
    const View<Real> f = phi.view();
    const View<const Real> unit = std::as_const(unit_).view();
    const Index nx = grid_.nx(), ny = grid_.ny(), nz = grid_.nz();
    const Real d = more[0], e = more[1];
    for_planes(-1, nx + 1, [=](Index i) {
        for (Index j = -1; j <= ny; ++j) {
            Real* row = &f(i, j, 0);
            const Real *near_inlet = &unit(i, j, 0), *near_outlet = &unit(nx - 1 - i, j, 0);
#pragma omp simd
            for (Index k = -1; k <= nz; ++k) row[k] += d * near_inlet[k] + e * near_outlet[k];
        }
    });
}

} // namespace starling
