#include "theory/clamped_membrane.hpp"

#include <algorithm>

#include "theory/dual.hpp"

namespace starling {

namespace {

/// Virtual work of a ring per unit undeformed length: axial_force dR' + hoop_force dR, with
/// derivatives with respect to R and R'.
struct RingForces {
    Dual axial_force; // lambda2 tau1 R'/lambda1
    Dual hoop_force;  // lambda1 tau2
};

template <class Law>
RingForces ring_forces(const Law& law, Real least_tension, Real R, Real R_prime)
{
    const Dual lambda2 = Dual::first(R), slope = Dual::second(R_prime);
    const Dual lambda1 = sqrt(1 + slope * slope);
    const auto tau = law.tensions(lambda1, lambda2);
    const Dual tau1 = tau.tau1.value > least_tension ? tau.tau1 : Dual(least_tension);
    return {lambda2 * tau1 * slope / lambda1, lambda1 * tau.tau2};
}

RingForces times(Real k, const RingForces& f)
{
    return {Dual(k) * f.axial_force, Dual(k) * f.hoop_force};
}

Dual fourth_power(const Dual& R) { return R * R * R * R; }

/// -dP/dx over the gradient of the rigid ends: Poiseuille's, longer by the slope.
Dual relative_drop(const Dual& R, const Dual& slope)
{
    const Dual sin2 = slope * slope / (1 + slope * slope);
    return (1 + Dual(4.0 / 3) * sin2) / fourth_power(R);
}

/// Pressure that the wall feels beyond the viscous P, of the gradient g and its two causes.
struct ExtraPressure {
    Dual per_gradient;         ///< slope: pressure across the section and shear on the wall
    Dual per_squared_gradient; ///< inertia

    ExtraPressure(const Dual& R, const Dual& slope, Real inertia)
        : per_gradient(-slope / (Dual(3) * (1 + slope * slope) * R * R * R)),
          per_squared_gradient(Dual(inertia) * (1 - 1 / fourth_power(R)))
    {
    }
    Dual value(Real g) const { return Dual(g) * per_gradient + Dual(g * g) * per_squared_gradient; }
    Real derivative(Real g) const
    {
        return per_gradient.value + 2 * g * per_squared_gradient.value;
    }
};

/// Two nodes and the flow between them.
struct ElementState {
    Real h = 0;
    Pair R{}, P{}; ///< P transmural
    Real gradient = 0, inertia = 0, support = 0, stiffness = 1;
};

/// Virtual work of one element between its nodes 0 and 1 for dR at each, and its derivatives.
struct Element {
    Pair residual{};
    Block dR{}; // [dR at][derivative with respect to R at]
    Pair dP{};  // with respect to P at the same node
    Pair dg{};  // with respect to the gradient
};

template <class Law>
Element element(const Law& law, Real least_tension, const ElementState& s)
{
    constexpr Pair sign{-1, 1}; // h d(slope)/dR
    const Real slope = (s.R[1] - s.R[0]) / s.h;
    Element e;
    for (std::size_t a : {0u, 1u}) { // the two points of the trapezoidal rule
        const Dual R = Dual::first(s.R[a]);
        const RingForces f =
            times(s.stiffness, ring_forces(law, least_tension / s.stiffness, s.R[a], slope));
        const ExtraPressure extra(R, Dual::second(slope), s.inertia);
        const Dual radial =
            f.hoop_force + Dual(s.support) * (R - 1) - (s.P[a] + extra.value(s.gradient)) * R;
        e.residual[a] += s.h / 2 * radial.value;
        e.dR[a][a] += s.h / 2 * radial.d1;
        e.dP[a] -= s.h / 2 * s.R[a];
        e.dg[a] -= s.h / 2 * s.R[a] * extra.derivative(s.gradient);
        for (std::size_t b : {0u, 1u}) {
            e.residual[b] += sign[b] / 2 * f.axial_force.value;
            e.dR[b][a] += sign[b] / 2 * f.axial_force.d1;
            e.dR[a][b] += sign[b] / 2 * radial.d2;
            for (std::size_t c : {0u, 1u})
                e.dR[b][c] += sign[b] * sign[c] / (2 * s.h) * f.axial_force.d2;
        }
    }
    return e;
}

/// The axial tension that stands in for anything less. Where the wall is compressed along the axis
/// (negative transmural pressure) a membrane wrinkles and its equation is not elliptic; a little
/// tension instead keeps the smooth solution, which bending selects in reality. In inflation it is
/// never reached unless nu_s is nearly 0.
Real least_axial_tension(const MembraneLoad& load)
{
    const auto [low, high] =
        std::minmax({load.P_inlet - load.P_external, load.P_outlet - load.P_external});
    return 1e-4 * std::max(high, -low) + 1e-2 * std::max(0.0, -low);
}

/// Slope at node i between its neighbours, of the parabola through the three.
Real slope_at(const std::vector<Real>& x, const std::vector<Real>& R, std::size_t i)
{
    const Real a = x[i] - x[i - 1], b = x[i + 1] - x[i];
    return (b * (R[i] - R[i - 1]) / a + a * (R[i + 1] - R[i]) / b) / (a + b);
}

} // namespace

/// The linearised equations: unknown pairs (R, P) per node, bordered by the gradient.
struct ClampedMembrane::System {
    BlockTridiagonal matrix;
    std::vector<Pair> residual, border;

