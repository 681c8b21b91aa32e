#include "simulation/estimate.hpp"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>

#include "core/error.hpp"
#include "grid/grid.hpp"
#include "simulation/cycles.hpp"
#include "simulation/forewarnings.hpp"
#include "simulation/steady.hpp"
#include "theory/wave_speed.hpp"

namespace starling {

namespace {

constexpr Real bytes_of_program = 40e6;
constexpr Real bytes_per_cell = 275;
constexpr Real bytes_per_vertex = 1300;
constexpr Real change_over_window = 0.22; ///< 1 - exp(-1/4)

void count_wall(RunEstimate& e, const Case& c, Real delta)
{
    const Real edge = c.tube.edge_over_spacing * delta;
    const Real ring = std::max(Real{4}, 2 * std::round(pi / edge));
    const Real rows = std::max(Real{1}, std::round(c.tube.length / (edge * std::sqrt(0.75))));
    e.vertices = static_cast<Index>(ring * (rows + 1));
    e.elements = static_cast<Index>(2 * ring * rows);
}

void choose_step(RunEstimate& e, const Case& c, Real speed, Real delta)
{
    e.limits = time_step_limits(c, delta, speed);
    if (c.time.step)
        e.binding = {"fixed by the case", *c.time.step};
    else if (!e.limits.empty())
        e.binding = smallest(e.limits);
    e.dt = e.binding.dt;
}

/// Before that no cycle can be compared with another.
Real time_of_two_cycles(const Case& c) { return first_cycle(c, 0) + 2 * c.drive.period(); }

Real expected_duration(const Case& c, Real dt)
{
    Real duration = std::numeric_limits<Real>::infinity();
    if (c.stop.end_time) duration = *c.stop.end_time;
    if (c.stop.steps) duration = std::min(duration, static_cast<Real>(*c.stop.steps) * dt);
    if (c.stop.steady_tolerance)
        duration = std::min(duration, expected_time_to_steady(c, *c.stop.steady_tolerance));
    if (c.stop.periodic_tolerance) duration = std::min(duration, time_of_two_cycles(c));
    return duration;
}

} // namespace

void check_memory(const Case& c, Index available)
{
    const Index needed = estimate_run(c).memory_bytes;
    if (needed <= available) return;
    const auto in_gigabytes = [](Index bytes) {
        std::ostringstream text;
        text << std::setprecision(3) << static_cast<Real>(bytes) / 1e9 << " GB";
        return text.str();
    };
    throw InputError("the case needs about " + in_gigabytes(needed) + " of memory and " +
                     in_gigabytes(available) + " are free: take a larger grid.spacing");
}

Real expected_time_to_steady(const Case& c, Real tolerance)
{
    return relaxation_time(c) * std::max(Real{1}, std::log(change_over_window / tolerance));
}

bool may_collapse(const Case& c)
{
    const DriveParameters d = c.drive.narrowest();
    return !c.tube.rigid && d.gives_pressures() &&
           std::min(d.pressure_inlet, d.pressure_outlet) < d.pressure_external;
}

RunEstimate estimate_run(const Case& c)
{
    RunEstimate e;
    const Grid grid = make_grid(c.grid, c.tube.length);
    e.cells_xyz = grid.cells();
    e.spacing = grid.spacing();
    e.cells = grid.cell_count();
    count_wall(e, c, grid.delta());
    e.memory_bytes =
        static_cast<Index>(bytes_of_program + bytes_per_cell * static_cast<Real>(e.cells) +
                           bytes_per_vertex * static_cast<Real>(e.vertices));
    e.wave_speed = c.tube.rigid ? std::numeric_limits<Real>::quiet_NaN()
                                : wave_speed(c.material, c.fluid.reynolds);
    const Prediction prediction = predict(c);
    choose_step(e, c, expected_speed(c, prediction), grid.delta());
    e.relaxation_time = relaxation_time(c);
    e.duration = expected_duration(c, e.dt);
    e.at_least = (may_collapse(c) && c.stop.steady_tolerance &&
                  e.duration == expected_time_to_steady(c, *c.stop.steady_tolerance)) ||
                 (c.stop.periodic_tolerance && e.duration == time_of_two_cycles(c));
    e.steps = std::ceil(e.duration / e.dt);
    e.seconds = e.steps * static_cast<Real>(e.cells) / assumed_cell_steps_per_second;
    if (c.stop.wall_clock) e.seconds = std::min(e.seconds, *c.stop.wall_clock);
    e.warnings = forewarnings(c, prediction, e);
    return e;
}

} // namespace starling
