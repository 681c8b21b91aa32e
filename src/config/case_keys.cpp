#include "config/case_keys.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace starling {

namespace {

constexpr auto plain = UnitSystem::dimensionless;
constexpr auto si = UnitSystem::si;
constexpr auto none = Quantity::none;
constexpr auto length = Quantity::length;
constexpr auto pressure = Quantity::pressure;

Range closed(Real min, Real max) { return {min, max}; }
Range positive() { return {.min = 0, .open_min = true}; }
Range positive_to(Real max) { return {.min = 0, .max = max, .open_min = true}; }

std::vector<KeyRule> flow_keys()
{
    using enum Kind;
    const std::vector<std::string_view> systems = {"dimensionless", "si"};
    const Range any_pressure = closed(-1e12, 1e12);
    return {
        {"", "title", text, "a line that names the run"},
        {"", "units", choice, "unit system of the file", none, {}, systems},

        {"fluid",
         "reynolds",
         number,
         "Reynolds number rho U_c R_0/mu",
         none,
         closed(1e-6, 1e4),
         {},
         plain,
         "give density and viscosity"},
        {"fluid",
         "density",
         measure,
         "density of the fluid",
         Quantity::density,
         positive(),
         {},
         si,
         "give reynolds"},
        {"fluid",
         "viscosity",
         measure,
         "viscosity of the fluid",
         Quantity::viscosity,
         positive(),
         {},
         si,
         "give reynolds"},
        {"fluid", "theta", number, "weight of the new time level in diffusion", none,
         closed(0.5, 1)},

        {"drive",
         "pressure_ratio",
         number,
         "applied pressure drop over 4 L/Re",
         none,
         closed(-1000, 1000),
         {},
         plain,
         "give pressure_inlet instead"},
        {"drive", "pressure_inlet", measure, "pressure at the inlet", pressure, any_pressure},
        {"drive", "pressure_outlet", measure, "pressure at the outlet", pressure, any_pressure},
        {"drive", "pressure_external", measure, "pressure outside the tube", pressure,
         any_pressure},
        {"drive",
         "end_pressure",
         choice,
         "whether the pressure is that of the fluid on the face or of the reservoir it comes from",
         none,
         {},
         {"static", "total"}},
        {"drive",
         "ramp",
         measure,
         "time in which the drive rises from zero",
         Quantity::time,
         {.min = 0}},
        {"drive",
         "velocity_scale",
         measure,
         "velocity scale U_c",
         Quantity::velocity,
         positive(),
         {},
         si,
         "velocities are in units of U_c already: leave it out"},
    };
}

/// A section for what is added to a pressure or flow rate.
std::vector<KeyRule> waveform_keys(std::string_view section, Quantity quantity)
{
    using enum Kind;
    const Range factor = closed(-1e6, 1e6), instant = {.min = 0, .max = 1e12};
    return {
        {section, "amplitude", measure, "what the shape is multiplied by", quantity,
         closed(-1e12, 1e12)},
        {section, "period", measure, "time after which it repeats", Quantity::time, positive()},
        {section, "cosine", numbers, "cosine terms of a Fourier series, from the first harmonic",
         none, factor},
        {section, "sine", numbers, "sine terms of a Fourier series, from the first harmonic", none,
         factor},
        {section, "times", numbers, "increasing times of a table, in time_scale", none, instant},
        {section, "values", numbers, "values of a table, in amplitude", none, factor},
        {section, "file", text, "CSV file with a header row and the columns time and value"},
        {section, "time_scale", measure, "unit of the times of a table", Quantity::time,
         positive()},
    };
}

std::vector<KeyRule> inlet_flow_keys()
{
    return {{"inlet_flow", "mean", Kind::measure,
             "flow rate at the inlet, to which a waveform is added", Quantity::flow_rate,
             closed(-1e12, 1e12)}};
}

std::vector<KeyRule> windkessel_keys()
{
    using enum Kind;
    const Range at_least_0{.min = 0};
    return {
        {"windkessel", "R1", measure, "resistance next to the outlet", Quantity::flow_resistance,
         at_least_0},
        {"windkessel", "R2", measure, "resistance behind the compliance", Quantity::flow_resistance,
         positive()},
        {"windkessel", "C", measure, "compliance between the resistances", Quantity::compliance,
         at_least_0},
        {"windkessel", "pressure_distal", measure, "pressure behind R2", pressure,
         closed(-1e12, 1e12)},
    };
}

std::vector<KeyRule> wall_keys()
{
    using enum Kind;
    const std::vector<std::string_view> laws = {"hooke", "neo-hookean", "mooney-rivlin", "skalak"};
    const Range at_most_one = {.min = 0, .max = 1, .open_max = true};
    return {
        {"vessel",
         "radius",
         measure,
         "undeformed radius R_0",
         length,
         positive(),
         {},
         si,
         "lengths are in units of the radius already: leave it out"},
        {"vessel", "length", measure, "length of the tube", length, closed(0.5, 1e4)},
        {"vessel", "rigid_inlet", measure, "length of the rigid inlet", length, positive()},
        {"vessel", "rigid_outlet", measure, "length of the rigid outlet", length, positive()},
        {"vessel", "rigid", boolean, "whether the whole tube is rigid"},

        {"wall", "law", choice, "elastic law", none, {}, laws},
        {"wall",
         "eps",
         number,
         "deformability mu U_c/G_s",
         none,
         closed(1e-8, 10),
         {},
         plain,
         "give surface_shear_modulus, or youngs_modulus and thickness"},
        {"wall",
         "surface_shear_modulus",
         measure,
         "surface shear modulus G_s",
         Quantity::surface_tension,
         positive(),
         {},
         si,
         "give eps"},
        {"wall",
         "youngs_modulus",
         measure,
         "Young's modulus E",
         pressure,
         positive(),
         {},
         si,
         "give eps"},
        {"wall",
         "thickness",
         measure,
         "wall thickness h",
         length,
         positive_to(0.5),
         {},
         si,
         "give eps"},
        {"wall", "poisson_ratio", number, "surface Poisson ratio nu_s", none, at_most_one},
        {"wall", "psi", number, "Psi of the Mooney-Rivlin law", none, closed(0, 1)},
        {"wall", "skalak_C", number, "area modulus of Skalak's law over G_s", none,
         closed(0, 1000)},
        {"wall",
         "bending",
         number,
         "bending stiffness B = E_b/(R_0^2 G_s)",
         none,
         closed(0, 10),
         {},
         plain,
         "give bending_modulus or bending_thickness"},
        {"wall",
         "bending_modulus",
         measure,
         "bending modulus E_b",
         Quantity::energy,
         {.min = 0},
         {},
         si,
         "give bending"},
        {"wall", "bending_thickness", measure, "thickness that resists bending", length,
         positive_to(0.5)},
        {"wall", "edge_over_spacing", number, "triangle edge over grid spacing", none,
         closed(0.2, 2)},
        {"wall", "contact", number,
         "pressure that keeps opposite walls apart when they touch, in G_s/R_0", none,
         closed(0, 10)},
        {"wall", "surface_viscosity", measure, "viscosity mu_s in the plane of the wall",
         Quantity::surface_viscosity, closed(0, 1e9)},
        {"wall", "support_stiffness", measure, "spring of the tissue around, per area",
         Quantity::stiffness_per_area, closed(0, 1e12)},
        {"wall", "support_damping", measure, "damper of the tissue around, per area",
         Quantity::damping_per_area, closed(0, 1e9)},
        {"wall", "smoothing", number, "alpha of the smoothing velocity, in U_c R_0^3", none,
         closed(0, 1)},
        {"wall", "mesh_filter", number,
         "rate of the filter of the shortest waves, over that of waves of the grid's scale", none,
         closed(0, 4)},
    };
}

/// A section for a factor on a property of the wall along x.
std::vector<KeyRule> along_x_keys(std::string_view section, const Range& change,
                                  const Range& factor)
{
    using enum Kind;
    const Range place = closed(-1e4, 1e4);
    return {
        {section, "shape", choice, "how it varies", none, {}, {"bump", "step"}},
        {section, "position", measure, "x of the middle of the shape", length, place},
        {section, "length", measure, "length of the shape along x", length, positive_to(1e4)},
        {section, "change", number, "factor in the middle of a bump or behind a step, less 1", none,
         change},
        {section, "x", numbers, "increasing positions of a table, in x_scale", none, place},
        {section, "values", numbers, "factors at these positions", none, factor},
        {section, "file", text, "CSV file with a header row and the columns x and value"},
        {section, "x_scale", measure, "unit of the positions of a table", length, positive()},
    };
}

std::vector<KeyRule> perturbation_keys()
{
    using enum Kind;
    return {
        {"perturbation", "amplitude", measure, "amplitude of the radius at t = 0", length,
         closed(0, 0.2)},
        {"perturbation", "mode", integer, "lobes of a single wave around the tube", none,
         closed(1, 64)},
        {"perturbation", "seed", integer, "seed of random waves", none, closed(0, 1e9)},
    };
}

std::vector<KeyRule> numerical_keys()
{
    using enum Kind;
    const Range width = {.min = 2, .max = 1e4, .open_min = true};
    return {
        {"grid", "width_y", measure, "width of the box between the walls", length, width},
        {"grid", "width_z", measure, "period of the box", length, width},
        {"grid", "spacing", measure, "grid spacing", length, positive_to(0.34)},
        {"grid", "cells", counts, "numbers of cells along x, y, z", none, closed(8, 1e6)},
        {"grid", "tube_offset_y", measure, "tube axis from the box centre", length},
        {"grid", "tube_offset_z", measure, "tube axis from the box centre", length},

        {"coupling",
         "scheme",
         choice,
         "coupling of fluid and wall",
         none,
         {},
         {"printed", "reaction", "conserving"}},

        {"time", "step", step, "time step", Quantity::time, positive()},
        {"time", "safety", number, "factor on the automatic step", none, positive_to(2)},
        {"time", "cycle_samples", integer, "samples of a cycle of the drive", none, closed(0, 1e4)},

        {"stop", "end_time", measure, "time to stop at", Quantity::time, positive()},
        {"stop", "steps", integer, "number of steps to stop at", none, closed(1, 1e9)},
        {"stop", "steady_tolerance", number, "relative change that counts as steady", none,
         positive_to(0.1)},
        {"stop", "periodic_tolerance", number, "change from cycle to cycle that counts as none",
         none, positive_to(0.5)},
        {"stop", "wall_clock", seconds, "real time to stop at", Quantity::time, positive()},

        {"output", "sample_every", integer, "steps between rows of series.csv", none,
         closed(1, 1e9)},
        {"output", "wall_every", measure, "time between frames of the wall", Quantity::time,
         positive()},
        {"output", "fluid_every", measure, "time between frames of the fluid", Quantity::time,
         positive()},
        {"output", "wall", boolean, "whether to write the wall"},
        {"output", "fluid", boolean, "whether to write the fluid"},
        {"output",
         "fluid_region",
         choice,
         "cells of fluid frames",
         none,
         {},
         {"box", "tube", "plane_y", "plane_z"}},
        {"output", "fluid_stride", integer, "edge of the blocks of which fluid frames hold means",
         none, closed(1, 100)},
        {"output", "precision", choice, "precision of the fields", none, {}, {"single", "double"}},

        {"checkpoint", "every", seconds, "real time between checkpoints", Quantity::time,
         positive()},
        {"checkpoint", "steps", integer, "steps between checkpoints", none, closed(1, 1e9)},
        {"checkpoint", "keep", integer, "how many of the last checkpoints are kept", none,
         closed(0, 1000)},
    };
}

} // namespace

