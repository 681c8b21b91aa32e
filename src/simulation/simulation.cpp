#include "simulation/simulation.hpp"

#include <limits>
#include <stdexcept>

#include "core/error.hpp"
#include "core/for_each.hpp"
#include "output/checkpoint.hpp"
#include "simulation/soundness.hpp"
#include "solver/advance.hpp"
#include "solver/snapshot.hpp"
#include "theory/tube_problem.hpp"
#include "wall/perturbation.hpp"

namespace starling {

namespace {

Tube make_tube(const Case& c, const Grid& g)
{
    return make_tube(c.tube, c.tube.edge_over_spacing * g.delta());
}

constexpr Real contact_range = 2; ///< gap below which walls repel each other, in grid spacings

} // namespace

WallModel wall_model(const Case& c, Real delta)
{
    const Real reynolds = c.fluid.reynolds;
    // The filter works as fast as waves of the grid's scale relax or swing.
    const ContactParameters contact = {c.material.contact * shear_modulus(c.material, reynolds),
                                       contact_range * delta};
    return {make_material(c.material, reynolds),
            bending_modulus(c.material, reynolds),
            contact,
            c.tube.mesh_filter / grid_wave_time(c, delta),
            c.tube.smoothing,
            c.material.support,
            c.material.viscosity,
            small_strain_poisson_ratio(c.material),
            c.material.stiffness};
}

namespace {

constexpr Real half_slab = 0.5; ///< of a neighbourhood along x, or more
constexpr Real half_slab_in_spacings = 6;
constexpr Index steps_between_checks = 10; ///< of speed, gaps and the automatic step
constexpr Index steps_between_copies = 50; ///< of a sound state
constexpr Index steps_held = 20;           ///< in which the forces of rigid parts are tried out
constexpr Real largest_sound_move = 0.5;   ///< of the wall in a step, in grid spacings

} // namespace

struct Simulation::Impl {
    Case description;
    Grid grid;
    Tube tube;
    Operators op;
    Workspace workspace;
    State state;
    Monitor monitor;
    std::vector<TimeStepLimit> limits;
    Soundness soundness{description, grid, tube, state, limits};
    State good;                 ///< the last state found sound
    std::optional<State> trial; ///< of a step that is tried; only in the first steps
    Real good_cfl = 0;
    Real step_factor = 1;        ///< on the automatic step
    int threads = max_threads(); ///< scratch memory is made for so many

    explicit Impl(const Case& c)
        : description(c), grid(make_grid(c.grid, c.tube.length)), tube(make_tube(c, grid)),
          op(grid, tube, wall_model(c, grid.delta()), c.fluid, c.drive, c.coupling.scheme),
          workspace(grid, tube), state(grid, tube), monitor(grid, op, c.fluid, c.drive),
          good(grid, tube)
    {
        perturb(tube, c.perturbation, state.wall.x);
        initialise(state, op);
        choose_step(std::abs(c.pressure_ratio()));
        if (has_supports())
            load_rigid_parts(state, trial.emplace(grid, tube), op, workspace, state.dt);
        good = state;
    }

    bool has_supports() const
    {
        return supports_rigid_parts(description.coupling.scheme) && tube.deforms();
    }

    void find_limits(Real u_max) { limits = time_step_limits(description, grid.delta(), u_max); }

    /// The fixed step, or the automatic one: it follows its limits down at once and up in jumps
    /// of a tenth, so that it seldom changes.
    void choose_step(Real u_max)
    {
        find_limits(u_max);
        const Real allowed = step_factor * smallest(limits).dt;
        if (description.time.step)
            state.dt = *description.time.step;
        else if (state.dt == 0 || allowed < state.dt || allowed > 1.1 * state.dt)
            state.dt = allowed;
    }

    /// Throws InputError where a state that was read would lead the step astray.
    void check_restored(const State& s) const
    {
        bool fits = is_finite(s) && s.dt > 0 && s.step >= 0 && s.step <= state.step;
        for (Location c : components) {
            const Box b = grid.unknowns(c);
            for (const NearNode& n : s.ghosts[static_cast<std::size_t>(axis(c))].near_wall)
                fits = fits && n.i >= b.begin[0] && n.i < b.end[0] && n.j >= b.begin[1] &&
                       n.j < b.end[1] && n.k >= b.begin[2] && n.k < b.end[2] &&
                       n.intercept.element >= 0 && n.intercept.element < tube.mesh.element_count();
        }
        if (!fits) throw InputError("the checkpoint does not fit the grid and wall of its case");
    }

    /// The speed that limits the present state, or the one that its pressures may bring about.
    Real speed() const
    {
        const Real u_max = check_speed(grid, state.fluid.u, state.fluid.dt_before).u_max;
        return std::max(u_max, std::abs(description.pressure_ratio()));
    }

    /// Limits of the present state; the step itself is part of the state.
    void find_limits() { find_limits(speed()); }

    void choose_step_anew()
    {
        state.dt = 0;
        choose_step(speed());
        good.dt = state.dt;
    }

    void after_restore()
    {
        check_restored(state);
        check_restored(good);
        good_cfl = check_speed(grid, good.fluid.u, good.fluid.dt_before).cfl;
        find_limits();
    }

    void back_to_good()
    {
        state = good;
        find_limits(); // those of the state that broke down may be of any speed
    }

