#include "theory/boundary_layer.hpp"

#include <algorithm>
#include <limits>

namespace starling {

namespace {

constexpr std::size_t intervals = 120;

} // namespace

/// The linearised equations: unknown pairs (w, F) per node, bordered by the excess.
struct MarchedProfile::System {
    BlockTridiagonal matrix{intervals + 1};
    std::vector<Pair> residual = std::vector<Pair>(intervals + 1), border = residual;
};

MarchedProfile::MarchedProfile(Real viscosity) : viscosity_(viscosity)
{
    for (std::size_t j = 0; j <= intervals; ++j) {
        const Real to_wall = 1 - static_cast<Real>(j) / intervals, s = 1 - to_wall * to_wall;
        s_.push_back(s);
        w_.push_back(2 * (1 - s));
        F_.push_back(s * (2 - s));
    }
    old_w_ = w_;
    old_F_ = F_;
    for (std::size_t j = 0; j < intervals; ++j) weights_.push_back(weights(j));
}

MarchedProfile::Weights MarchedProfile::weights(std::size_t j) const
{
    const Real up = s_[j + 1] - s_[j];
    if (j == 0) return {.curve_up = 1 / up}; // a cell from the axis to half way
    const Real down = s_[j] - s_[j - 1], half = (up + down) / 2;
    return {up / down / (up + down), down / up / (up + down),
            (s_[j] + s_[j - 1]) / 2 / (down * half), (s_[j] + s_[j + 1]) / 2 / (up * half)};
}

bool MarchedProfile::turns_back() const { return w_[intervals - 1] < 0; }

/// w w_x - F_x w_s = 2 (R'/R) w^2 + G + viscosity (s w_s)_s, G = 2 viscosity + excess, times h and
/// implicit in x.
void MarchedProfile::add_momentum(std::size_t j, Real h, Real log_growth, System& system) const
{
    const Weights& d = weights_[j];
    const Real w = w_[j], dF = F_[j] - old_F_[j], nu = viscosity_ * h;
    const Real up = w_[j + 1] - w, down = j > 0 ? w - w_[j - 1] : 0;
    const Real forward = w > 0 ? 1 : 0, slope = d.slope_down * down + d.slope_up * up;
    system.residual[j][0] = forward * w * (w - old_w_[j]) - dF * slope - 2 * log_growth * w * w -
                            (2 * viscosity_ + excess_) * h -
                            nu * (d.curve_up * up - d.curve_down * down);
    system.border[j][0] = -h;
    system.matrix.diagonal[j][0] = {forward * (2 * w - old_w_[j]) - 4 * log_growth * w +
                                        dF * (d.slope_up - d.slope_down) +
                                        nu * (d.curve_up + d.curve_down),
                                    -slope};
    system.matrix.upper[j][0][0] = -dF * d.slope_up - nu * d.curve_up;
    system.matrix.lower[j][0][0] = dF * d.slope_down - nu * d.curve_down;
}

/// F = the integral of w over s, by the trapezoidal rule.
void MarchedProfile::add_flow(System& system) const
{
    system.residual[0][1] = F_[0];
    system.matrix.diagonal[0][1][1] = 1;
    for (std::size_t j = 1; j <= intervals; ++j) {
        const Real half = (s_[j] - s_[j - 1]) / 2;
        system.residual[j][1] = F_[j] - F_[j - 1] - half * (w_[j] + w_[j - 1]);
        system.matrix.diagonal[j][1] = {-half, 1};
        system.matrix.lower[j][1] = {-half, -1};
    }
}

/// Returns the largest change of w.
Real MarchedProfile::newton_step(Real h, Real log_growth)
{
    System system;
    for (std::size_t j = 0; j < intervals; ++j) add_momentum(j, h, log_growth, system);
    system.residual[intervals][0] = w_[intervals];
    system.matrix.diagonal[intervals][0][0] = 1;
    add_flow(system);
    auto& [matrix, change, border] = system;
    matrix.solve(change, border);
    const Real d_excess = (F_[intervals] - 1 - change[intervals][1]) / border[intervals][1];
    Real largest = 0;
    for (std::size_t j = 0; j <= intervals; ++j) {
        const Real dw = change[j][0] + border[j][0] * d_excess;
        if (!std::isfinite(dw)) return dw;
        w_[j] -= dw;
        F_[j] -= change[j][1] + border[j][1] * d_excess;
        largest = std::max(largest, std::abs(dw));
    }
    excess_ += d_excess;
    return largest;
}

Real MarchedProfile::advance(Real h, Real log_growth)
{
    constexpr int most_steps = 20;
    constexpr Real converged = 1e-9;
    old_w_ = w_;
    old_F_ = F_;
    for (int step = 0; step < most_steps; ++step) {
        const Real largest = newton_step(h, log_growth);
        if (largest < converged) return excess_;
        if (!std::isfinite(largest)) break;
    }
    return std::numeric_limits<Real>::quiet_NaN();
}

std::vector<Real> inertial_pressure(const std::vector<Real>& x, const std::vector<Real>& R,
                                    Real outlet, Real viscosity)
{
    constexpr int outlet_steps = 100;
    MarchedProfile profile(viscosity);
    std::vector<Real> P(x.size() + 1);
    for (std::size_t i = 1; i < x.size(); ++i) {
        const Real h = x[i] - x[i - 1], R4 = std::pow(R[i] * R[i - 1], 2);
        P[i] = P[i - 1] - profile.advance(h, std::log(R[i] / R[i - 1])) * h / R4;
        if (!std::isfinite(P[i])) return {};
    }
    P.back() = P[x.size() - 1];
    for (int n = 1; n <= outlet_steps; ++n) { // shorter steps at the clamp
        const Real from = static_cast<Real>(n - 1) / outlet_steps;
        const Real h = outlet * (2 * from + 1.0 / outlet_steps) / outlet_steps;
        P.back() -= profile.advance(h, 0) * h;
    }
    if (!std::isfinite(P.back())) return {};
    return P;
}

} // namespace starling
