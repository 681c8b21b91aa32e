#include "solver/advance.hpp"

namespace starling {

void initialise(State& s, Operators& op)
{
    op.projection.initialise_pressure(s.fluid);
    op.geometry.update(s.wall.x);
    op.coupling.initialise(s.wall, s.ghosts);
}

namespace {

/// A step from s, tried without the rate of the forces; s takes the forces that it ends with.
bool try_step(State& s, State& trial, Operators& op, Workspace& w, Real dt)
{
    trial = s;
    std::fill(trial.wall.support_rate.begin(), trial.wall.support_rate.end(), Vec3{});
    if (!advance(trial, op, w, dt)) return false;
    std::swap(s.wall.support, trial.wall.support);
    std::swap(s.wall.passing, trial.wall.passing);
    return true;
}

} // namespace

bool load_rigid_parts(State& s, State& trial, Operators& op, Workspace& w, Real dt)
{
    constexpr int trials = 40;
    for (int n = 0; n < trials; ++n) {
        if (!try_step(s, trial, op, w, dt)) return false;
        std::swap(s.fluid.P, trial.fluid.P);
    }
    return true;
}

bool hold_rigid_parts(State& s, State& trial, Operators& op, Workspace& w, Real dt)
{
    constexpr int trials = 4;
    const Array<Vec3> predicted = s.wall.support;
    for (int n = 0; n < trials; ++n)
        if (!try_step(s, trial, op, w, dt)) return false;
    for (Index v = 0; v < predicted.size(); ++v)
        s.wall.support_rate[v] += 0.5 / dt * (s.wall.support[v] - predicted[v]);
    return true;
}

bool advance(State& s, Operators& op, Workspace& w, Real dt)
{
    w.timer.start();
    // clang-format off
    // 1. What the wall does to the fluid
    op.geometry.update(s.wall.x);                                     // n, areas
    op.elastic.compute(s.wall.x, w.f);                                // f_e             (3)-(5), (15), (17)
    op.viscosity.add(s.wall.x, s.wall.velocity, w.f);                 //   + Kelvin and Voigt's
    op.bending.add(s.wall.x, op.geometry, w.f);                       // + f_b           (18)-(23)
    op.contact.add(s.wall.x, op.geometry, w.f);                       //   + what keeps walls apart
    op.tissue.add(s.wall.x, s.wall.velocity, w.f);                    //   + the tissue around the wall
    op.support.apply(op.geometry, s.wall, dt, w.f);                   //   and what holds the rigid parts
    w.mark(Phase::wall_force);
    if (!op.coupling.weigh(s.wall)) return false;                     // D               (27)
    w.mark(Phase::spread);
    if (!op.coupling.search(s.wall, s.ghosts)) return false;          // IE, BI, GN      sec. 2.6
    w.mark(Phase::element_search);
    op.coupling.place_images(s.ghosts);                               // IP              (31)
    w.mark(Phase::ghost_nodes);
    op.coupling.spread(w.f, w.F);                                     // F               (28), (35)
    op.coupling.complete_pressure_force(s.ghosts, s.fluid.P, w.F);    //   beside the wall
    w.mark(Phase::spread);
    // 2. Intermediate velocity
    const PrescribedVelocity u_GN = op.coupling.no_slip(s.fluid.u);   // u_GN            (32), (44)
    w.mark(Phase::ghost_nodes);
    op.momentum.predict(s.fluid, w.F, u_GN, dt);                      // u_hat           (36)
    w.mark(Phase::momentum);
    // 3. Pressure
    op.projection.project(s.fluid, s.t, dt);                          // P, u            (37)-(39)
    w.mark(Phase::pressure);
    // 4. The wall follows
    op.coupling.follow(s.fluid.u, s.wall);                            // u_w             (30), (35)
    op.support.hold(op.geometry, s.wall, dt);                         //   where it may
    op.smoothing.add_velocity(op.geometry, s.wall);                   //   + u_s         sec. 2.8
    op.filter.add_velocity(op.geometry, s.wall, dt);                  //   less the waves the fluid cannot see
    s.wall.move(op.tube, dt);                                         // x               (29)
    // clang-format on
    w.mark(Phase::wall_motion);
    s.t += dt;
    ++s.step;
    return true;
}

} // namespace starling