bool Range::contains(Real value) const
{
    return (open_min ? value > min : value >= min) && (open_max ? value < max : value <= max);
}

std::string Range::describe() const
{
    const bool low = std::isfinite(min), high = std::isfinite(max);
    if (low && high && !open_min && !open_max) return fmt::format("from {:g} to {:g}", min, max);
    std::string text;
    if (low) text = fmt::format("{} {:g}", open_min ? "greater than" : "at least", min);
    if (low && high) text += " and ";
    if (high) text += fmt::format("{} {:g}", open_max ? "less than" : "at most", max);
    return text.empty() ? "finite" : text;
}

std::string KeyRule::name() const
{
    return section.empty() ? std::string(key) : fmt::format("{}.{}", section, key);
}

const std::vector<KeyRule>& case_keys()
{
    static const std::vector<KeyRule> rules = [] {
        std::vector<KeyRule> all = flow_keys();
        for (const auto& part :
             {waveform_keys("inlet_waveform", pressure), waveform_keys("outlet_waveform", pressure),
              waveform_keys("external_waveform", pressure), inlet_flow_keys(),
              waveform_keys("inlet_flow", Quantity::flow_rate), windkessel_keys(), wall_keys(),
              along_x_keys("rest_radius", closed(-0.8, 4), closed(0.2, 5)),
              along_x_keys("stiffness", closed(-0.99, 99), closed(0.01, 100)), perturbation_keys(),
              numerical_keys()})
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }();
    return rules;
}

const KeyRule* find_key(std::string_view section, std::string_view key)
{
    for (const KeyRule& rule : case_keys())
        if (rule.section == section && rule.key == key) return &rule;
    return nullptr;
}

const KeyRule& case_key(std::string_view name)
{
    for (const KeyRule& rule : case_keys())
        if (rule.name() == name) return rule;
    throw std::logic_error(fmt::format("no rule for the key {}", name));
}

std::vector<std::string_view> case_sections()
{
    std::vector<std::string_view> sections;
    for (const KeyRule& rule : case_keys())
        if (!rule.section.empty() && (sections.empty() || sections.back() != rule.section))
            sections.push_back(rule.section);
    return sections;
}

std::vector<std::string_view> keys_of(std::string_view section, std::optional<UnitSystem> system)
{
    std::vector<std::string_view> keys;
    for (const KeyRule& rule : case_keys())
        if (rule.section == section && (!rule.only || !system || rule.only == system))
            keys.push_back(rule.key);
    return keys;
}

} // namespace starling
