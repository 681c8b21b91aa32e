#include "simulation/forewarnings.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "theory/poiseuille.hpp"

namespace starling {

namespace {

using Warnings = std::vector<std::string>;

constexpr Real room_in_spacings = 3; ///< between tube and box, as for the tube at rest

std::string in_units(const Case& c, Real value, Quantity quantity)
{
    return fmt::format("{:.3g} {}", value * c.scaling.factor(quantity), c.scaling.unit(quantity));
}

/// A little more than the value, with two digits.
Real rounded_up(Real value)
{
    const Real digit = std::pow(Real{10}, std::floor(std::log10(value)) - 1);
    return digit * std::ceil(value / digit);
}

void warn_of_step(Warnings& found, const Case& c, const RunEstimate& e)
{
    for (const TimeStepLimit& limit : e.limits)
        if (c.time.step && *c.time.step > limit.dt)
            found.push_back(fmt::format("the fixed time step is {:.1f} times the limit named {}: "
                                        "the run may break down",
                                        *c.time.step / limit.dt, limit.name));
}

void warn_of_speed(Warnings& found, const Case& c, const Prediction& p, const RunEstimate& e)
{
    if (!p.failure.empty())
        found.push_back(p.failure + ": the tube may widen without end, or the flow choke and "
                                    "oscillate; take a smaller pressure drop or a stiffer wall");
    const Real speed = expected_speed(c, p);
    if (c.tube.rigid || !(speed > e.wave_speed)) return;
    found.push_back(fmt::format(
        "the flow is faster than the waves of the wall: about {} on the axis, against a "
        "Moens-Korteweg speed of {}. Where the stream outruns the waves it chokes, and the tube "
        "may oscillate or run away instead of becoming steady; take a smaller pressure drop or a "
        "stiffer wall",
        in_units(c, speed, Quantity::velocity), in_units(c, e.wave_speed, Quantity::velocity)));
}

/// One direction across the tube, from the axis to the nearer side.
struct Side {
    const char* key;
    Real width, offset, spacing;
};

void warn_of_box(Warnings& found, const Case& c, const Prediction& p, const RunEstimate& e)
{
    if (!p.tube) return;
    const GridParameters& g = c.grid;
    for (const Side& side : {Side{"grid.width_y", g.width_y, g.tube_offset_y, e.spacing.y},
                             Side{"grid.width_z", g.width_z, g.tube_offset_z, e.spacing.z}}) {
        const Real needed = p.tube->R_max + room_in_spacings * side.spacing;
        if (needed <= side.width / 2 - std::abs(side.offset)) continue;
        const Real width = rounded_up(2 * (needed + std::abs(side.offset)));
        found.push_back(fmt::format(
            "the tube is expected to widen to a radius of {}, and would reach the side of the box, "
            "{} from the axis: the run would end there. Set {} to at least {}",
            in_units(c, p.tube->R_max, Quantity::length),
            in_units(c, side.width / 2 - std::abs(side.offset), Quantity::length), side.key,
            in_units(c, width, Quantity::length)));
    }
}

void warn_of_early_end(Warnings& found, const Case& c, const RunEstimate& e)
{
    if (!c.stop.steady_tolerance) return;
    const Real steady = expected_time_to_steady(c, *c.stop.steady_tolerance);
    const std::string reason = fmt::format(
        "the run ends before it can be expected to be steady, which takes {} {}: raise ",
        may_collapse(c) ? "more than" : "about", in_units(c, steady, Quantity::time));
    if (c.stop.end_time && *c.stop.end_time < steady)
        found.push_back(reason + "stop.end_time or leave it out");
    if (c.stop.steps && static_cast<Real>(*c.stop.steps) * e.dt < steady)
        found.push_back(reason + fmt::format("stop.steps to at least {:.0f} or leave it out",
                                             rounded_up(steady / e.dt)));
}

void warn_of_collapse(Warnings& found, const Case& c, const RunEstimate& e)
{
    if (!may_collapse(c)) return;
    if (!c.stop.steady_tolerance) {
        found.push_back(
            "the pressure inside is lower than outside, at times at least: the tube may "
            "buckle until its walls meet, where the run ends. starling theory tells at "
            "which load it buckles; wall.bending resists, wall.contact keeps opposite "
            "walls apart");
        return;
    }
    found.push_back(fmt::format(
        "the pressure inside is lower than outside: a tube that buckles drains through its "
        "narrowest place, and becomes steady far later than the open tube, whose relaxation time "
        "of {} is all that is known here. The shipped cases collapse_mode2 to collapse_mode5 took "
        "30 to 200 times the time stated. Watch the run; starling theory tells whether the tube "
        "buckles",
        in_units(c, e.relaxation_time, Quantity::time)));
}

} // namespace

Prediction predict(const Case& c)
{
    const bool known = c.tube.rigid || c.tube.rest_radius.uniform(); // to the model
    if (may_collapse(c) || !c.drive.gives_pressures() || !known) return {};
    try {
        return {solve_one_dimensional({c.tube, c.material, c.fluid, c.drive.widest()}), ""};
    } catch (const NumericalError& e) {
        const std::string text = e.what();
        return {std::nullopt, text.substr(0, text.find('\n'))};
    }
}

Real expected_speed(const Case& c, const Prediction& prediction)
{
    if (c.drive.inlet_flow.given)
        return c.drive.largest_inlet_flow() / poiseuille::baseline_flow_rate;
    if (!prediction.tube) return std::abs(c.pressure_ratio());
    return std::abs(prediction.tube->Q) / poiseuille::baseline_flow_rate;
}

std::vector<std::string> forewarnings(const Case& c, const Prediction& prediction,
                                      const RunEstimate& e)
{
    Warnings found;
    warn_of_step(found, c, e);
    warn_of_speed(found, c, prediction, e);
    warn_of_box(found, c, prediction, e);
    warn_of_early_end(found, c, e);
    warn_of_collapse(found, c, e);
    return found;
}

} // namespace starling
