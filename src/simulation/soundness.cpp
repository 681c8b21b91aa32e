#include "simulation/soundness.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "wall/lumen.hpp"

namespace starling {

namespace {

constexpr Real touching = 0.25;        ///< gap at which walls touch, in grid spacings
constexpr Real longest_move = 1;       ///< of the wall in a step, in grid spacings
constexpr Real suspect_move = 0.5;     ///< one that explains why the wall is lost
constexpr Real largest_cfl = 2;        ///< and
constexpr Real far_over_the_limit = 4; ///< of the limit named advection: the flow runs away
constexpr Real folded = -0.95;         ///< cosine of the angle between neighbouring elements

bool is_finite(const Vec3& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

} // namespace

Soundness::Soundness(const Case& c, const Grid& g, const Tube& tube, const State& state,
                     const std::vector<TimeStepLimit>& limits)
    : case_(c), grid_(g), tube_(tube), state_(state), limits_(limits)
{
}

// The pressure solve carries a value that is not finite to every cell within the step.
void Soundness::check_step() const
{
    const Move most = farthest_move();
    if (!std::isfinite(state_.fluid.P(0, 0, 0)) || !std::isfinite(most.spacings))
        report_not_finite("velocity and pressure are");
    check_move(most, longest_move);
}

void Soundness::check_flow(const SpeedCheck& speed) const
{
    if (!std::isfinite(speed.u_max)) report_not_finite("the velocity is");
    // The limits of the case are still those of the last speed that was sound.
    for (const TimeStepLimit& limit : time_step_limits(case_, grid_.delta(), speed.u_max)) {
        const bool over = state_.fluid.dt_before > far_over_the_limit * limit.dt;
        if (limit.name != "advection" || !over || speed.cfl <= largest_cfl) continue;
        const Face face = worst_face(state_.fluid.u);
        fail(fmt::format("the flow runs through {:.2g} grid spacings in one step{}: its advection "
                         "is unstable ({})",
                         speed.cfl, at_face(face), limiting_term()),
             shorter_step(), {position(face), true});
    }
}

void Soundness::report_not_finite(const std::string& what) const
{
    // The advection term is of the velocity before this step: the last that was finite.
    const Face face = worst_face(state_.fluid.N_before);
    fail(fmt::format("{} not finite; the flow was wildest{} ({})", what, at_face(face),
                     limiting_term()),
         shorter_step(), {position(face), true});
}

void Soundness::report_lost_wall() const
{
    const Move most = farthest_move();
    if (!std::isfinite(most.spacings)) report_not_finite("velocity and pressure are");
    check_move(most, suspect_move);
    if (case_.time.step && state_.dt > smallest(limits_).dt)
        fail(fmt::format("the wall is lost: the fixed step is too long; it moves fastest{} ({})",
                         at_vertex(most.vertex), limiting_term()),
             shorter_step(), {state_.wall.x[most.vertex], true});
    check_side_of_box();
    check_folds();
    check_gaps();
    fail(fmt::format("the search for ghost nodes does not close: nodes beside the wall cannot be "
                     "told apart as inside and outside; the wall moves fastest{}",
                     at_vertex(most.vertex)),
         shorter_step() + ", or a finer grid", {state_.wall.x[most.vertex], true});
}

Soundness::Move Soundness::farthest_move() const
{
    Move most;
    for (VertexIndex v = tube_.moving_begin(); v < tube_.moving_end(); ++v) {
        const Real moved = norm(state_.wall.velocity[v]) * state_.fluid.dt_before / grid_.delta();
        if (!(moved <= most.spacings)) most = {moved, v};
        if (!std::isfinite(moved)) break;
    }
    return most;
}

/// A wall that is driven to the side of the box moves slowly; one that a step too long throws there
/// does not.
void Soundness::check_move(const Move& most, Real longest) const
{
    if (most.spacings <= longest) return;
    fail(fmt::format("the wall moved by {:.2g} grid spacings in one step{}: the step is too long "
                     "({})",
                     most.spacings, at_vertex(most.vertex), limiting_term()),
         shorter_step(), {state_.wall.x[most.vertex], true});
}

void Soundness::check_side_of_box() const
{
    const Vec3 h = grid_.spacing(), low = grid_.origin(), size = grid_.lengths();
    for (VertexIndex v = tube_.moving_begin(); v < tube_.moving_end(); ++v) {
        const Vec3& p = state_.wall.x[v];
        if (p.y < low.y + 2 * h.y || p.y > low.y + size.y - 2 * h.y || p.z < low.z + 2 * h.z ||
            p.z > low.z + size.z - 2 * h.z)
            fail("the wall has reached the side of the box" + at_vertex(v) +
                     ": the tube is wider than the box",
                 "a wider box (grid.width_y, grid.width_z)", {p, false});
    }
}

void Soundness::check_gaps() const
{
    const Array<Vec3>& x = state_.wall.x;
    const Real closest = touching * grid_.delta();
    if (smallest_gap(tube_, x) >= closest && !tangled()) return;
    for (Index ring = 0; ring < tube_.rings(); ++ring) {
        const VertexIndex v = narrowest_vertex(ring);
        if (crosses_itself(tube_, x, ring))
            fail(fmt::format("the wall has gone through itself{} ({})", at_vertex(v),
                             limiting_term()),
                 shorter_step(), {x[v], true});
        if (smallest_gap(tube_, x, ring) < closest)
            fail(
                fmt::format("opposite walls touch{}: nothing but the fluid between them, which the "
                            "grid no longer resolves, holds them apart",
                            at_vertex(v)),
                "a finer grid, or a repulsion that keeps them apart (wall.contact)", {x[v], false});
    }
}

void Soundness::check_folds() const
{
    const ElementIndex e = folded_element();
    if (e < 0) return;
    const VertexIndex v = tube_.mesh.element(e)[0];
    fail(fmt::format("element {} is inverted: it is folded onto its neighbour{} ({})", e,
                     at_vertex(v), limiting_term()),
         shorter_step() + ", or a wall that resists bending (wall.bending)",
         {state_.wall.x[v], true});
}

/// The first element whose normal points against a neighbour's; -1 if there is none.
ElementIndex Soundness::folded_element() const
{
    const Array<Vec3>& x = state_.wall.x;
    const auto normal = [&](ElementIndex e) {
        const auto& v = tube_.mesh.element(e);
        return cross(x[v[1]] - x[v[0]], x[v[2]] - x[v[0]]);
    };
    ElementIndex first = tube_.mesh.element_count();
#pragma omp parallel for schedule(static) reduction(min : first)
    for (ElementIndex e = 0; e < tube_.mesh.element_count(); ++e) {
        const Vec3 n = normal(e);
        for (int side = 0; side < 3; ++side) {
            const ElementIndex other = tube_.mesh.neighbour(e, side);
            if (other < e) continue; // none, or looked at from there
            const Vec3 m = normal(other);
            const Real along = dot(n, m);
            if (along < 0 && along < folded * norm(n) * norm(m)) first = std::min(first, e);
        }
    }
    return first < tube_.mesh.element_count() ? first : -1;
}

/// Whether a cross-section crosses itself.
bool Soundness::tangled() const
{
    int count = 0;
#pragma omp parallel for schedule(static) reduction(+ : count)
    for (Index ring = tube_.clamp_in; ring < tube_.clamp_out; ++ring)
        count += crosses_itself(tube_, state_.wall.x, ring);
    return count > 0;
}

VertexIndex Soundness::narrowest_vertex(Index ring) const
{
    const VertexIndex first = tube_.first(ring);
    VertexIndex narrowest = first;
    Real least = std::numeric_limits<Real>::infinity();
    for (VertexIndex n = 0; n < tube_.ring_size; ++n) {
        const Real width = lumen_width(&state_.wall.x[first], tube_.ring_size, n);
        if (width < least) least = width, narrowest = first + n;
    }
    return narrowest;
}

std::string Soundness::at_point(const Vec3& p) const
{
    const Real l = case_.scaling.factor(Quantity::length);
    return fmt::format(" at x = {:.6g}, y = {:.6g}, z = {:.6g} {}", p.x * l, p.y * l, p.z * l,
                       case_.scaling.unit(Quantity::length));
}

std::string Soundness::at_vertex(VertexIndex v) const
{
    const Vec3 &p = state_.wall.x[v], &X = tube_.X[static_cast<std::size_t>(v)];
    return fmt::format("{}, theta = {:.0f} degrees (vertex {})", at_point(is_finite(p) ? p : X),
                       std::atan2(X.z, X.y) * 180 / pi, v);
}

std::string Soundness::at_face(const Face& f) const
{
    const Vec3 p = position(f);
    return fmt::format("{}, theta = {:.0f} degrees (cell {}, {}, {})", at_point(p),
                       std::atan2(p.z, p.y) * 180 / pi, f.i, f.j, f.k);
}

Soundness::Face Soundness::worst_face(const VectorField& values) const
{
    Face worst;
    Real largest = -1;
    for (Location c : components) {
        const Box b = grid_.unknowns(c);
        for (Index i = b.begin[0]; i < b.end[0]; ++i)
            for (Index j = b.begin[1]; j < b.end[1]; ++j)
                for (Index k = b.begin[2]; k < b.end[2]; ++k) {
                    const Real value = std::abs(values[c](i, j, k));
                    if (value <= largest) continue;
                    worst = {c, i, j, k};
                    largest = value;
                    if (!std::isfinite(value)) return worst;
                }
    }
    return worst;
}

std::string Soundness::limiting_term() const
{
    const TimeStepLimit& limit = smallest(limits_);
    return fmt::format("term: {}; the step is {:.2g} times its limit", limit.name,
                       state_.fluid.dt_before / limit.dt);
}

/// What to try when the step was too long.
std::string Soundness::shorter_step() const
{
    if (!case_.time.step) return "a smaller time step (--set time.safety=0.5)";
    const TimeStepLimit& limit = smallest(limits_);
    return fmt::format("a smaller time step (--set time.step=auto; the limit named {} is {:.3g} "
                       "{})",
                       limit.name, limit.dt * case_.scaling.factor(Quantity::time),
                       case_.scaling.unit(Quantity::time));
}

/// Throws a NumericalError that says when, in the units of the case.
void Soundness::fail(const std::string& what_and_where, const std::string& remedy,
                     const Breakdown& breakdown) const
{
    const Scaling& scaling = case_.scaling;
    throw NumericalError(fmt::format("step {}, t = {:.6g} {}: {}", state_.step,
                                     state_.t * scaling.factor(Quantity::time),
                                     scaling.unit(Quantity::time), what_and_where),
                         remedy, breakdown);
}

} // namespace starling