    explicit System(std::size_t nodes) : matrix(nodes), residual(nodes), border(nodes) {}
};

ClampedMembrane::ClampedMembrane(std::vector<Real> x, Real rigid_inlet, Real rigid_outlet,
                                 Material law, Real inertia, Real support, const AlongX& stiffness)
    : x_(std::move(x)), rigid_inlet_(rigid_inlet), rigid_outlet_(rigid_outlet), law_(law),
      inertia_(inertia), support_(support)
{
    for (std::size_t i = 0; i + 1 < x_.size(); ++i)
        stiffness_.push_back(stiffness((x_[i] + x_[i + 1]) / 2));
}

MembraneState ClampedMembrane::undeformed() const
{
    return {std::vector<Real>(x_.size(), 1), std::vector<Real>(x_.size(), 0), 0};
}

template <class Law>
void ClampedMembrane::add_ring_balance(const Law& law, const MembraneLoad& load,
                                       const MembraneState& state, System& system) const
{
    auto& [lower, diagonal, upper] = system.matrix;
    const Real least_tension = least_axial_tension(load);
    const auto transmural = [&](std::size_t i) {
        return state.P[i] - load.P_external + (load.more.empty() ? 0 : load.more[i]);
    };
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
        const std::size_t j = i + 1;
        const Element e = element(law, least_tension,
                                  {.h = x_[j] - x_[i],
                                   .R = {state.R[i], state.R[j]},
                                   .P = {transmural(i), transmural(j)},
                                   .gradient = state.gradient,
                                   .inertia = inertia_,
                                   .support = support_,
                                   .stiffness = stiffness_[i]});
        system.residual[i][0] += e.residual[0];
        system.residual[j][0] += e.residual[1];
        diagonal[i][0][0] += e.dR[0][0];
        upper[i][0][0] += e.dR[0][1];
        lower[j][0][0] += e.dR[1][0];
        diagonal[j][0][0] += e.dR[1][1];
        diagonal[i][0][1] += e.dP[0];
        diagonal[j][0][1] += e.dP[1];
        system.border[i][0] += e.dg[0];
        system.border[j][0] += e.dg[1];
    }
}

void ClampedMembrane::add_pressure_drop(const MembraneLoad& load, const MembraneState& state,
                                        System& system) const
{
    auto& [lower, diagonal, upper] = system.matrix;
    const Real g = state.gradient;
    system.residual[0][1] = state.P[0] + g * rigid_inlet_ - load.P_inlet;
    system.border[0][1] = rigid_inlet_;
    diagonal[0][1][1] = 1;
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
        const std::size_t j = i + 1;
        const Real h = x_[j] - x_[i], slope = (state.R[j] - state.R[i]) / h;
        const auto drop = [&](Real R) {
            return Dual(h / 2) * relative_drop(Dual::first(R), Dual::second(slope));
        };
        const Dual at_i = drop(state.R[i]), at_j = drop(state.R[j]);
        const Real d_slope = (at_i.d2 + at_j.d2) / h;
        system.residual[j][1] = state.P[j] - state.P[i] + g * (at_i.value + at_j.value);
        system.border[j][1] = at_i.value + at_j.value;
        lower[j][1] = {g * (at_i.d1 - d_slope), -1};
        diagonal[j][1] = {g * (at_j.d1 + d_slope), 1};
    }
}

ClampedMembrane::System ClampedMembrane::assemble(const MembraneLoad& load,
                                                  const MembraneState& state) const
{
    System system(x_.size());
    std::visit([&](const auto& law) { add_ring_balance(law, load, state, system); }, law_);
    add_pressure_drop(load, state, system);
    for (const std::size_t clamp : {std::size_t{0}, x_.size() - 1}) {
        system.residual[clamp][0] = state.R[clamp] - 1;
        system.border[clamp][0] = 0;
        system.matrix.lower[clamp][0] = system.matrix.upper[clamp][0] = {0, 0};
        system.matrix.diagonal[clamp][0] = {1, 0};
    }
    return system;
}

/// Moves `state` by one damped Newton step and returns the largest relative change of R asked for.
Real ClampedMembrane::newton_step(const MembraneLoad& load, MembraneState& state) const
{
    System system = assemble(load, state);
    auto& [matrix, change, border] = system;
    matrix.solve(change, border);
    const Real outlet = state.P.back() - state.gradient * rigid_outlet_ - load.P_outlet;
    const Real d_gradient = (outlet - change.back()[1]) / (border.back()[1] + rigid_outlet_);
    Real largest = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
        for (int c : {0, 1}) change[i][c] = -change[i][c] - border[i][c] * d_gradient;
        largest = std::max(largest, std::abs(change[i][0]) / state.R[i]);
        if (!std::isfinite(change[i][0])) return change[i][0];
    }
    const Real damping = std::min(1.0, 0.3 / largest);
    for (std::size_t i = 0; i < x_.size(); ++i) {
        state.R[i] += damping * change[i][0];
        state.P[i] += damping * change[i][1];
    }
    state.gradient += damping * d_gradient;
    return largest;
}

bool ClampedMembrane::solve(const MembraneLoad& load, MembraneState& state) const
{
    constexpr int most_steps = 20;
    constexpr Real converged = 1e-11;
    for (int step = 0; step < most_steps; ++step) {
        const Real largest = newton_step(load, state);
        if (largest < converged) return true;
        if (!std::isfinite(largest)) return false;
    }
    return false;
}

std::vector<Real> ClampedMembrane::axis_pressure(const MembraneState& state) const
{
    const Real g = state.gradient;
    std::vector<Real> P(state.P);
    for (std::size_t i = 1; i + 1 < x_.size(); ++i) {
        const Real R = state.R[i], R4 = R * R * R * R, tan_beta = slope_at(x_, state.R, i);
        P[i] += g * tan_beta * R / (6 * (1 + tan_beta * tan_beta) * R4) +
                inertia_ * g * g * (1 - 1 / R4);
    }
    return P;
}

} // namespace starling
