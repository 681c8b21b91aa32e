#include "simulation/simulation.hpp"

#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/for_each.hpp"
#include "solver/advance.hpp"
#include "solver/monitor.hpp"
#include "wall/perturbation.hpp"

namespace starling {

namespace {

Tube make_tube(const Case& c, const Grid& g)
{
    return make_tube(c.tube, c.tube.edge_over_spacing * g.delta());
}

constexpr Real contact_range = 2; ///< gap below which walls repel each other, in grid spacings

WallModel wall_model(const Case& c, Real delta)
{
    const Real reynolds = c.fluid.reynolds;
    // The filter works as fast as waves of the grid's scale relax.
    const ContactParameters contact = {c.material.contact * shear_modulus(c.material, reynolds),
                                       contact_range * delta};
    return {make_material(c.material, reynolds), bending_modulus(c.material, reynolds), contact,
            c.tube.mesh_filter / grid_wave_time(c, delta), c.tube.smoothing};
}

constexpr Index steps_between_checks = 10; ///< of speed, finiteness and the automatic step
constexpr Index steps_between_copies = 50; ///< of a sound state
constexpr Real touching = 0.25;            ///< gap at which walls touch, in grid spacings
constexpr Real largest_move = 0.5;         ///< of the wall in a step, in grid spacings

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
    State good; ///< the last state found sound
    Real good_cfl = 0;
    Real step_factor = 1;        ///< on the automatic step
    int threads = max_threads(); ///< scratch memory is made for so many

    explicit Impl(const Case& c)
        : description(c), grid(make_grid(c.grid, c.tube.length)), tube(make_tube(c, grid)),
          op(grid, tube, wall_model(c, grid.delta()), c.fluid, c.drive, c.coupling.scheme),
          workspace(grid, tube), state(grid, tube),
          monitor(grid, tube, op.elastic, op.bending, c.fluid.reynolds), good(grid, tube)
    {
        perturb(tube, c.perturbation, state.wall.x);
        initialise(state, op);
        choose_step(std::abs(c.pressure_ratio()));
        good = state;
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

    /// Limits of the present state; the step itself is part of the state.
    void after_restore()
    {
        good = state;
        const SpeedCheck check = check_speed(grid, state.fluid.u, state.dt);
        good_cfl = check.cfl;
        find_limits(std::max(check.u_max, std::abs(description.pressure_ratio())));
    }

    void set_step_factor(Real factor)
    {
        step_factor = factor;
        if (!description.time.step) state.dt = std::min(state.dt, factor * smallest(limits).dt);
    }

    void check_speed_and_step()
    {
        const SpeedCheck check = check_speed(grid, state.fluid.u, state.dt);
        if (!std::isfinite(check.u_max))
            fail("the velocity is not finite" + first_bad_face(), shorter_step());
        choose_step(std::max(check.u_max, std::abs(description.pressure_ratio())));
        if (state.step % steps_between_copies == 0) keep_if_sound(check.cfl);
    }

    /// A state that is about to blow up shows it by its speed.
    void keep_if_sound(Real cfl)
    {
        if (cfl > std::max(Real{1}, 2 * good_cfl) || farthest_move().spacings > largest_move)
            return;
        good = state;
        good_cfl = cfl;
    }

    std::string first_bad_face() const
    {
        for (Location c : components) {
            const Box b = grid.unknowns(c);
            for (Index i = b.begin[0]; i < b.end[0]; ++i)
                for (Index j = b.begin[1]; j < b.end[1]; ++j)
                    for (Index k = b.begin[2]; k < b.end[2]; ++k)
                        if (!std::isfinite(state.fluid.u[c](i, j, k)))
                            return " at " + describe(grid.position(c, i, j, k));
        }
        return "";
    }

    /// A place in the units of the case.
    std::string describe(const Vec3& p) const
    {
        const Real l = description.scaling.factor(Quantity::length);
        return fmt::format("x = {:.6g}, y = {:.6g}, z = {:.6g} {}", p.x * l, p.y * l, p.z * l,
                           description.scaling.unit(Quantity::length));
    }

    /// Throws a NumericalError that says when, in the units of the case.
    [[noreturn]] void fail(const std::string& what_and_where, const std::string& remedy) const
    {
        const Scaling& scaling = description.scaling;
        throw NumericalError(fmt::format("step {}, t = {:.6g} {}: {}", state.step,
                                         state.t * scaling.factor(Quantity::time),
                                         scaling.unit(Quantity::time), what_and_where),
                             remedy);
    }

    /// What to try when the step was too long.
    std::string shorter_step() const
    {
        if (!description.time.step) return "a smaller time step (--set time.safety=0.5)";
        const TimeStepLimit& limit = smallest(limits);
        const Scaling& scaling = description.scaling;
        return fmt::format("a smaller time step (--set time.step=auto; the limit named {} is "
                           "{:.3g} {})",
                           limit.name, limit.dt * scaling.factor(Quantity::time),
                           scaling.unit(Quantity::time));
    }

    /// Where the wall has gone wrong, as a NumericalError.
    [[noreturn]] void report_wall() const
    {
        report_lost_vertex();
        report_long_step();
        report_side_of_box();
        fail("the nodes beside the wall cannot be told apart as inside and outside",
             shorter_step() + ", or a finer grid");
    }

    void report_lost_vertex() const
    {
        for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) {
            const Vec3& p = state.wall.x[v];
            if (!std::isfinite(p.y) || !std::isfinite(p.z))
                fail("a wall vertex is not finite at " +
                         describe(tube.X[static_cast<std::size_t>(v)]),
                     shorter_step());
        }
    }

