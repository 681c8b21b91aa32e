#include "config/validate.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace starling {

namespace {

constexpr Real room_in_spacings = 3;           ///< between the tube and the box
constexpr Real rigid_end_in_spacings = 2;      ///< for the ghost nodes of a rigid end
constexpr Real deforming_part_in_spacings = 4; ///< the wall's force spreads over this width
constexpr Real largest_cell_count = 2e9;
constexpr Real largest_spacing_ratio = 1.25;
constexpr Real largest_step_count = 1e9;

/// The key that sets the spacing, for messages.
std::string_view spacing_key(const Case& c) { return c.grid.cells ? "grid.cells" : "grid.spacing"; }

/// Room for a tube of the largest rest radius that it has.
void check_room(CaseValues& values, std::string_view width_key, std::string_view offset_key,
                Real width, Real offset, Real spacing, Real radius)
{
    if (!values.sound({width_key, offset_key, "grid.spacing", "grid.cells"})) return;
    const Real room = width / 2 - std::abs(offset) - radius;
    if (room >= room_in_spacings * spacing) return;
    const Real least = 2 * (radius + std::abs(offset) + room_in_spacings * spacing);
    values.problem(width_key,
                   fmt::format("leaves {} between the tube and the box; 3 spacings are needed, so "
                               "at least {} for this offset and spacing",
                               values.in_units(width_key, room),
                               values.in_units(width_key, least)));
}

void check_cells(CaseValues& values, const Case& c, const Vec3& d)
{
    const std::string_view key = spacing_key(c);
    if (!values.sound({key, "vessel.length", "grid.width_y", "grid.width_z"})) return;
    const Real count = c.tube.length / d.x * (c.grid.width_y / d.y) * (c.grid.width_z / d.z);
    if (!(count <= largest_cell_count))
        return values.problem(key, fmt::format("asks for {:.3g} cells; at most {:.3g} are allowed",
                                               count, largest_cell_count));
    const Real least = std::min({d.x, d.y, d.z}), most = std::max({d.x, d.y, d.z});
    if (most > largest_spacing_ratio * least)
        values.problem(key, fmt::format("gives the spacings {:.4g}, {:.4g}, {:.4g} R_0; they must "
                                        "not differ by more than a factor of {:g}",
                                        d.x, d.y, d.z, largest_spacing_ratio));
    if (c.grid.cells) {
        const Range& range = case_key("grid.spacing").range;
        if (!range.contains(most))
            values.problem(key, fmt::format("gives a spacing of {:.4g} R_0; it must be {} R_0",
                                            most, range.describe()));
    }
}

void check_segments(CaseValues& values, const TubeParameters& tube, Real spacing)
{
    const Real deforming = tube.length - tube.rigid_inlet - tube.rigid_outlet;
    const auto words = [&](std::string_view key, Real x) { return values.in_units(key, x); };
    if (!values.sound({"vessel.length", "vessel.rigid_inlet", "vessel.rigid_outlet"})) return;
    if (deforming <= 0)
        return values.problem("vessel.length",
                              fmt::format("is {}; the rigid inlet and outlet together take {} and "
                                          "leave nothing that deforms",
                                          words("vessel.length", tube.length),
                                          words("vessel.length", tube.length - deforming)));
    if (!values.sound({"grid.spacing", "grid.cells"})) return;
    if (deforming < deforming_part_in_spacings * spacing)
        values.problem("vessel.length",
                       fmt::format("leaves a deforming part of {}; at least 4 spacings of {} are "
                                   "needed",
                                   words("vessel.length", deforming),
                                   words("grid.spacing", spacing)));
    for (const auto& [key, end] : {std::pair{"vessel.rigid_inlet", tube.rigid_inlet},
                                   std::pair{"vessel.rigid_outlet", tube.rigid_outlet}})
        if (end < rigid_end_in_spacings * spacing)
            values.problem(key, fmt::format("is {}, under 2 grid spacings of {}: make it longer or "
                                            "the spacing finer",
                                            words(key, end), words("grid.spacing", spacing)));
}

/// The ends are built for a radius of R_0, the narrowest place must hold a few cells.
void check_rest_radius(CaseValues& values, const Case& c, Real spacing)
{
    constexpr Real round_off = 1e-9, least_in_spacings = 2;
    const AlongX& radius = c.tube.rest_radius;
    if (radius.uniform() || !values.sound({"vessel.length"})) return;
    const std::string_view key =
        values.given("rest_radius.shape") ? "rest_radius.shape" : "rest_radius.values";
    for (Real end : {Real{0}, c.tube.length})
        if (std::abs(radius(end) - 1) > round_off)
            values.problem(values.given(key) ? key : "rest_radius.file",
                           fmt::format("gives the factor {:.6g} at x = {}; it must be 1 at both "
                                       "ends of the tube",
                                       radius(end), values.in_units("vessel.length", end)));
    if (radius.lowest() < least_in_spacings * spacing)
        values.problem(values.given(key) ? key : "rest_radius.file",
                       fmt::format("narrows the tube to a radius of {}, under 2 grid spacings of "
                                   "{}: take a finer grid",
                                   values.in_units("vessel.length", radius.lowest()),
                                   values.in_units("grid.spacing", spacing)));
}

void check_duration(CaseValues& values, const Case& c)
{
    if (!c.time.step || !c.stop.end_time || !values.sound({"time.step", "stop.end_time"})) return;
    const Real steps = *c.stop.end_time / *c.time.step;
    if (steps > largest_step_count)
        values.problem("time.step", fmt::format("needs {:.3g} steps to end_time; at most {:.3g} "
                                                "are allowed",
                                                steps, largest_step_count));
    if (steps < 1) values.problem("time.step", "is longer than end_time");
}

} // namespace

Vec3 spacings(const GridParameters& grid, Real tube_length)
{
    if (!grid.cells) return {grid.spacing, grid.spacing, grid.spacing};
    const auto& n = *grid.cells;
    return {tube_length / static_cast<Real>(n[0]), grid.width_y / static_cast<Real>(n[1]),
            grid.width_z / static_cast<Real>(n[2])};
}

void validate(CaseValues& values, const Case& c)
{
    const Vec3 d = spacings(c.grid, c.tube.length);
    check_room(values, "grid.width_y", "grid.tube_offset_y", c.grid.width_y, c.grid.tube_offset_y,
               d.y, c.tube.rest_radius.highest());
    check_room(values, "grid.width_z", "grid.tube_offset_z", c.grid.width_z, c.grid.tube_offset_z,
               d.z, c.tube.rest_radius.highest());
    check_cells(values, c, d);
    check_rest_radius(values, c, std::max(d.y, d.z));
    if (!c.tube.rigid && values.sound({"vessel.rigid"})) check_segments(values, c.tube, d.x);
    check_duration(values, c);
}

} // namespace starling
