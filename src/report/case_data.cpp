#include <fmt/format.h>

#include "report/page_data.hpp"
#include "theory/theory_report.hpp"

namespace starling::report {

namespace {

/// "12.57 R_0" or "0.5 mm" as the case's units have it.
std::string with_unit(Real value, Quantity quantity, const Scaling& s)
{
    return fmt::format("{:.4g} {}", value * s.factor(quantity), s.unit(quantity));
}

std::string law_in_words(const MaterialParameters& m)
{
    const auto name = law_name(m.law);
    return (m.law == ElasticLaw::hooke ? fmt::format("{}'s law", name)
                                       : fmt::format("the {} law", name)) +
           (m.bending > 0 ? " and resists bending" : " and does not resist bending");
}

std::string wall_in_words(const Case& c)
{
    const auto length = [&](Real l) { return with_unit(l, Quantity::length, c.scaling); };
    if (c.tube.rigid) return fmt::format("A rigid tube of length {}", length(c.tube.length));
    return fmt::format("A tube of length {}, rigid over {} at the inlet and {} at the outlet. "
                       "Its wall follows {}",
                       length(c.tube.length), length(c.tube.rigid_inlet),
                       length(c.tube.rigid_outlet), law_in_words(c.material));
}

std::string waveform_in_words(const char* place, const Waveform& w, const Scaling& scaling)
{
    if (w.none()) return "";
    const std::string period =
        w.period > 0 ? ", again after " + with_unit(w.period, Quantity::time, scaling) : "";
    return fmt::format(". To the pressure {} is added a waveform from {} to {}{}", place,
                       with_unit(w.lowest(), Quantity::pressure, scaling),
                       with_unit(w.highest(), Quantity::pressure, scaling), period);
}

std::string drive_in_words(const Case& c)
{
    const auto pressure = [&](Real p) { return with_unit(p, Quantity::pressure, c.scaling); };
    const std::string steady =
        fmt::format("The fluid is driven by {} at the inlet against {} at the outlet, {} outside "
                    "the tube; this is {:.4g} times the pressure drop that drives the centreline "
                    "velocity U_c through the undeformed tube",
                    pressure(c.drive.pressure_inlet), pressure(c.drive.pressure_outlet),
                    pressure(c.drive.pressure_external), c.pressure_ratio());
    return steady + waveform_in_words("at the inlet", c.drive.inlet_waveform, c.scaling) +
           waveform_in_words("at the outlet", c.drive.outlet_waveform, c.scaling) +
           waveform_in_words("outside", c.drive.external_waveform, c.scaling);
}

std::string perturbation_in_words(const Case& c)
{
    const PerturbationParameters& p = c.perturbation;
    if (c.tube.rigid || p.amplitude == 0) return "";
    const std::string shape =
        p.mode ? fmt::format("one wave of {} lobes", *p.mode) : std::string("random waves");
    return fmt::format(
        " At the start the wall deviates from the circular tube by {} of amplitude {}.", shape,
        with_unit(p.amplitude, Quantity::length, c.scaling));
}

/// Rows of numbers in the units of the case.
class Rows {
public:
    explicit Rows(const Scaling& scaling) : scaling_(scaling) {}
    void add(const char* label, Real value, Quantity quantity = Quantity::none)
    {
        rows_.push_back({{"label", label},
                         {"value", value * scaling_.factor(quantity)},
                         {"unit", scaling_.unit(quantity)}});
    }
    const Json& json() const { return rows_; }

private:
    const Scaling& scaling_;
    Json rows_ = Json::array();
};

void add_scales(Rows& rows, const Scaling& s)
{
    if (!s.si) return;
    rows.add("Radius R\u2080", 1, Quantity::length);
    rows.add("Velocity scale U_c", 1, Quantity::velocity);
    rows.add("Density of the fluid", 1, Quantity::density);
}

void add_wall(Rows& rows, const Case& c)
{
    if (c.tube.rigid) return;
    rows.add("Deformability eps = \u03bc U_c/G_s", c.material.eps);
    if (c.material.law == ElasticLaw::hooke) rows.add("Poisson ratio", c.material.poisson_ratio);
    if (c.material.bending > 0)
        rows.add("Bending stiffness B = E_b/(R\u2080\u00b2 G_s)", c.material.bending);
}

} // namespace

Json case_data(const Case& c)
{
    Rows rows(c.scaling);
    rows.add("Reynolds number Re", c.fluid.reynolds);
    add_wall(rows, c);
    rows.add("Pressure drop \u0394P/\u0394P\u2080", c.pressure_ratio());
    rows.add("Inlet pressure", c.drive.pressure_inlet, Quantity::pressure);
    rows.add("Outlet pressure", c.drive.pressure_outlet, Quantity::pressure);
    rows.add("External pressure", c.drive.pressure_external, Quantity::pressure);
    rows.add("Length", c.tube.length, Quantity::length);
    add_scales(rows, c.scaling);
    if (!c.grid.cells) rows.add("Grid spacing", c.grid.spacing, Quantity::length);
    return {{"words", wall_in_words(c) + ". " + drive_in_words(c) + "." + perturbation_in_words(c)},
            {"rows", rows.json()}};
}

} // namespace starling::report