    /// The vertex that went farthest in the last step.
    struct Move {
        Real spacings = 0;
        VertexIndex vertex = 0;
    };
    Move farthest_move() const
    {
        Move most;
        for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) {
            const Real moved = norm(state.wall.velocity[v]) * state.fluid.dt_before / grid.delta();
            if (moved > most.spacings) most = {moved, v};
        }
        return most;
    }

    /// A wall that is driven to the side of the box moves slowly; one that a step too long throws
    /// there does not.
    void report_long_step() const
    {
        const Move most = farthest_move();
        if (most.spacings > largest_move)
            fail(
                fmt::format("the wall moved by {:.2g} grid spacings in one step at {}: the step is "
                            "too long",
                            most.spacings, describe(state.wall.x[most.vertex])),
                shorter_step());
        if (description.time.step && state.dt > smallest(limits).dt)
            fail("the wall is lost: the fixed step is too long", shorter_step());
    }

    void report_side_of_box() const
    {
        const Vec3 h = grid.spacing(), low = grid.origin(), size = grid.lengths();
        for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) {
            const Vec3& p = state.wall.x[v];
            if (p.y < low.y + 2 * h.y || p.y > low.y + size.y - 2 * h.y || p.z < low.z + 2 * h.z ||
                p.z > low.z + size.z - 2 * h.z)
                fail("the wall has reached the side of the box at " + describe(p),
                     "a wider box (grid.width_y, grid.width_z)");
        }
    }

    /// Stops before opposite walls pass through each other, and where they have.
    void check_walls() const
    {
        if (smallest_gap(tube, state.wall.x) >= touching * grid.delta() && !tangled()) return;
        for (Index ring = 0; ring < tube.rings(); ++ring) {
            if (crosses_itself(tube, state.wall.x, ring))
                fail("the wall has gone through itself" + section_of(ring), shorter_step());
            if (smallest_gap(tube, state.wall.x, ring) < touching * grid.delta())
                fail("opposite walls touch" + section_of(ring),
                     "a finer grid, or a repulsion that keeps them apart (wall.contact)");
        }
    }

    /// Whether a cross-section crosses itself.
    bool tangled() const
    {
        int count = 0;
#pragma omp parallel for schedule(static) reduction(+ : count)
        for (Index ring = tube.clamp_in; ring < tube.clamp_out; ++ring)
            count += crosses_itself(tube, state.wall.x, ring);
        return count > 0;
    }

    std::string section_of(Index ring) const
    {
        return fmt::format(" at x = {:.6g} {}",
                           tube.ring_x[static_cast<std::size_t>(ring)] *
                               description.scaling.factor(Quantity::length),
                           description.scaling.unit(Quantity::length));
    }

    /// One step of at most state.dt; ends exactly at `until` if it gets there.
    void step(Real until)
    {
        if (max_threads() > threads)
            throw std::logic_error("a simulation cannot use more threads than it was built with");
        const Real remaining = until - state.t;
        const Real dt = std::isfinite(until) ? step_towards(remaining, state.dt) : state.dt;
        if (!advance(state, op, workspace, dt)) report_wall();
        if (dt >= remaining) state.t = until;
        if (state.step % steps_between_checks == 0) {
            check_walls();
            check_speed_and_step();
        }
    }
};

Simulation::Simulation(const Case& c) : impl_(std::make_unique<Impl>(c)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;

void Simulation::step(Real until) { impl_->step(until); }
void Simulation::back_to_good() { impl_->state = impl_->good; }
void Simulation::set_step_factor(Real factor) { impl_->set_step_factor(factor); }
const State& Simulation::state() const { return impl_->state; }
void Simulation::restore(const std::function<void(State&)>& read, Real step_factor)
{
    read(impl_->state);
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
Index Simulation::elements() const { return impl_->tube.mesh.element_count(); }

Sample Simulation::sample()
{
    const Sample s = impl_->monitor.sample(impl_->state);
    if (!std::isfinite(s.Q_mid) || !std::isfinite(s.volume))
        impl_->fail("the flow rate is not finite" + impl_->first_bad_face(), impl_->shorter_step());
    return s;
}

std::vector<ProfileRow> Simulation::profile() const { return impl_->monitor.profile(impl_->state); }

std::vector<SectionPoint> Simulation::sections() const
{
    return impl_->monitor.sections(impl_->state);
}

WallSnapshot Simulation::wall_snapshot() const
{
    impl_->op.elastic.compute(impl_->state.wall.x, impl_->workspace.f);
    return impl_->monitor.wall(impl_->state, impl_->workspace.f);
}

FluidSnapshot Simulation::fluid_snapshot() const { return impl_->monitor.fluid(impl_->state); }

std::vector<PhaseTime> Simulation::phase_times() const
{
    std::vector<PhaseTime> times;
    const PhaseTimer& timer = impl_->workspace.timer;
    for (std::size_t n = 0; n < timer.names().size(); ++n)
        times.push_back({timer.names()[n], timer.seconds()[n]});
    return times;
}

} // namespace starling
