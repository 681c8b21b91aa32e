#include "solver/power_balance.hpp"

#include <utility>

#include "grid/stencils.hpp"

namespace starling {

PowerBalance::PowerBalance(const Grid& g, Operators& op, const FluidParameters& fluid,
                           const DriveParameters& drive)
    : grid_(g), op_(&op), inv_reynolds_(1 / fluid.reynolds), total_pressure_(drive.total_pressure),
      section_flow_(g, op.tube), geometry_(op.tube.mesh),
      x_before_(static_cast<Index>(op.tube.X.size())), f_(x_before_.size()), no_fluid_(g)
{
}

Powers PowerBalance::measure(const State& s)
{
    Powers p;
    const Real dt = s.fluid.dt_before;
    if (dt == 0) return p;
    const EndPower inlet = entering(s, 0), outlet = entering(s, 1);
    p.inlet = inlet.inside;
    p.outlet = -outlet.inside;
    p.exterior = inlet.outside + outlet.outside;
    p.dissipation = dissipation(s);
    p.kinetic = (s.fluid.kinetic_energy - s.fluid.kinetic_energy_before) / dt;
    p.wall = work_on_wall(s);
    return p;
}

/// (P + |u|^2/2) u_n over an end face, inside and outside the tube; v and w are even about the
/// face.
PowerBalance::EndPower PowerBalance::entering(const State& s, std::size_t end)
{
    const EndState& ends = s.fluid.ends;
    const View<const Real> u = s.fluid.u[Location::u].view(), v = s.fluid.u[Location::v].view(),
                           w = s.fluid.u[Location::w].view();
    const Index i = end == 0 ? 0 : grid_.nx(), cell = end == 0 ? 0 : i - 1, nz = grid_.nz();
    const Real inwards = end == 0 ? 1 : -1, area = grid_.spacing().y * grid_.spacing().z;
    const Array<Real> weights = section_flow_.weights(s.wall.x, i);
    EndPower power;
    Real total = 0;
    for (Index j = 0; j < grid_.ny(); ++j)
        for (Index k = 0; k < nz; ++k) {
            const Index n = j * nz + k;
            const Real u_n = inwards * u(i, j, k),
                       suction = total_pressure_ ? std::max(u_n, 0.) : 0;
            const Real v_c = (v(cell, j, k) + v(cell, j + 1, k)) / 2;
            const Real w_c = (w(cell, j, k) + w(cell, j, k + 1)) / 2;
            const Real carried = (u_n * u_n + v_c * v_c + w_c * w_c) / 2;
            power.inside += weights[n] * (ends.inside[end] - suction * suction / 2 + carried) * u_n;
            total += area * (ends.pressure[end][n] + carried) * u_n;
        }
    power.outside = total - power.inside;
    return power;
}

/// -u . Lap u/Re over the nodes where fluid is: by parts, the square of the velocity gradient
/// between them, and between them and the wall.
Real PowerBalance::dissipation(const State& s)
{
    const Laplacian laplacian(grid_.spacing());
    Real sum = 0;
    for (Location c : components) {
        mark_no_fluid(c, s.ghosts);
        const View<const Real> u = s.fluid.u[c].view();
        const View<const std::uint8_t> no_fluid = std::as_const(no_fluid_).view();
        const Box b = grid_.unknowns(c);
        for (Index i = b.begin[0]; i < b.end[0]; ++i) {
            Real plane = 0;
            for (Index j = b.begin[1]; j < b.end[1]; ++j)
                for (Index k = b.begin[2]; k < b.end[2]; ++k) {
                    const Index n = u.offset(i, j, k);
                    plane -= no_fluid.data[n] ? 0 : u.data[n] * laplacian(u, n);
                }
            const bool half_cell = c == Location::u && (i == 0 || i == grid_.nx());
            sum += half_cell ? plane / 2 : plane;
        }
    }
    return inv_reynolds_ * grid_.cell_volume() * sum;
}

/// Ghost nodes, and the v and w through which the backward flow of u's ghost nodes closes.
void PowerBalance::mark_no_fluid(Location c, const GhostStates& ghosts)
{
    no_fluid_.fill(0);
    const auto for_ghosts = [](const GhostState& g, auto f) {
        for (const NearNode& n : g.near_wall)
            if (!g.inside(n.i, n.j, n.k)) f(n);
    };
    for_ghosts(ghosts[static_cast<std::size_t>(axis(c))],
               [&](const NearNode& n) { no_fluid_(n.i, n.j, n.k) = 1; });
    if (c == Location::u) return;
    const Index along_y = c == Location::v ? 1 : 0, along_z = 1 - along_y;
    for_ghosts(ghosts[0], [&](const NearNode& n) {
        for (Index i : {n.i - 1, n.i}) {
            no_fluid_(i, n.j, n.k) = 1;
            no_fluid_(i, n.j + along_y, n.k + along_z) = 1;
        }
    });
}

/// The forces of the last step, at the positions before it, times the wall's velocity in it. Those
/// that depend on the velocity are taken at that of the step, not the one before.
Real PowerBalance::work_on_wall(const State& s)
{
    const Array<Vec3>& U = s.wall.velocity;
    for (Index v = 0; v < U.size(); ++v) x_before_[v] = s.wall.x[v] - s.fluid.dt_before * U[v];
    geometry_.update(x_before_);
    op_->elastic.compute(x_before_, f_);
    op_->viscosity.add(x_before_, U, f_);
    op_->bending.add(x_before_, geometry_, f_);
    op_->contact.add(x_before_, geometry_, f_);
    op_->tissue.add(x_before_, U, f_);
    Real sum = 0;
    for (VertexIndex v = op_->tube.moving_begin(); v < op_->tube.moving_end(); ++v)
        sum -= dot(f_[v], U[v]);
    return sum;
}

} // namespace starling
