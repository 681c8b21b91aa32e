#include "theory/theory_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "theory/poiseuille.hpp"
#include "theory/report_text.hpp"

namespace starling {

namespace {

constexpr Index table_rows = 17;

bool has_inertia(const TubeProblem& problem) { return problem.fluid.reynolds > 1; }

/// Transmural pressure over E'h.
Real P_bar(const TheoryReport& r, Real x)
{
    return (r.tube.P_at(x) - r.problem.drive.pressure_external) /
           (r.modulus * r.problem.material.stiffness(x));
}

/// Eqs. (55)-(57) over Q_0 with the model's pressures, from its largest radius to the outlet clamp.
std::array<Real, 3> law_flow_rates(const TheoryReport& r)
{
    const Real from = r.tube.x_R_max, to = r.problem.clamp_outlet();
    const TubeStretch stretch{P_bar(r, from), P_bar(r, to), to - from, r.modulus,
                              r.problem.fluid.reynolds};
    std::array<Real, 3> Q{};
    for (std::size_t i = 0; i < Q.size(); ++i)
        Q[i] = flow_rate(radius_laws[i], stretch) / poiseuille::baseline_flow_rate;
    return Q;
}

void find_extremes(TheoryReport& r)
{
    const OneDimensionalTube& t = r.tube;
    r.max_strain = t.R_max - 1;
    for (std::size_t i = 0; i < t.x.size(); ++i)
        r.max_strain = std::max(r.max_strain, std::abs(t.R[i] - 1));
    for (std::size_t i = 1; i < t.x.size(); ++i)
        r.max_slope =
            std::max(r.max_slope, std::abs((t.R[i] - t.R[i - 1]) / (t.x[i] - t.x[i - 1])));
}

std::string case_text(const TheoryReport& r)
{
    std::string text = "Case\n";
    add_line(text, "Re", r.problem.fluid.reynolds);
    if (r.problem.tube.rigid)
        text += "  rigid tube\n";
    else {
        fmt::format_to(std::back_inserter(text), "  {:<44}{:>12}\n", "law of the wall",
                       law_name(r.problem.material.law));
        add_line(text, "eps", r.problem.material.eps);
    }
    add_line(text, "Delta P/Delta P_0", r.problem.pressure_ratio());
    return text;
}

std::string model_text(const TheoryReport& r, const Scaling& scaling)
{
    const std::string length = scaling.unit(Quantity::length);
    const std::string pressure = scaling.unit(Quantity::pressure);
    const Real l = scaling.factor(Quantity::length), p = scaling.factor(Quantity::pressure);
    std::string text = fmt::format("One-dimensional model of the clamped tube (steady, {})\n",
                                   has_inertia(r.problem) ? "with inertia" : "low Re");
    add_line(text, "Q/Q_0", r.Q_over_Q0);
    add_line(text, "Q", r.tube.Q * scaling.factor(Quantity::flow_rate),
             scaling.unit(Quantity::flow_rate));
    if (r.problem.tube.rigid) return text;
    add_line(text, "largest radius", r.tube.R_max * l, length);
    add_line(text, "  at x", r.tube.x_R_max * l, length);
    add_line(text, "largest strain |R - R_0|/R_0", r.max_strain);
    add_line(text, "largest slope |dR/dx|", r.max_slope);
    add_line(text, "pressure at the inlet clamp", r.P_clamp_inlet * p, pressure);
    add_line(text, "pressure at the outlet clamp", r.P_clamp_outlet * p, pressure);
    if (!r.problem.material.stiffness.uniform()) return text; // Eqs. (55)-(57) are of one modulus
    text += "Q/Q_0 of the laws, from the largest radius to the outlet clamp\n";
    add_line(text, "law of Laplace, Eq. (55)", r.law_Q_over_Q0[0]);
    add_line(text, "Anand-Christov, Eq. (56)", r.law_Q_over_Q0[1]);
    add_line(text, "second order, Eq. (57)", r.law_Q_over_Q0[2]);
    if (r.problem.material.law != ElasticLaw::hooke)
        text += "  (the laws are Hooke's at equal small-strain modulus)\n";
    return text;
}

std::string profile_text(const TheoryReport& r, const Scaling& scaling)
{
    const Real l = scaling.factor(Quantity::length), p = scaling.factor(Quantity::pressure);
    const bool rigid = r.problem.tube.rigid;
    const Real from = rigid ? 0 : r.problem.clamp_inlet();
    const Real to = rigid ? r.problem.tube.length : r.problem.clamp_outlet();
    std::string text =
        fmt::format("Profile: {}, {}; R of the model, then of the laws at the same pressure\n",
                    heading("x, R", scaling.unit(Quantity::length)),
                    heading("P", scaling.unit(Quantity::pressure)));
    for (const auto* title : {"x", "R", "P", "Laplace", "Anand-Chr.", "2nd order"})
        fmt::format_to(std::back_inserter(text), "{:>14}", title);
    for (Index row = 0; row < table_rows; ++row) {
        const Real x = from + (to - from) * static_cast<Real>(row) / (table_rows - 1);
        text += '\n' + cell(x * l) + cell(r.tube.R_at(x) * l) + cell(r.tube.P_at(x) * p);
        for (const RadiusLaw law : radius_laws) text += cell(r.law_radius(law, x) * l);
    }
    return text + '\n';
}

} // namespace

std::string_view law_name(ElasticLaw law)
{
    switch (law) {
    case ElasticLaw::hooke: return "Hooke";
    case ElasticLaw::neo_hookean: return "neo-Hookean";
    case ElasticLaw::mooney_rivlin: return "Mooney-Rivlin";
    case ElasticLaw::skalak: return "Skalak";
    }
    return "";
}

Real TheoryReport::law_radius(RadiusLaw law, Real x) const
{
    // A hair of tolerance: x of a clamp may have been computed in another way.
    const Real hair = 1e-9 * problem.tube.length;
    if (problem.tube.rigid || x < problem.clamp_inlet() - hair || x > problem.clamp_outlet() + hair)
        return std::numeric_limits<Real>::quiet_NaN();
    return radius(law, P_bar(*this, x));
}

TheoryReport theory_report(const TubeProblem& problem)
{
    TheoryReport r;
    r.problem = problem;
    r.tube = has_inertia(problem) ? solve_marched(problem) : solve_one_dimensional(problem);
    r.Q_over_Q0 = r.tube.Q / poiseuille::baseline_flow_rate;
    if (problem.tube.rigid) return r;
    r.modulus = effective_modulus(problem.material, problem.fluid.reynolds);
    r.law_Q_over_Q0 = law_flow_rates(r);
    r.P_clamp_inlet = r.tube.P_at(problem.clamp_inlet());
    r.P_clamp_outlet = r.tube.P_at(problem.clamp_outlet());
    find_extremes(r);
    return r;
}

std::string to_text(const TheoryReport& report, const Scaling& scaling)
{
    return case_text(report) + model_text(report, scaling) + profile_text(report, scaling);
}

std::string to_csv(const TheoryReport& r, const Scaling& scaling)
{
    const Real l = scaling.factor(Quantity::length), p = scaling.factor(Quantity::pressure);
    const std::string length = scaling.unit(Quantity::length);
    std::string text = heading("x", length) + ',' + heading("R", length) + ',' +
                       heading("P", scaling.unit(Quantity::pressure));
    for (const auto* law : {"R_laplace", "R_anand_christov", "R_second_order"})
        text += ',' + heading(law, length);
    text += '\n';
    for (std::size_t i = 0; i < r.tube.x.size(); ++i) {
        const Real x = r.tube.x[i];
        fmt::format_to(std::back_inserter(text), "{:.10g},{:.10g},{:.10g}", x * l, r.tube.R[i] * l,
                       r.tube.P[i] * p);
        for (const RadiusLaw law : radius_laws)
            fmt::format_to(std::back_inserter(text), ",{:.10g}", r.law_radius(law, x) * l);
        text += '\n';
    }
    return text;
}

} // namespace starling
