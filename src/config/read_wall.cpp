#include "config/read_wall.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace starling {

namespace {

void read_tube(CaseValues& values, TubeParameters& tube)
{
    values.require("vessel.length");
    values.fill("vessel.length", tube.length);
    values.fill("vessel.rigid", tube.rigid);
    if (!tube.rigid && values.sound({"vessel.rigid"})) {
        values.require("vessel.rigid_inlet");
        values.require("vessel.rigid_outlet");
    }
    values.fill("vessel.rigid_inlet", tube.rigid_inlet);
    values.fill("vessel.rigid_outlet", tube.rigid_outlet);
    values.fill("wall.edge_over_spacing", tube.edge_over_spacing);
    values.fill("wall.mesh_filter", tube.mesh_filter);
    values.fill("wall.smoothing", tube.smoothing);
}

void refuse_unused(CaseValues& values, std::string_view name, std::string_view law)
{
    if (values.given(name))
        values.problem(name, fmt::format("is read with law = \"{}\" only; leave it out", law));
}

/// nu_s and C of Skalak's law, each from the other: nu_s = C/(1 + C) (sec. 2.2).
void read_skalak(CaseValues& values, MaterialParameters& m)
{
    const std::string_view C = "wall.skalak_C", nu = "wall.poisson_ratio";
    values.fill(C, m.skalak_C);
    values.fill(nu, m.poisson_ratio);
    if (!values.sound({C, nu})) return;
    const Real nu_of_C = m.skalak_C / (1 + m.skalak_C);
    if (!values.given(C)) m.skalak_C = m.poisson_ratio / (1 - m.poisson_ratio);
    if (!values.given(nu)) m.poisson_ratio = nu_of_C;
    if (!case_key(C).range.contains(m.skalak_C))
        values.problem(nu, fmt::format("gives C = {:g}; C must be {}", m.skalak_C,
                                       case_key(C).range.describe()));
    else if (values.given(C) && values.given(nu) && std::abs(m.poisson_ratio - nu_of_C) > 1e-6)
        values.problem(C, fmt::format("contradicts poisson_ratio: C = {:g} means a Poisson ratio "
                                      "of C/(1 + C) = {:g}; give one of the two",
                                      m.skalak_C, nu_of_C));
}

void read_law(CaseValues& values, MaterialParameters& m)
{
    const std::string law = values.text("wall.law", "hooke");
    if (law == "hooke") m.law = ElasticLaw::hooke;
    if (law == "neo-hookean") m.law = ElasticLaw::neo_hookean;
    if (law == "mooney-rivlin") m.law = ElasticLaw::mooney_rivlin;
    if (law == "skalak") m.law = ElasticLaw::skalak;
}

void read_parameters_of_law(CaseValues& values, MaterialParameters& m)
{
    if (m.law == ElasticLaw::mooney_rivlin)
        values.fill("wall.psi", m.psi);
    else
        refuse_unused(values, "wall.psi", "mooney-rivlin");
    if (m.law == ElasticLaw::skalak)
        read_skalak(values, m);
    else
        refuse_unused(values, "wall.skalak_C", "skalak");
    if (m.law == ElasticLaw::hooke) values.fill("wall.poisson_ratio", m.poisson_ratio);
    const bool incompressible =
        m.law == ElasticLaw::neo_hookean || m.law == ElasticLaw::mooney_rivlin;
    if (incompressible && values.has("wall.poisson_ratio") &&
        values.number("wall.poisson_ratio") != 0.5)
        values.problem("wall.poisson_ratio",
                       fmt::format("is {:g}, but law = \"{}\" keeps the wall's volume and so has "
                                   "0.5 always: remove this key",
                                   values.number("wall.poisson_ratio"),
                                   values.text("wall.law", "")));
}

/// G_s in N/m, given or E h/(2 (1 + nu_s)) (Eq. 9).
std::optional<long double> surface_shear_modulus(CaseValues& values, bool required, Real nu_s)
{
    const std::string_view direct = "wall.surface_shear_modulus";
    const bool young = values.given("wall.youngs_modulus") || values.given("wall.thickness");
    if (values.given(direct)) {
        if (young)
            values.problem(direct, "give it, or youngs_modulus and thickness, not both (the "
                                   "case.toml of a run holds it in their place)");
        return values.has(direct) ? std::optional(values.si(direct)) : std::nullopt;
    }
    if (!young) {
        if (required) values.missing(direct, "or give youngs_modulus and thickness");
        return std::nullopt;
    }
    const bool modulus = values.require("wall.youngs_modulus");
    const bool thickness = values.require("wall.thickness");
    if (!modulus || !thickness || !values.sound({"wall.poisson_ratio"})) return std::nullopt;
    return values.si("wall.youngs_modulus") * values.si("wall.thickness") /
           (2 * (1 + static_cast<long double>(nu_s)));
}

/// eps = mu U_c/G_s, given or from SI values.
void read_eps(CaseValues& values, const Case& c, bool required, MaterialParameters& m)
{
    if (values.system() == UnitSystem::dimensionless) {
        if (required) values.require("wall.eps");
        return values.fill("wall.eps", m.eps);
    }
    const auto G_s = surface_shear_modulus(values, required, m.poisson_ratio);
    const auto scale = static_cast<long double>(c.scaling.factor(Quantity::surface_tension));
    if (!G_s || !std::isfinite(scale) || !values.sound({"fluid.viscosity"})) return;
    const auto eps = static_cast<Real>(scale / (static_cast<long double>(c.fluid.reynolds) * *G_s));
    const bool young = values.given("wall.youngs_modulus");
    values.accept(young ? "wall.youngs_modulus" : "wall.surface_shear_modulus", "wall.eps", eps,
                  m.eps);
}

/// B = E_b/(R_0^2 G_s): given, from E_b in SI, or (h/R_0)^2/(6 (1 - nu_s)) from a thickness by
/// E_b = E h^3/(12 (1 - nu_s^2)) and Eq. (9).
void read_bending(CaseValues& values, const Case& c, MaterialParameters& m)
{
    const std::string_view thickness = "wall.bending_thickness", modulus = "wall.bending_modulus";
    const std::string_view direct =
        values.system() == UnitSystem::si ? modulus : std::string_view("wall.bending");
    if (values.given(thickness) && values.given(direct))
        return values.problem(thickness, fmt::format("give it or {}, not both", direct.substr(5)));
    values.fill("wall.bending", m.bending);
    if (values.has(modulus) && values.sound({"wall.eps", "fluid.viscosity"})) {
        const auto scale = static_cast<long double>(c.scaling.factor(Quantity::energy));
        const long double G_s =
            1 / (static_cast<long double>(c.fluid.reynolds) * static_cast<long double>(m.eps));
        if (std::isfinite(scale))
            values.accept(modulus, "wall.bending",
                          static_cast<Real>(values.si(modulus) / scale / G_s), m.bending);
    }
    if (!values.has(thickness) || !values.sound({"wall.poisson_ratio"})) return;
    const Real h = values.number(thickness);
    if (std::isfinite(h))
        values.accept(thickness, "wall.bending", h * h / (6 * (1 - m.poisson_ratio)), m.bending);
}

void read_perturbation(CaseValues& values, PerturbationParameters& p)
{
    values.fill("perturbation.amplitude", p.amplitude);
    values.fill("perturbation.mode", p.mode);
    values.fill("perturbation.seed", p.seed);
    if (values.given("perturbation.mode") && values.given("perturbation.seed"))
        values.problem("perturbation.seed", "is for random waves; give it or mode, not both");
    for (std::string_view name : {"perturbation.mode", "perturbation.seed"})
        if (values.given(name) && !values.given("perturbation.amplitude"))
            values.problem(name, "does nothing without an amplitude");
}

} // namespace

void read_wall(CaseValues& values, Case& c)
{
    read_tube(values, c.tube);
    const bool elastic = !c.tube.rigid && values.sound({"vessel.rigid"});
    if (elastic) values.require("wall.law");
    if (values.sound({"wall.law"})) {
        read_law(values, c.material);
        read_parameters_of_law(values, c.material);
    }
    read_eps(values, c, elastic, c.material);
    read_bending(values, c, c.material);
    values.fill("wall.contact", c.material.contact);
    values.fill("wall.surface_viscosity", c.material.viscosity);
    values.fill("wall.support_stiffness", c.material.support.stiffness);
    values.fill("wall.support_damping", c.material.support.damping);
    read_perturbation(values, c.perturbation);
}

} // namespace starling