    void set_step_factor(Real factor)
    {
        step_factor = factor;
        if (!description.time.step) state.dt = std::min(state.dt, factor * smallest(limits).dt);
    }

    void check_speed_and_step()
    {
        const SpeedCheck check = check_speed(grid, state.fluid.u, state.fluid.dt_before);
        soundness.check_flow(check);
        choose_step(std::max(check.u_max, std::abs(description.pressure_ratio())));
        if (state.step % steps_between_copies == 0) keep_if_sound(check.cfl);
    }

    /// What is looked at after each step, and what is too dear for that (docs/reliability.md).
    void check()
    {
        soundness.check_step();
        soundness.check_folds();
        const bool tenth = state.step % steps_between_checks == 0;
        if (tenth) soundness.check_gaps();
        // in the first steps the drive may have been switched on
        if (tenth || state.step < steps_between_checks) check_speed_and_step();
    }

    /// A state that is about to blow up shows it by its speed.
    void keep_if_sound(Real cfl)
    {
        if (cfl > std::max(Real{1}, 2 * good_cfl) || soundness.largest_move() > largest_sound_move)
            return;
        good = state;
        good_cfl = cfl;
    }

    /// The load on the rigid parts changes fast after the drive has been switched on.
    bool hold_at_first(Real dt)
    {
        if (state.step >= steps_held) trial.reset();
        if (state.step >= steps_held || !has_supports()) return true;
        if (!trial) trial.emplace(grid, tube); // back from a later state
        return hold_rigid_parts(state, *trial, op, workspace, dt);
    }

    /// One step of at most state.dt; ends exactly at `until` if it gets there.
    void step(Real until)
    {
        if (max_threads() > threads)
            throw std::logic_error("a simulation cannot use more threads than it was built with");
        const Real remaining = until - state.t;
        const Real dt = std::isfinite(until) ? step_towards(remaining, state.dt) : state.dt;
        if (!hold_at_first(dt) || !advance(state, op, workspace, dt)) soundness.report_lost_wall();
        if (dt >= remaining) state.t = until;
        check();
    }
};

Simulation::Simulation(const Case& c) : impl_(std::make_unique<Impl>(c)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;

void Simulation::step(Real until) { impl_->step(until); }
void Simulation::back_to_good() { impl_->back_to_good(); }
void Simulation::set_step_factor(Real factor) { impl_->set_step_factor(factor); }
void Simulation::choose_step() { impl_->choose_step_anew(); }
const State& Simulation::state() const { return impl_->state; }
const State& Simulation::good_state() const { return impl_->good; }
void Simulation::restore(const std::function<void(State&)>& read,
                         const std::function<void(State&)>& read_good, Real step_factor)
{
    read(impl_->state);
    read_good(impl_->good);
    impl_->step_factor = step_factor;
    impl_->after_restore();
}
Real Simulation::time() const { return impl_->state.t; }
Index Simulation::steps() const { return impl_->state.step; }
Index Simulation::good_step() const { return impl_->good.step; }
Real Simulation::dt() const { return impl_->state.dt; }
const TimeStepLimit& Simulation::limiting() const { return smallest(impl_->limits); }
Real Simulation::spacing() const { return impl_->grid.delta(); }
Index Simulation::cells() const { return impl_->grid.cell_count(); }
Index Simulation::vertices() const { return impl_->tube.mesh.vertex_count(); }
VertexIndex Simulation::ring_size() const { return impl_->tube.ring_size; }
Index Simulation::elements() const { return impl_->tube.mesh.element_count(); }

Sample Simulation::sample()
{
    const Sample s = impl_->monitor.sample(impl_->state);
    if (!std::isfinite(s.Q_mid) || !std::isfinite(s.volume))
        impl_->soundness.report_not_finite("the flow rate is");
    return s;
}

std::vector<ProfileRow> Simulation::profile() const { return impl_->monitor.profile(impl_->state); }

std::vector<SectionPoint> Simulation::sections() const
{
    return impl_->monitor.sections(impl_->state);
}

std::vector<Vec3> Simulation::wall_shear_stress() const
{
    return impl_->monitor.wall_shear_stress(impl_->state);
}

WallSnapshot Simulation::wall_snapshot() const
{
    impl_->op.elastic.compute(impl_->state.wall.x, impl_->workspace.f);
    return impl_->monitor.wall(impl_->state, impl_->workspace.f);
}

FluidSnapshot Simulation::fluid_snapshot() const
{
    return reduced(impl_->monitor.fluid(impl_->state), impl_->description.output.fluid_part,
                   impl_->state.ghosts[0].inside);
}

Neighbourhood Simulation::neighbourhood(const Vec3& place) const
{
    const Real half_width = std::max(half_slab, half_slab_in_spacings * spacing());
    const Real begin = place.x - half_width, end = place.x + half_width;
    impl_->op.elastic.compute(impl_->state.wall.x, impl_->workspace.f);
    return {slab(impl_->monitor.wall_motion(impl_->state, impl_->workspace.f), begin, end),
            slab(impl_->monitor.fluid(impl_->state), begin, end)};
}

std::vector<PhaseTime> Simulation::phase_times() const
{
    std::vector<PhaseTime> times;
    const PhaseTimer& timer = impl_->workspace.timer;
    for (std::size_t n = 0; n < timer.names().size(); ++n)
        times.push_back({timer.names()[n], timer.seconds()[n]});
    return times;
}

} // namespace starling
