#include "theory/mode_stiffness.hpp"

#include <algorithm>
#include <limits>

#include "theory/dual.hpp"

namespace starling {

namespace {

/// Second Piola-Kirchhoff tensions (along x and around) and Cauchy tension around at (1, R).
struct UniformTube {
    Dual S1, S2, tau2; ///< d1: derivative with respect to R
};

UniformTube uniform_tube(const Material& law, Real R)
{
    const Dual lambda2 = Dual::first(R);
    return std::visit(
        [&](const auto& l) {
            const auto tau = l.tensions(Dual(1), lambda2);
            return UniformTube{lambda2 * tau.tau1, tau.tau2 / lambda2, tau.tau2};
        },
        law);
}

/// Outward bending force of the uniform tube per deformed area, E_b (1/R^3 - 1/R)/2.
Dual bending_force(Real E_b, Real R)
{
    const Dual r = Dual::first(R);
    return E_b / 2 * (1 / (r * r * r) - 1 / r);
}

/// Twice the energy of the shear strain over its square: (S2 - S1)/(lambda2^2 - lambda1^2), for an
/// isotropic wall. Near R = 1, where it is 0/0, the same by the midpoint rule.
Real shear_stiffness(const Material& law, Real R)
{
    if (std::abs(R - 1) > 1e-3) {
        const UniformTube t = uniform_tube(law, R);
        return (t.S2.value - t.S1.value) / (R * R - 1);
    }
    const Real middle = (1 + R) / 2;
    const UniformTube t = uniform_tube(law, middle);
    return (t.S2.d1 - t.S1.d1) / (2 * middle);
}

Dual pressure(const Material& law, Real E_b, Real R)
{
    return uniform_tube(law, R).S2 - bending_force(E_b, R);
}

} // namespace

ModeStiffness mode_stiffness(const Material& law, Real E_b, Real R, int n)
{
    const UniformTube t = uniform_tube(law, R);
    const Real hoop = t.tau2.d1, p = pressure(law, E_b, R).value;
    const Real R2 = R * R, nn = Real(n) * n;
    const Real bending_1 = R * (2 * nn - 2.5) / R2 + 2 / R + R / 2 - 2;
    const Real bending_0 = ((nn - 1) * (nn - 1.5) - 0.5) / (R2 * R) + nn / (2 * R);
    return {.w_xx = E_b * R,
            .w_x = t.S1.value + E_b * bending_1,
            .w = hoop + nn * t.S2.value - p + E_b * bending_0,
            .wv = n * hoop,
            .v_x = t.S1.value + R2 * shear_stiffness(law, R),
            .v = nn * hoop};
}

Real pressure_at(const Material& law, Real E_b, Real R) { return pressure(law, E_b, R).value; }

Real radius_at(const Material& law, Real E_b, Real target)
{
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    constexpr int most_steps = 60;
    constexpr Real converged = 1e-13; // of R; round-off of the tensions at R = 1 is 1e-16 G_s
    Real R = 1;
    for (int step = 0; step < most_steps; ++step) {
        const Dual p = pressure(law, E_b, R);
        if (!(p.d1 > 0)) return nan;
        const Real change = std::clamp((target - p.value) / p.d1, -0.1 * R, 0.1 * R);
        R += change;
        if (R < 0.2 || R > 5) return nan;
        if (std::abs(change) < converged) return R;
    }
    return nan;
}

} // namespace starling
