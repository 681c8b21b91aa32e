#include "theory/mode_stiffness.hpp"

#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <vector>

namespace starling {
namespace {

using Complex = std::complex<Real>;

const std::vector<Material> all_laws{Hooke{1, 0.3}, Hooke{1, 0.5}, NeoHookean{1},
                                     MooneyRivlin{1, 0.5}, Skalak{1, 1}};

/// A tube of radius R with w = W cos(n theta) sin(q x), v = V sin(n theta) sin(q x), and its
/// position and derivatives at one point, written without any expansion in W and V.
struct Mode {
    Real R, q;
    int n;
};
struct Point {
    Complex z, z_x, z_theta, z_xx, z_x_theta, z_theta_theta;
};

Point point(const Mode& m, Real W, Real V, Real x, Real theta)
{
    const Real n = m.n, s = std::sin(m.q * x), c = m.q * std::cos(m.q * x);
    const Complex i(0, 1), turn = std::polar(1.0, theta);
    const Complex a(W * std::cos(n * theta), V * std::sin(n * theta));
    const Complex a1(-n * W * std::sin(n * theta), n * V * std::cos(n * theta)), a2 = -n * n * a;
    return {(m.R + s * a) * turn,
            c * a * turn,
            (s * a1 + i * (m.R + s * a)) * turn,
            -m.q * m.q * s * a * turn,
            c * (a1 + i * a) * turn,
            (s * a2 + 2.0 * i * s * a1 - (m.R + s * a)) * turn};
}

struct Metric {
    Real xx, tt, xt;
};

Real product(Complex a, Complex b) { return a.real() * b.real() + a.imag() * b.imag(); }

Metric metric(const Point& p)
{
    return {1 + std::norm(p.z_x), std::norm(p.z_theta), product(p.z_x, p.z_theta)};
}

/// Second Piola-Kirchhoff tension of an isotropic law, by principal directions.
Metric tension(const Material& law, const Metric& g)
{
    const Real mean = (g.xx + g.tt) / 2, half = (g.xx - g.tt) / 2;
    const Real radius = std::sqrt(half * half + g.xt * g.xt);
    const Real l1 = std::sqrt(mean + radius), l2 = std::sqrt(mean - radius);
    const Tensions tau =
        std::visit([&](const auto& l) -> Tensions { return l.tensions(l1, l2); }, law);
    const Real S1 = tau.tau1 * l2 / l1, S2 = tau.tau2 * l1 / l2;
    const Real k = (S1 - S2) / (2 * radius), S = (S1 + S2) / 2;
    return {S + k * half, S - k * half, k * g.xt};
}

/// (2 kappa - c_0)^2 dS/2 per dx dtheta, from the fundamental forms in space.
Real bending_energy(const Point& p)
{
    const Vec3 x{1, p.z_x.real(), p.z_x.imag()}, t{0, p.z_theta.real(), p.z_theta.imag()};
    const auto across = [](Complex z) { return Vec3{0, z.real(), z.imag()}; };
    const Vec3 N = cross(t, x); // outward: d/dtheta x d/dx
    const Real J = norm(N);
    const Metric g = metric(p);
    const Real e = dot(across(p.z_xx), N) / J, f = dot(across(p.z_x_theta), N) / J;
    const Real h = dot(across(p.z_theta_theta), N) / J;
    const Real two_kappa = -(e * g.tt - 2 * f * g.xt + h * g.xx) / (J * J);
    return (two_kappa - 1) * (two_kappa - 1) / 2 * J;
}

/// Mean over the surface of f(x, theta): uniform points are exact for what oscillates slower.
template <class F>
Real mean(const Mode& m, F f)
{
    constexpr int points = 24;
    Real sum = 0;
    for (int i = 0; i < points; ++i)
        for (int j = 0; j < points; ++j)
            sum += f((i + 0.5) / points * 2 * pi / m.q, (j + 0.5) / points * 2 * pi / m.n);
    return sum / (points * points);
}

/// Generalised force on W (which = 0) or V (1): virtual work of tensions, bending and pressure.
Real force(const Material& law, Real E_b, Real pressure, const Mode& m, std::array<Real, 2> a,
           std::size_t which)
{
    constexpr Real step = 1e-4;
    auto b = a;
    a[which] -= step;
    b[which] += step;
    return mean(m, [&](Real x, Real theta) {
        const Point p = point(m, a[0], a[1], x, theta), q = point(m, b[0], b[1], x, theta);
        const Metric g = metric(p), h = metric(q);
        const Metric S =
            tension(law, metric(point(m, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, x, theta)));
        const Real stretching =
            (S.xx * (h.xx - g.xx) + S.tt * (h.tt - g.tt)) / 2 + S.xt * (h.xt - g.xt);
        const Real area =
            (std::imag(std::conj(q.z) * q.z_theta) - std::imag(std::conj(p.z) * p.z_theta)) / 2;
        const Real bending = E_b * (bending_energy(q) - bending_energy(p));
        return (stretching + bending - pressure * area) / (2 * step);
    });
}

/// The same form from the full nonlinear virtual work of a surface in space, differentiated
/// numerically: K[i][j] = d(force on i)/d(amplitude j), times 4 for the means of cos^2 and sin^2.
std::array<std::array<Real, 2>, 2> stiffness_of_surface(const Material& law, Real E_b,
                                                        const Mode& m)
{
    constexpr Real step = 1e-3;
    const Real pressure = pressure_at(law, E_b, m.R);
    std::array<std::array<Real, 2>, 2> K{};
    for (const std::size_t i : {0u, 1u})
        for (const std::size_t j : {0u, 1u}) {
            std::array<Real, 2> a{}, b{};
            a[j] = -step;
            b[j] = step;
            K[i][j] = 4 *
                      (force(law, E_b, pressure, m, b, i) - force(law, E_b, pressure, m, a, i)) /
                      (2 * step);
        }
    return K;
}

TEST(ModeStiffness, IsTheSecondVariationOfTheWholeSurface)
{
    for (const Material& law : all_laws)
        for (const Mode& m : {Mode{0.9, 0.3, 2}, Mode{0.97, 0.5, 3}, Mode{1.1, 1.2, 2}}) {
            const Real E_b = 0.05, q2 = m.q * m.q;
            const ModeStiffness k = mode_stiffness(law, E_b, m.R, m.n);
            const auto K = stiffness_of_surface(law, E_b, m);
            EXPECT_NEAR(k.w_xx * q2 * q2 + k.w_x * q2 + k.w, K[0][0], 3e-5 * (1 + K[0][0]));
            EXPECT_NEAR(k.wv, K[0][1], 3e-5 * (1 + K[0][1]));
            EXPECT_NEAR(k.wv, K[1][0], 3e-5 * (1 + K[1][0]));
            EXPECT_NEAR(k.v_x * q2 + k.v, K[1][1], 3e-5 * (1 + K[1][1]));
        }
}

TEST(ModeStiffness, BendingAtRestIsThatOfThePerturbedCylinder)
{
    // f_n = -E_b a [(n^2 - 1) + q^2]^2 on r = 1 + a cos(n theta) cos(q x)
    for (const int n : {2, 3, 5})
        for (const Real q : {0.0, 0.4, 2.0}) {
            const ModeStiffness with = mode_stiffness(NeoHookean{}, 1, 1, n);
            const ModeStiffness without = mode_stiffness(NeoHookean{}, 0, 1, n);
            const Real q2 = q * q;
            EXPECT_NEAR(with.w_xx * q2 * q2 + (with.w_x - without.w_x) * q2 + with.w - without.w,
                        std::pow(n * n - 1 + q2, 2), 1e-11);
        }
}

TEST(ModeStiffness, ShearIsContinuousWhereItIsZeroOverZero)
{
    for (const Material& law : all_laws) {
        const auto shear = [&](Real R) { return mode_stiffness(law, 0, R, 2).v_x; };
        EXPECT_NEAR(shear(1), 1, 1e-12); // G_s
        EXPECT_NEAR(shear(1 + 0.99e-3), shear(1 + 1.01e-3), 1e-4);
        EXPECT_NEAR(shear(1 - 0.99e-3), shear(1 - 1.01e-3), 1e-4);
    }
}

TEST(ModeStiffness, TranslationOfTheTubeCostsNothing)
{
    // n = 1, W = -V is a translation across the axis.
    for (const Material& law : all_laws) {
        const ModeStiffness k = mode_stiffness(law, 0.02, 0.95, 1);
        EXPECT_NEAR(k.w - 2 * k.wv + k.v, 0, 1e-12);
    }
}

TEST(ModeStiffness, RadiusAndPressureAreInverse)
{
    for (const Material& law : all_laws)
        for (const Real R : {0.8, 0.97, 1.0, 1.05})
            EXPECT_NEAR(radius_at(law, 0.01, pressure_at(law, 0.01, R)), R, 1e-10);
    EXPECT_TRUE(std::isnan(radius_at(NeoHookean{1}, 0, 1.1))); // beyond the largest pressure
}

} // namespace
} // namespace starling
