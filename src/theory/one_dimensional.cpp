#include "theory/one_dimensional.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "theory/boundary_layer.hpp"
#include "theory/clamped_membrane.hpp"
#include "theory/poiseuille.hpp"

namespace starling {

namespace {

Real interpolate(const std::vector<Real>& x, const std::vector<Real>& values, Real position)
{
    const auto right = std::upper_bound(x.begin(), x.end(), position);
    if (right == x.begin()) return values.front();
    if (right == x.end()) return values.back();
    const auto j = static_cast<std::size_t>(right - x.begin());
    const Real s = (position - x[j - 1]) / (x[j] - x[j - 1]);
    return (1 - s) * values[j - 1] + s * values[j];
}

/// Nodes from a to b, about 30 times denser at both ends than on average: boundary layers there.
std::vector<Real> clustered_nodes(Real a, Real b, Index intervals)
{
    constexpr Real beta = 3;
    std::vector<Real> x(static_cast<std::size_t>(intervals + 1));
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Real s = 2 * static_cast<Real>(i) / static_cast<Real>(intervals) - 1;
        x[i] = (a + b) / 2 + (b - a) / 2 * std::tanh(beta * s) / std::tanh(beta);
    }
    x.front() = a;
    x.back() = b;
    return x;
}

/// The membrane of `problem` with pressures in units of G_s, and of inertia the given share.
ClampedMembrane membrane(const TubeProblem& problem, Index intervals, Real share = 1)
{
    const Real Re = problem.fluid.reynolds, G_s = shear_modulus(problem.material, Re);
    return {clustered_nodes(problem.clamp_inlet(), problem.clamp_outlet(), intervals),
            problem.tube.rigid_inlet,
            problem.tube.rigid_outlet,
            make_material(problem.material, 1 / problem.material.eps), // G_s = 1
            share * Re * Re / 64 * G_s,
            problem.material.support.stiffness / G_s,
            problem.material.stiffness};
}

/// The load of `problem` times `fraction`, in units of G_s.
MembraneLoad membrane_load(const TubeProblem& problem, Real fraction)
{
    const Real k = fraction / shear_modulus(problem.material, problem.fluid.reynolds);
    const DriveParameters& d = problem.drive;
    return {k * d.pressure_inlet, k * d.pressure_outlet, k * d.pressure_external};
}

/// b + t (b - a).
std::vector<Real> extrapolate(const std::vector<Real>& a, const std::vector<Real>& b, Real t)
{
    std::vector<Real> c(b);
    for (std::size_t i = 0; i < c.size(); ++i) c[i] += t * (b[i] - a[i]);
    return c;
}

MembraneState extrapolate(const MembraneState& a, const MembraneState& b, Real t)
{
    return {extrapolate(a.R, b.R, t), extrapolate(a.P, b.P, t),
            b.gradient + t * (b.gradient - a.gradient)};
}

/// False if the wall moved so far that the solution may lie on another branch.
bool near(const MembraneState& a, const MembraneState& b)
{
    for (std::size_t i = 0; i < a.R.size(); ++i)
        if (!(b.R[i] < 1.3 * a.R[i] && b.R[i] > a.R[i] / 1.3)) return false;
    return true;
}

[[noreturn]] void no_solution(const TubeProblem& problem, Real fraction)
{
    throw NumericalError(fmt::format("the one-dimensional model finds no steady tube beyond "
                                     "{:.4g} % of the given pressures (Delta P/Delta P_0 = {:.4g})",
                                     100 * fraction, fraction * problem.pressure_ratio()),
                         "smaller pressures or a stiffer wall (smaller eps)");
}

/// Follows the solution from the unloaded tube to the full load, with steps that adapt.
MembraneState load_up(const TubeProblem& problem, const ClampedMembrane& tube)
{
    constexpr Real smallest_step = 1e-7;
    MembraneState before = tube.undeformed(), now = before;
    Real fraction = 0, step = 0.25, last_step = 1;
    while (fraction < 1) {
        step = std::min(step, 1 - fraction);
        MembraneState next = extrapolate(before, now, step / last_step);
        if (tube.solve(membrane_load(problem, fraction + step), next) && near(now, next)) {
            before = std::exchange(now, std::move(next));
            fraction = step < 1 - fraction ? fraction + step : 1;
            last_step = step;
            step *= 1.5;
        } else {
            step /= 2;
            if (step < smallest_step) no_solution(problem, fraction);
        }
    }
    return now;
}

/// Solution on the nodes of the coarse mesh: (4 fine - coarse)/3 removes the second-order error.
MembraneState solve_membrane(const TubeProblem& problem, Index intervals)
{
    const ClampedMembrane coarse = membrane(problem, intervals);
    const ClampedMembrane fine = membrane(problem, 2 * intervals);
    const MembraneState on_coarse = load_up(problem, coarse);
    MembraneState on_fine = fine.undeformed();
    on_fine.gradient = on_coarse.gradient;
    for (std::size_t i = 0; i < fine.x().size(); ++i) {
        on_fine.R[i] = interpolate(coarse.x(), on_coarse.R, fine.x()[i]);
        on_fine.P[i] = interpolate(coarse.x(), on_coarse.P, fine.x()[i]);
    }
    if (!fine.solve(membrane_load(problem, 1), on_fine)) on_fine = load_up(problem, fine);
    MembraneState every_second = on_coarse;
    every_second.gradient = on_fine.gradient;
    for (std::size_t i = 0; i < every_second.R.size(); ++i) {
        every_second.R[i] = on_fine.R[2 * i];
        every_second.P[i] = on_fine.P[2 * i];
    }
    return extrapolate(on_coarse, every_second, 1.0 / 3);
}

/// R_max and x_R_max from the parabola through the largest node and its neighbours.
void find_largest_radius(OneDimensionalTube& tube)
{
    const auto at = std::max_element(tube.R.begin(), tube.R.end());
    const auto i = static_cast<std::size_t>(at - tube.R.begin());
    tube.R_max = tube.R[i];
    tube.x_R_max = tube.x[i];
    if (i == 0 || i + 1 == tube.x.size()) return;
    const Real a = tube.x[i] - tube.x[i - 1], b = tube.x[i + 1] - tube.x[i];
    const Real left = (tube.R[i] - tube.R[i - 1]) / a, right = (tube.R[i + 1] - tube.R[i]) / b;
    const Real curvature = 2 * (right - left) / (a + b);
    const Real slope = (b * left + a * right) / (a + b);
    const bool at_clamp = tube.R_max <= 1;
    if (at_clamp || !(curvature < 0)) return;
    tube.x_R_max -= slope / curvature;
    tube.R_max -= slope * slope / (2 * curvature);
}

/// The share of first-order inertia that the membrane's equations keep where the rest comes from a
/// march: that of a momentum integral over an unchanged parabola.
constexpr Real kept_share = 2.0 / 3;

/// A problem solved with a part of its inertia, on the way to the whole.
struct PartOfInertia {
    const TubeProblem& problem;
    Real part;

