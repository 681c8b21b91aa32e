#include "config/write_case.hpp"

#include <array>
#include <charconv>

#include <fmt/format.h>

#include "config/quantities.hpp"

namespace starling {

namespace {

/// The shortest decimal that reads back to the same bits, as a TOML float.
std::string float_text(Real value)
{
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    std::string text(buffer.data(), end);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string string_text(const std::string& text)
{
    std::string out = "\"";
    for (char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            out += {'\\', c};
        else if (code < 0x20 || code == 0x7F)
            out += fmt::format("\\u{:04X}", code);
        else
            out += c;
    }
    return out + "\"";
}

class CaseWriter {
public:
    explicit CaseWriter(const Scaling& scaling) : scaling_(scaling) {}

    void section(std::string_view name) { out_ += fmt::format("\n[{}]\n", name); }
    void raw(std::string_view key, std::string_view text)
    {
        out_ += fmt::format("{} = {}\n", key, text);
    }
    void text(std::string_view key, const std::string& value) { raw(key, string_text(value)); }
    void number(std::string_view key, Real value) { raw(key, float_text(value)); }
    void numbers(std::string_view key, const std::vector<Real>& values)
    {
        std::string text;
        for (Real x : values) text += (text.empty() ? "" : ", ") + float_text(x);
        raw(key, "[" + text + "]");
    }
    void boolean(std::string_view key, bool value) { raw(key, value ? "true" : "false"); }
    void integer(std::string_view key, Index value) { raw(key, fmt::format("{}", value)); }
    void comment(const std::string& text) { out_ += fmt::format("# {}\n", text); }

    /// A dimensionless value in the units of the file.
    void measure(std::string_view key, Real value, Quantity q)
    {
        if (!scaling_.si) return number(key, value);
        const auto factor = static_cast<long double>(scaling_.factor(q));
        derived(key, static_cast<long double>(value) * factor, q,
                [=](long double si) { return static_cast<Real>(si / factor) == value; });
    }

    /// A value in SI that `same` recognises when it is read back.
    void derived(std::string_view key, long double si, Quantity q,
                 const std::function<bool(long double)>& same)
    {
        raw(key, "\"" + format_measure(si, q, same) + "\"");
    }

    void scale(std::string_view key, Real value, Quantity q)
    {
        derived(key, static_cast<long double>(value), q,
                [=](long double si) { return static_cast<Real>(si) == value; });
    }

    const std::string& result() const { return out_; }

private:
    const Scaling& scaling_;
    std::string out_;
};

void write_fluid(CaseWriter& w, const Case& c)
{
    w.section("fluid");
    if (c.scaling.si) {
        w.comment(fmt::format("Re = {:.6g}", c.fluid.reynolds));
        w.scale("density", c.scaling.density, Quantity::density);
        const auto scale = static_cast<long double>(c.scaling.factor(Quantity::viscosity));
        const Real reynolds = c.fluid.reynolds;
        w.derived("viscosity", scale / static_cast<long double>(reynolds), Quantity::viscosity,
                  [=](long double mu) { return static_cast<Real>(scale / mu) == reynolds; });
    } else {
        w.number("reynolds", c.fluid.reynolds);
    }
    w.number("theta", c.fluid.theta);
}

void write_waveform_keys(CaseWriter& w, const Waveform& f, Quantity quantity)
{
    w.measure("amplitude", f.amplitude, quantity);
    if (f.period > 0) w.measure("period", f.period, Quantity::time);
    if (!f.cosine.empty()) w.numbers("cosine", f.cosine);
    if (!f.sine.empty()) w.numbers("sine", f.sine);
    if (f.times.empty()) return;
    w.measure("time_scale", 1, Quantity::time);
    w.numbers("times", f.times);
    w.numbers("values", f.values);
}

void write_waveform(CaseWriter& w, std::string_view section, const Waveform& f)
{
    if (f.none()) return;
    w.section(section);
    write_waveform_keys(w, f, Quantity::pressure);
}

void write_inlet_flow(CaseWriter& w, const InletFlow& flow)
{
    if (!flow.given) return;
    w.section("inlet_flow");
    w.measure("mean", flow.mean, Quantity::flow_rate);
    if (!flow.waveform.none()) write_waveform_keys(w, flow.waveform, Quantity::flow_rate);
}

void write_windkessel(CaseWriter& w, const Windkessel& k)
{
    if (k.none()) return;
    w.section("windkessel");
    w.measure("R1", k.R1, Quantity::flow_resistance);
    w.measure("R2", k.R2, Quantity::flow_resistance);
    w.measure("C", k.C, Quantity::compliance);
    w.measure("pressure_distal", k.distal, Quantity::pressure);
}

void write_drive(CaseWriter& w, const Case& c)
{
    const DriveParameters& d = c.drive;
    w.section("drive");
    if (d.gives_pressures())
        w.comment(fmt::format("Delta P/Delta P_0 = {:.6g}", c.pressure_ratio()));
    if (!d.inlet_flow.given) w.measure("pressure_inlet", d.pressure_inlet, Quantity::pressure);
    w.measure("pressure_outlet", d.pressure_outlet, Quantity::pressure);
    w.measure("pressure_external", d.pressure_external, Quantity::pressure);
    if (d.gives_pressures()) w.text("end_pressure", d.total_pressure ? "total" : "static");
    if (d.ramp > 0) w.measure("ramp", d.ramp, Quantity::time);
    if (c.scaling.si) w.scale("velocity_scale", c.scaling.velocity, Quantity::velocity);
    write_waveform(w, "inlet_waveform", d.inlet_waveform);
    write_waveform(w, "outlet_waveform", d.outlet_waveform);
    write_waveform(w, "external_waveform", d.external_waveform);
    write_inlet_flow(w, d.inlet_flow);
    write_windkessel(w, d.windkessel);
}

void write_vessel(CaseWriter& w, const Case& c)
{
    w.section("vessel");
    if (c.scaling.si) w.scale("radius", c.scaling.length, Quantity::length);
    w.measure("length", c.tube.length, Quantity::length);
    w.measure("rigid_inlet", c.tube.rigid_inlet, Quantity::length);
    w.measure("rigid_outlet", c.tube.rigid_outlet, Quantity::length);
    w.boolean("rigid", c.tube.rigid);
}

std::string law_name(ElasticLaw law)
{
    switch (law) {
    case ElasticLaw::hooke: return "hooke";
    case ElasticLaw::neo_hookean: return "neo-hookean";
    case ElasticLaw::mooney_rivlin: return "mooney-rivlin";
    case ElasticLaw::skalak: return "skalak";
    }
    return "";
}

void write_elasticity(CaseWriter& w, const Case& c)
{
    const Real eps = c.material.eps;
    if (!c.scaling.si) return w.number("eps", eps);
    w.comment(fmt::format("eps = {:.6g}", eps));
    const auto scale = static_cast<long double>(c.scaling.factor(Quantity::surface_tension));
    const auto reynolds = static_cast<long double>(c.fluid.reynolds);
    w.derived("surface_shear_modulus", scale / (reynolds * static_cast<long double>(eps)),
              Quantity::surface_tension,
              [=](long double G_s) { return static_cast<Real>(scale / (reynolds * G_s)) == eps; });
}

void write_bending(CaseWriter& w, const Case& c)
{
    const Real B = c.material.bending;
    if (!c.scaling.si) return w.number("bending", B);
    w.comment(fmt::format("B = {:.6g}", B));
    const auto scale = static_cast<long double>(c.scaling.factor(Quantity::energy));
    const long double G_s =
        1 / (static_cast<long double>(c.fluid.reynolds) * static_cast<long double>(c.material.eps));
    w.derived("bending_modulus", static_cast<long double>(B) * G_s * scale, Quantity::energy,
              [=](long double E_b) { return static_cast<Real>(E_b / scale / G_s) == B; });
}

void write_along_x(CaseWriter& w, std::string_view section, const AlongX& a)
{
    if (a.uniform()) return;
    w.section(section);
    if (a.shape == AlongX::Shape::table) {
        w.numbers("x", a.x);
        w.numbers("values", a.values);
        return;
    }
    w.text("shape", a.shape == AlongX::Shape::bump ? "bump" : "step");
    w.measure("position", a.position, Quantity::length);
    w.measure("length", a.length, Quantity::length);
    w.number("change", a.change);
}

void write_perturbation(CaseWriter& w, const PerturbationParameters& p)
{
    if (p.amplitude == 0) return;
    w.section("perturbation");
    w.measure("amplitude", p.amplitude, Quantity::length);
    if (p.mode)
        w.integer("mode", *p.mode);
    else
        w.integer("seed", p.seed);
}

void write_wall(CaseWriter& w, const Case& c)
{
    const MaterialParameters& m = c.material;
    w.section("wall");
    w.text("law", law_name(m.law));
    write_elasticity(w, c);
    if (m.law == ElasticLaw::hooke || m.law == ElasticLaw::skalak)
        w.number("poisson_ratio", m.poisson_ratio);
    if (m.law == ElasticLaw::mooney_rivlin) w.number("psi", m.psi);
    if (m.law == ElasticLaw::skalak) w.number("skalak_C", m.skalak_C);
    write_bending(w, c);
    w.number("edge_over_spacing", c.tube.edge_over_spacing);
    w.number("contact", c.material.contact);
    w.measure("surface_viscosity", m.viscosity, Quantity::surface_viscosity);
    w.measure("support_stiffness", m.support.stiffness, Quantity::stiffness_per_area);
    w.measure("support_damping", m.support.damping, Quantity::damping_per_area);
    w.number("smoothing", c.tube.smoothing);
    w.number("mesh_filter", c.tube.mesh_filter);
}

void write_grid(CaseWriter& w, const GridParameters& g)
{
    w.section("grid");
    w.measure("width_y", g.width_y, Quantity::length);
    w.measure("width_z", g.width_z, Quantity::length);
    if (g.cells)
        w.raw("cells", fmt::format("[{}, {}, {}]", (*g.cells)[0], (*g.cells)[1], (*g.cells)[2]));
    else
        w.measure("spacing", g.spacing, Quantity::length);
    w.measure("tube_offset_y", g.tube_offset_y, Quantity::length);
    w.measure("tube_offset_z", g.tube_offset_z, Quantity::length);
}

std::string scheme_name(CouplingScheme scheme)
{
    switch (scheme) {
    case CouplingScheme::printed: return "printed";
    case CouplingScheme::reaction: return "reaction";
    case CouplingScheme::conserving: return "conserving";
    }
    return "";
}

void write_time(CaseWriter& w, const TimeParameters& time, const StopParameters& stop)
{
    w.section("time");
    if (time.step)
        w.measure("step", *time.step, Quantity::time);
    else
        w.text("step", "auto");
    w.number("safety", time.safety);
    w.integer("cycle_samples", time.cycle_samples);

    w.section("stop");
    if (stop.end_time) w.measure("end_time", *stop.end_time, Quantity::time);
    if (stop.steps) w.integer("steps", *stop.steps);
    if (stop.steady_tolerance) w.number("steady_tolerance", *stop.steady_tolerance);
    if (stop.periodic_tolerance) w.number("periodic_tolerance", *stop.periodic_tolerance);
    if (stop.wall_clock) w.number("wall_clock", *stop.wall_clock);
}

std::string region_name(FluidRegion region)
{
    switch (region) {
    case FluidRegion::tube: return "tube";
    case FluidRegion::plane_y: return "plane_y";
    case FluidRegion::plane_z: return "plane_z";
    default: return "box";
    }
}

void write_output(CaseWriter& w, const OutputParameters& output)
{
    w.section("output");
    w.integer("sample_every", output.sample_every);
    if (output.wall_every) w.measure("wall_every", *output.wall_every, Quantity::time);
    if (output.fluid_every) w.measure("fluid_every", *output.fluid_every, Quantity::time);
    w.boolean("wall", output.wall);
    w.boolean("fluid", output.fluid);
    w.text("fluid_region", region_name(output.fluid_part.region));
    w.integer("fluid_stride", output.fluid_part.stride);
    w.text("precision", output.double_precision ? "double" : "single");
}

void write_checkpoint(CaseWriter& w, const CheckpointParameters& checkpoint)
{
    w.section("checkpoint");
    w.number("every", checkpoint.every);
    if (checkpoint.steps) w.integer("steps", *checkpoint.steps);
    w.integer("keep", checkpoint.keep);
}

} // namespace

std::string write_case(const Case& c)
{
    CaseWriter w(c.scaling);
    if (!c.scaling.si)
        w.comment("Lengths in R_0, velocities in U_c, times in R_0/U_c, pressures in rho U_c^2.");
    w.text("title", c.title);
    w.text("units", c.scaling.si ? "si" : "dimensionless");
    write_fluid(w, c);
    write_drive(w, c);
    write_vessel(w, c);
    write_wall(w, c);
    write_along_x(w, "rest_radius", c.tube.rest_radius);
    write_along_x(w, "stiffness", c.material.stiffness);
    write_perturbation(w, c.perturbation);
    write_grid(w, c.grid);
    w.section("coupling");
    w.text("scheme", scheme_name(c.coupling.scheme));
    write_time(w, c.time, c.stop);
    write_output(w, c.output);
    write_checkpoint(w, c.checkpoint);
    return w.result();
}

namespace {

constexpr std::string_view last_line = "# End of the case";
constexpr std::string_view promise = ", up to the line \"# End of the case\"";

} // namespace

std::string write_case_with_end(const std::string& head, const Case& c)
{
    return head + std::string(promise) + '\n' + write_case(c) + std::string(last_line) + '\n';
}

bool lacks_end(std::string_view text)
{
    if (!text.substr(0, text.find('\n')).ends_with(promise)) return false;
    while (text.ends_with('\n')) text.remove_suffix(1); // as an editor may add them
    return !text.ends_with(std::string("\n") + std::string(last_line));
}

} // namespace starling
