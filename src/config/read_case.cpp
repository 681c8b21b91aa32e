#include "config/read_case.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "config/case_values.hpp"
#include "config/input_file.hpp"
#include "config/read_along_x.hpp"
#include "config/read_drive.hpp"
#include "config/read_scaling.hpp"
#include "config/read_wall.hpp"
#include "config/shipped_cases.hpp"
#include "config/validate.hpp"
#include "config/write_case.hpp"

namespace starling {

namespace {

void read_grid(CaseValues& values, const Case& c, GridParameters& g)
{
    values.fill("grid.width_y", g.width_y);
    values.fill("grid.width_z", g.width_z);
    values.fill("grid.spacing", g.spacing);
    values.fill("grid.cells", g.cells);
    values.fill("grid.tube_offset_y", g.tube_offset_y);
    values.fill("grid.tube_offset_z", g.tube_offset_z);
    if (!g.cells) return;
    if (values.given("grid.spacing")) values.problem("grid.cells", "give it or spacing, not both");
    const Vec3 d = spacings(g, c.tube.length);
    g.spacing = std::cbrt(d.x * d.y * d.z);
}

void read_numerics(CaseValues& values, Case& c)
{
    const std::string scheme = values.text("coupling.scheme", "conserving");
    if (scheme == "printed") c.coupling.scheme = CouplingScheme::printed;
    if (scheme == "reaction") c.coupling.scheme = CouplingScheme::reaction;
    if (scheme == "conserving") c.coupling.scheme = CouplingScheme::conserving;
    values.fill("fluid.theta", c.fluid.theta);
    values.fill("time.step", c.time.step);
    values.fill("time.safety", c.time.safety);
    values.fill("time.cycle_samples", c.time.cycle_samples);
}

/// Cycles that agree need a drive that repeats, and samples to compare.
void check_periodic(CaseValues& values, const Case& c)
{
    constexpr Index fewest_samples = 8;
    if (!c.stop.periodic_tolerance) return;
    if (c.drive.period() == 0)
        values.problem(
            "stop.periodic_tolerance",
            c.drive.has_waveform()
                ? "needs waveforms that repeat after a common period; this drive has none"
                : "needs a drive with a period: give a waveform one, or take "
                  "steady_tolerance or end_time instead");
    if (c.time.cycle_samples < fewest_samples)
        values.problem("time.cycle_samples",
                       fmt::format("is {}; with periodic_tolerance it must be at least {}",
                                   c.time.cycle_samples, fewest_samples));
}

/// A drive that changes in time has no steady state to stop at.
void read_stop(CaseValues& values, bool unsteady, StopParameters& stop)
{
    const bool any = values.given("stop.end_time") || values.given("stop.steps") ||
                     values.given("stop.steady_tolerance") ||
                     values.given("stop.periodic_tolerance") || values.given("stop.wall_clock");
    values.fill("stop.end_time", stop.end_time);
    values.fill("stop.steps", stop.steps);
    values.fill("stop.steady_tolerance", stop.steady_tolerance);
    values.fill("stop.periodic_tolerance", stop.periodic_tolerance);
    values.fill("stop.wall_clock", stop.wall_clock);
    if (unsteady && stop.steady_tolerance)
        values.problem("stop.steady_tolerance", "cannot be met by a drive with a waveform: give "
                                                "periodic_tolerance, end_time, steps or wall_clock "
                                                "instead");
    if (any) return;
    if (unsteady)
        return values.missing("stop.end_time",
                              "or give periodic_tolerance, steps or wall_clock: a drive with a "
                              "waveform has no steady state to stop at");
    if (values.has_section("stop"))
        values.missing("stop.steady_tolerance", "or give end_time, steps or wall_clock");
    stop.steady_tolerance = 1e-4;
    stop.steps = 200000;
}

void read_output(CaseValues& values, OutputParameters& output)
{
    values.fill("output.sample_every", output.sample_every);
    values.fill("output.wall_every", output.wall_every);
    values.fill("output.fluid_every", output.fluid_every);
    values.fill("output.wall", output.wall);
    values.fill("output.fluid", output.fluid);
    values.fill("output.fluid_stride", output.fluid_part.stride);
    const std::string region = values.text("output.fluid_region", "box");
    if (region == "tube") output.fluid_part.region = FluidRegion::tube;
    if (region == "plane_y") output.fluid_part.region = FluidRegion::plane_y;
    if (region == "plane_z") output.fluid_part.region = FluidRegion::plane_z;
    output.double_precision = values.text("output.precision", "single") == "double";
}

void read_checkpoint(CaseValues& values, CheckpointParameters& checkpoint)
{
    values.fill("checkpoint.every", checkpoint.every);
    values.fill("checkpoint.steps", checkpoint.steps);
    values.fill("checkpoint.keep", checkpoint.keep);
}

std::string read_text(const std::filesystem::path& file)
{
    try {
        return input_text(file);
    } catch (const std::invalid_argument& e) {
        std::string what = e.what();
        if (!std::filesystem::exists(file)) what += "; " + shipped_cases_hint();
        throw InputError({{file.string(), 0, "", what}});
    }
}

} // namespace

Case read_case_text(std::string_view text, const std::string& name,
                    const std::vector<std::string>& overrides)
{
    CaseValues values(parse_document(text, name, overrides));
    Case c;
    c.scaling = read_scaling(values);
    c.title = values.text("title", "");
    read_reynolds(values, c.scaling, c.fluid.reynolds);
    read_wall(values, c);
    read_along_x(values, c, std::filesystem::path(name).parent_path());
    read_drive(values, c, std::filesystem::path(name).parent_path());
    read_grid(values, c, c.grid);
    read_numerics(values, c);
    read_stop(values, c.drive.has_waveform(), c.stop);
    check_periodic(values, c);
    read_output(values, c.output);
    read_checkpoint(values, c.checkpoint);
    validate(values, c);
    values.throw_problems();
    return c;
}

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
    const std::string text = read_text(file);
    if (lacks_end(text))
        throw InputError({{file.string(), 0, "", "is cut off: its last line is missing"}});
    return read_case_text(text, file.string(), overrides);
}

} // namespace starling
