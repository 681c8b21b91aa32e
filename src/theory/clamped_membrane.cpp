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

/// Virtual work of one element between its nodes 0 and 1 for dR at each, and its derivatives.
struct Element {
    Pair residual{};
    Block dR{}; // [dR at][derivative with respect to R at]
    Pair dP{};  // with respect to P at the same node
};

template <class Law>
Element element(const Law& law, Real least_tension, Real h, const Pair& R, const Pair& P)
{
    constexpr Pair sign{-1, 1}; // h d(slope)/dR
    const Real slope = (R[1] - R[0]) / h;
    Element e;
    for (std::size_t a : {0u, 1u}) { // the two points of the trapezoidal rule
        const RingForces f = ring_forces(law, least_tension, R[a], slope);
        e.residual[a] += h / 2 * (f.hoop_force.value - P[a] * R[a]);
        e.dR[a][a] += h / 2 * (f.hoop_force.d1 - P[a]);
        e.dP[a] -= h / 2 * R[a];
        for (std::size_t b : {0u, 1u}) {
            e.residual[b] += sign[b] / 2 * f.axial_force.value;
            e.dR[b][a] += sign[b] / 2 * f.axial_force.d1;
            e.dR[a][b] += sign[b] / 2 * f.hoop_force.d2;
            for (std::size_t c : {0u, 1u})
                e.dR[b][c] += sign[b] * sign[c] / (2 * h) * f.axial_force.d2;
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

Real fourth_power(Real R) { return R * R * R * R; }

} // namespace

/// The linearised equations: unknown pairs (R, P) per node, bordered by the gradient.
struct ClampedMembrane::System {
    BlockTridiagonal matrix;
    std::vector<Pair> residual, border;

    explicit System(std::size_t nodes) : matrix(nodes), residual(nodes), border(nodes) {}
};

ClampedMembrane::ClampedMembrane(std::vector<Real> x, Real rigid_inlet, Real rigid_outlet,
                                 Material law)
    : x_(std::move(x)), rigid_inlet_(rigid_inlet), rigid_outlet_(rigid_outlet), law_(law)
{
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
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
        const std::size_t j = i + 1;
        const Element e = element(law, least_tension, x_[j] - x_[i], {state.R[i], state.R[j]},
                                  {state.P[i] - load.P_external, state.P[j] - load.P_external});
        system.residual[i][0] += e.residual[0];
        system.residual[j][0] += e.residual[1];
        diagonal[i][0][0] += e.dR[0][0];
        upper[i][0][0] += e.dR[0][1];
        lower[j][0][0] += e.dR[1][0];
        diagonal[j][0][0] += e.dR[1][1];
        diagonal[i][0][1] += e.dP[0];
        diagonal[j][0][1] += e.dP[1];
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
        const Real h = x_[j] - x_[i];
        const Real drop_i = h / (2 * fourth_power(state.R[i]));
        const Real drop_j = h / (2 * fourth_power(state.R[j]));
        system.residual[j][1] = state.P[j] - state.P[i] + g * (drop_i + drop_j);
        system.border[j][1] = drop_i + drop_j;
        lower[j][1] = {-4 * g * drop_i / state.R[i], -1};
        diagonal[j][1] = {-4 * g * drop_j / state.R[j], 1};
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
    constexpr int most_steps = 15;
    constexpr Real converged = 1e-11;
    for (int step = 0; step < most_steps; ++step) {
        const Real largest = newton_step(load, state);
        if (largest < converged) return true;
        if (!std::isfinite(largest)) return false;
    }
    return false;
}

} // namespace starling