    ClampedMembrane tube(Index intervals) const
    {
        return membrane(problem, intervals, part * kept_share);
    }
};

/// What the march along the tube of `state` adds to the kept share, at the nodes and at the outlet,
/// in units of G_s. Empty where it failed.
std::vector<Real> rest_of_inertia(const PartOfInertia& p, const ClampedMembrane& tube,
                                  const MembraneState& state)
{
    const Real Re = p.problem.fluid.reynolds, G_s = shear_modulus(p.problem.material, Re);
    const Real Q = pi * Re / 8 * state.gradient * G_s;
    const Real dynamic = p.part * Q * Q / (pi * pi) / G_s;
    std::vector<Real> more = inertial_pressure(tube.x(), state.R, p.problem.tube.rigid_outlet,
                                               4 * pi / (p.part * Re * Q));
    for (Real& pressure : more) pressure *= dynamic;
    for (std::size_t i = 0; i < std::min(more.size(), state.R.size()); ++i)
        more[i] -= kept_share * dynamic * (1 - std::pow(state.R[i], -4));
    return more;
}

/// Moves the load's `more` and outlet pressure towards those that the state asks for; the largest
/// difference that was left, or NaN.
Real follow(const PartOfInertia& p, const ClampedMembrane& tube, const MembraneState& state,
            MembraneLoad& load)
{
    constexpr Real part = 0.7;
    const std::vector<Real> asked = rest_of_inertia(p, tube, state);
    if (asked.empty()) return std::numeric_limits<Real>::quiet_NaN();
    const Real P_outlet = membrane_load(p.problem, 1).P_outlet - asked.back();
    Real largest = std::abs(P_outlet - load.P_outlet);
    load.P_outlet += part * (P_outlet - load.P_outlet);
    load.more.resize(state.R.size(), 0);
    for (std::size_t i = 0; i < state.R.size(); ++i) {
        largest = std::max(largest, std::abs(asked[i] - load.more[i]));
        load.more[i] += part * (asked[i] - load.more[i]);
    }
    return largest;
}

/// Finds tube and load with this part of the inertia from others nearby; false where it fails.
bool settle(const PartOfInertia& p, const ClampedMembrane& tube, MembraneState& state,
            MembraneLoad& load)
{
    constexpr int most_steps = 100;
    constexpr Real converged = 1e-7; // of the pressure drop
    const Real scale = std::abs(load.P_inlet - membrane_load(p.problem, 1).P_outlet);
    for (int step = 0; step < most_steps; ++step) {
        const MembraneState before = state;
        if (!tube.solve(load, state) || !near(before, state)) return false;
        const Real left = follow(p, tube, state, load);
        if (left < converged * scale) return true;
        if (!std::isfinite(left)) return false;
    }
    return false;
}

/// Lubrication: -dP/dx = 8 Q/(pi Re R^4), by the trapezoidal rule.
OneDimensionalTube rigid_tube_of_varying_radius(const TubeProblem& problem)
{
    constexpr Index intervals = 4000;
    const Real L = problem.tube.length, dx = L / intervals;
    OneDimensionalTube tube;
    std::vector<Real> resistance; // integral of 1/R^4 from the inlet
    for (Index i = 0; i <= intervals; ++i) {
        tube.x.push_back(L * static_cast<Real>(i) / intervals);
        tube.R.push_back(problem.tube.rest_radius(tube.x.back()));
        const auto inverse = [&](std::size_t n) { return std::pow(tube.R[n], -4); };
        const std::size_t n = tube.R.size() - 1;
        resistance.push_back(n == 0 ? 0
                                    : resistance.back() + dx / 2 * (inverse(n - 1) + inverse(n)));
    }
    const Real drop = problem.pressure_drop() / resistance.back();
    for (Real r : resistance) tube.P.push_back(problem.drive.pressure_inlet - drop * r);
    tube.Q = pi * problem.fluid.reynolds / 8 * drop;
    find_largest_radius(tube);
    return tube;
}

OneDimensionalTube rigid_tube(const TubeProblem& problem)
{
    if (!problem.tube.rest_radius.uniform()) return rigid_tube_of_varying_radius(problem);
    const DriveParameters& d = problem.drive;
    const Real L = problem.tube.length;
    return {.x = {0, L},
            .R = {1, 1},
            .P = {d.pressure_inlet, d.pressure_outlet},
            .Q = poiseuille::flow_rate(problem.pressure_drop(), L, problem.fluid.reynolds)};
}

} // namespace

