#include "theory/buckling_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

#include "theory/elastic_ring.hpp"
#include "theory/report_text.hpp"

namespace starling {

namespace {

constexpr int least_lobes = 2;
constexpr std::array ring_lobes{2, 3, 4};

/// Pressures at the clamps less the external one, falling linearly from inlet to outlet.
TransmuralPressure clamp_pressures(const TubeProblem& problem)
{
    const Real gradient = problem.pressure_drop() / problem.tube.length;
    const Real at_inlet = problem.drive.pressure_inlet - problem.drive.pressure_external;
    return {at_inlet - gradient * problem.clamp_inlet(),
            at_inlet - gradient * problem.clamp_outlet()};
}

/// The n up to which loads are looked at: past the smallest of the wall at rest.
int most_lobes(const BucklingTube& tube)
{
    int n = least_lobes;
    while (n < 100 &&
           buckling_pressure_undeformed(tube, n + 1) < buckling_pressure_undeformed(tube, n))
        ++n;
    return std::max(8, n + 4);
}

BucklingLoad load(const BucklingTube& tube, const TransmuralPressure& pressure, int n)
{
    return {.n = n,
            .ring = ring_buckling_pressure(n, tube.E_b),
            .at_rest = buckling_pressure_undeformed(tube, n),
            .tube = buckling_pressure(tube, n),
            .factor = buckling_factor(tube, n, pressure)};
}

std::optional<BucklingLoad> smallest(const std::vector<BucklingLoad>& loads,
                                     Real BucklingLoad::*quantity)
{
    std::optional<BucklingLoad> best;
    for (const BucklingLoad& l : loads)
        if (!std::isnan(l.*quantity) && (!best || l.*quantity < (*best).*quantity)) best = l;
    return best;
}

std::string prediction_text(const BucklingReport& r)
{
    std::string text;
    if (r.under_uniform_pressure)
        text += fmt::format("  under uniform external pressure it buckles into n = {}\n",
                            r.under_uniform_pressure->n);
    if (!r.under_own_pressure) return text + "  the case's pressures do not compress it\n";
    return text + fmt::format("  {} times the case's pressures buckle it into n = {}: it {}\n",
                              fmt::format("{:.4g}", r.under_own_pressure->factor),
                              r.under_own_pressure->n, r.buckles() ? "collapses" : "stays round");
}

/// Pressures of the ring in E_b at `areas`, the first of which is the circle; NaN past contact.
std::vector<Real> ring_pressures(int lobes, const std::vector<Real>& areas, Real area_at_contact)
{
    const auto end =
        std::find_if(areas.begin(), areas.end(), [&](Real area) { return area < area_at_contact; });
    std::vector<Real> pressures;
    for (const ElasticRing& ring : rings_at_areas(lobes, {areas.begin(), end}))
        pressures.push_back(ring.pressure);
    pressures.resize(areas.size(), std::numeric_limits<Real>::quiet_NaN());
    return pressures;
}

std::string tube_law_text(const BucklingReport& r, const Scaling& scaling)
{
    const Real p = r.E_b * scaling.factor(Quantity::pressure);
    const std::vector<Real> areas{1, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2};
    std::vector<std::string> rows;
    for (const Real area : areas) rows.push_back(cell(area));
    std::string titles = fmt::format("{:>14}", "A/A_0"), contact = fmt::format("{:>14}", "contact");
    std::string at = fmt::format("{:>14}", "at A/A_0");
    for (const int n : ring_lobes) {
        const ElasticRing last = ring_at_contact(n);
        const std::vector<Real> pressures = ring_pressures(n, areas, last.area_ratio);
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i] += cell(p * pressures[i]);
        titles += fmt::format("{:>14}", fmt::format("n = {}", n));
        contact += cell(p * last.pressure);
        at += cell(last.area_ratio);
    }
    return fmt::format(
        "Tube law of a long tube (inextensible ring, until opposite walls meet): {}\n"
        "{}\n{}\n{}\n{}\n",
        heading("p", scaling.unit(Quantity::pressure)), titles, fmt::join(rows, "\n"), contact, at);
}

} // namespace

