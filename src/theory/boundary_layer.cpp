#include "theory/boundary_layer.hpp"

#include <algorithm>
#include <limits>

namespace starling {

namespace {

constexpr std::size_t intervals = 120;

} // namespace

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
}

bool MarchedProfile::turns_back() const { return w_[intervals - 1] < 0; }

/// w w_x - F_x w_s = 2 (R'/R) w^2 + G + viscosity (s w_s)_s with F = the integral of w over s,
/// G = 2 viscosity + excess, implicit in x; returns the largest change of w.
Real MarchedProfile::newton_step(Real h, Real a)
{
    BlockTridiagonal m(intervals + 1);
    std::vector<Pair> residual(intervals + 1), border(intervals + 1);
    const Real nu = viscosity_ * h, G = (2 * viscosity_ + excess_) * h;
    for (std::size_t j = 0; j < intervals; ++j) {
        const Real forward = w_[j] > 0 ? 1 : 0, dF = F_[j] - old_F_[j];
        const Real right = s_[j + 1] - s_[j], left = j > 0 ? s_[j] - s_[j - 1] : right;
        const Real s_right = (s_[j] + s_[j + 1]) / 2, s_left = j > 0 ? s_[j] - left / 2 : 0;
        const Real up = s_right / right / (s_right - s_left);
        const Real down = s_left / left / (s_right - s_left);
        const Real w_left = j > 0 ? w_[j - 1] : 0;
        // The slope of the parabola through three nodes; F_x = 0 on the axis.
        const Real c_up = left / right / (left + right), c_down = right / left / (left + right);
        const Real slope = j > 0 ? c_up * (w_[j + 1] - w_[j]) + c_down * (w_[j] - w_left) : 0;
        residual[j][0] = forward * w_[j] * (w_[j] - old_w_[j]) - dF * slope -
                         2 * a * w_[j] * w_[j] - G -
                         nu * (up * (w_[j + 1] - w_[j]) - down * (w_[j] - w_left));
        m.diagonal[j][0][0] = forward * (2 * w_[j] - old_w_[j]) - 4 * a * w_[j] + nu * (up + down);
        m.upper[j][0][0] = -nu * up;
        border[j][0] = -h;
        if (j > 0) {
            m.diagonal[j][0][0] += dF * (c_up - c_down);
            m.diagonal[j][0][1] = -slope;
            m.upper[j][0][0] -= dF * c_up;
            m.lower[j][0][0] = dF * c_down - nu * down;
        }
    }
    residual[intervals][0] = w_[intervals];
    m.diagonal[intervals][0][0] = 1;
    residual[0][1] = F_[0];
    m.diagonal[0][1][1] = 1;
    for (std::size_t j = 1; j <= intervals; ++j) {
        const Real half = (s_[j] - s_[j - 1]) / 2;
        residual[j][1] = F_[j] - F_[j - 1] - half * (w_[j] + w_[j - 1]);
        m.diagonal[j][1] = {-half, 1};
        m.lower[j][1] = {-half, -1};
    }
    const Real whole = F_[intervals] - 1;
    m.solve(residual, border);
    const Real d_excess = (whole - residual[intervals][1]) / border[intervals][1];
    Real largest = 0;
    for (std::size_t j = 0; j <= intervals; ++j) {
        const Real change = -residual[j][0] - border[j][0] * d_excess;
        if (!std::isfinite(change)) return change;
        w_[j] += change;
        F_[j] -= residual[j][1] + border[j][1] * d_excess;
        largest = std::max(largest, std::abs(change));
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