Real OneDimensionalTube::R_at(Real position) const { return interpolate(x, R, position); }
Real OneDimensionalTube::P_at(Real position) const { return interpolate(x, P, position); }

namespace {

/// The tube of a state, with `more` pressure at its nodes (G_s).
OneDimensionalTube tube_of(const TubeProblem& problem, const ClampedMembrane& mesh,
                           const MembraneState& state, const std::vector<Real>& more)
{
    const Real G_s = shear_modulus(problem.material, problem.fluid.reynolds);
    OneDimensionalTube tube;
    tube.x = mesh.x();
    tube.R = state.R;
    for (const Real P : mesh.axis_pressure(state)) tube.P.push_back(P * G_s);
    for (std::size_t i = 0; i < more.size(); ++i) tube.P[i] += more[i] * G_s;
    tube.Q = pi * problem.fluid.reynolds / 8 * state.gradient * G_s;
    find_largest_radius(tube);
    if (problem.tube.rigid_inlet > 0) {
        tube.x.insert(tube.x.begin(), 0);
        tube.R.insert(tube.R.begin(), 1);
        tube.P.insert(tube.P.begin(), problem.drive.pressure_inlet);
    }
    if (problem.tube.rigid_outlet > 0) {
        tube.x.push_back(problem.tube.length);
        tube.R.push_back(1);
        tube.P.push_back(problem.drive.pressure_outlet);
    }
    return tube;
}

void refuse_varying_rest_radius(const TubeProblem& problem)
{
    if (!problem.tube.rest_radius.uniform())
        throw InputError("the one-dimensional model has no wall whose rest radius varies along x "
                         "([rest_radius]), unless the tube is rigid");
}

} // namespace

OneDimensionalTube solve_one_dimensional(const TubeProblem& problem, Index intervals)
{
    if (problem.tube.rigid) return rigid_tube(problem);
    refuse_varying_rest_radius(problem);
    const MembraneState state = solve_membrane(problem, intervals);
    return tube_of(problem, membrane(problem, intervals), state, {});
}

OneDimensionalTube solve_marched(const TubeProblem& problem, Index intervals)
{
    if (problem.tube.rigid) return rigid_tube(problem);
    refuse_varying_rest_radius(problem);
    constexpr Real smallest_step = 0.02;
    MembraneState state = load_up(problem, membrane(problem, intervals, 0));
    MembraneLoad load = membrane_load(problem, 1);
    load.more.assign(state.R.size(), 0);
    for (Real part = 0, step = 1; part < 1;) {
        const PartOfInertia next{problem, std::min(part + step, 1.0)};
        MembraneState there = state;
        MembraneLoad load_there = load;
        if (settle(next, next.tube(intervals), there, load_there)) {
            part = next.part;
            state = std::move(there);
            load = std::move(load_there);
        } else if ((step /= 2) < smallest_step)
            throw NumericalError(
                fmt::format("the one-dimensional model with inertia finds no steady tube beyond "
                            "Re = {:.3g}",
                            part * problem.fluid.reynolds),
                "smaller pressures, a stiffer wall (smaller eps) or a smaller Reynolds number");
    }
    return tube_of(problem, PartOfInertia{problem, 1}.tube(intervals), state, load.more);
}

} // namespace starling