std::optional<BucklingReport> buckling_report(const TubeProblem& problem)
{
    if (problem.tube.rigid || !(problem.material.bending > 0)) return std::nullopt;
    if (!problem.tube.rest_radius.uniform() || !problem.material.stiffness.uniform())
        return std::nullopt;
    if (problem.material.support.stiffness > 0) return std::nullopt; // it would raise the loads
    const Real E_b = bending_modulus(problem.material, problem.fluid.reynolds);
    const BucklingTube tube{make_material(problem.material, problem.fluid.reynolds), E_b,
                            problem.clamp_outlet() - problem.clamp_inlet()};
    BucklingReport r;
    r.E_b = E_b;
    r.length = tube.length;
    r.pressure = clamp_pressures(problem);
    for (int n = least_lobes; n <= most_lobes(tube); ++n)
        r.loads.push_back(load(tube, r.pressure, n));
    r.under_uniform_pressure = smallest(r.loads, &BucklingLoad::tube);
    r.under_own_pressure = smallest(r.loads, &BucklingLoad::factor);
    return r;
}

std::string to_text(const BucklingReport& r, const Scaling& scaling)
{
    const Real p = scaling.factor(Quantity::pressure);
    const std::string pressure = scaling.unit(Quantity::pressure);
    std::string text = "Buckling (linear theory, pinned ends; p: external - internal pressure)\n";
    add_line(text, "transmural pressure at the inlet clamp", r.pressure.inlet * p, pressure);
    add_line(text, "transmural pressure at the outlet clamp", r.pressure.outlet * p, pressure);
    text += prediction_text(r);
    fmt::format_to(std::back_inserter(text),
                   "Loads for n lobes: {} of the ring, of the tube at rest and of the compressed "
                   "tube; factor of the\ncase's pressures\n",
                   heading("p", pressure));
    for (const auto* title : {"n", "ring", "tube at rest", "tube", "factor"})
        fmt::format_to(std::back_inserter(text), "{:>14}", title);
    for (const BucklingLoad& l : r.loads)
        text += '\n' + cell(l.n) + cell(l.ring * p) + cell(l.at_rest * p) + cell(l.tube * p) +
                cell(l.factor);
    return text + '\n' + tube_law_text(r, scaling);
}

std::string to_csv(const BucklingReport& r, const Scaling& scaling)
{
    const Real p = scaling.factor(Quantity::pressure);
    const std::string pressure = scaling.unit(Quantity::pressure);
    std::string text = fmt::format("{},{},{},{},{}\n", heading("n", "1"),
                                   heading("p_ring", pressure), heading("p_at_rest", pressure),
                                   heading("p_tube", pressure), heading("load_factor", "1"));
    for (const BucklingLoad& l : r.loads)
        fmt::format_to(std::back_inserter(text), "{},{:.10g},{:.10g},{:.10g},{:.10g}\n", l.n,
                       l.ring * p, l.at_rest * p, l.tube * p, l.factor);
    return text;
}

std::string tube_law_csv(const BucklingReport& r, const Scaling& scaling)
{
    const Real p = r.E_b * scaling.factor(Quantity::pressure), l = scaling.factor(Quantity::length);
    const std::string length = scaling.unit(Quantity::length);
    std::string text = fmt::format("{},{},{},{},{},{}\n", heading("n", "1"),
                                   heading("p", scaling.unit(Quantity::pressure)),
                                   heading("area_ratio", "1"), heading("tip_distance", length),
                                   heading("waist_distance", length), heading("gap", length));
    for (const int n : ring_lobes)
        for (const ElasticRing& ring : tube_law(n))
            fmt::format_to(std::back_inserter(text), "{},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g}\n",
                           n, ring.pressure * p, ring.area_ratio, ring.tip_distance * l,
                           ring.waist_distance * l, ring.gap * l);
    return text;
}

} // namespace starling
