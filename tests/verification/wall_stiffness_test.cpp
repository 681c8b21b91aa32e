/// The triangulated wall against the linear theory of the continuous one: its forces under a small
/// mode of buckling are those of theory/mode_stiffness.hpp.
#include <gtest/gtest.h>

#include <array>

#include "theory/mode_stiffness.hpp"
#include "wall/bending_force.hpp"
#include "wall/elastic_force.hpp"
#include "wall/wall_state.hpp"

namespace starling {
namespace {

using Stiffness = std::array<std::array<Real, 2>, 2>;

constexpr Real E_b = 0.02; // G_s = 1
const TubeParameters tube_parameters{.length = 8, .rigid_inlet = 1, .rigid_outlet = 1};
constexpr Real deforming_length = 6;

/// sin^2(pi s/length) and its derivatives: leaves the clamps smoothly.
struct Fade {
    Real value, d1, d2;
    explicit Fade(Real s)
    {
        const Real k = 2 * pi / deforming_length;
        value = (1 - std::cos(k * s)) / 2;
        d1 = k * std::sin(k * s) / 2;
        d2 = k * k * std::cos(k * s) / 2;
    }
};

/// Displacement of unit amplitude: outward fade cos(n theta) (which = 0), or around fade
/// sin(n theta) (1).
Vec3 displacement(const Vec3& X, int n, int which)
{
    const Real theta = std::atan2(X.z, X.y), f = Fade(X.x - tube_parameters.rigid_inlet).value;
    return which == 0 ? f * std::cos(n * theta) * Vec3{0, X.y, X.z}
                      : f * std::sin(n * theta) * Vec3{0, -X.z, X.y};
}

/// Forces of the wall at rest moved by `amplitude` times the mode j, projected on the mode i.
Real projected_force(const Tube& tube, const Material& law, int n, int i, int j, Real amplitude)
{
    Array<Vec3> x = WallState(tube).x, f(x.size());
    const auto begin = tube.moving_begin(), end = tube.moving_end();
    const Array<Vec3> X = x;
    for (VertexIndex v = begin; v < end; ++v) x[v] += amplitude * displacement(X[v], n, j);
    Geometry geometry(tube.mesh);
    geometry.update(x);
    ElasticForce(tube, law).compute(x, f);
    HelfrichBending(tube, E_b).add(x, geometry, f);
    Real sum = 0;
    for (VertexIndex v = begin; v < end; ++v) sum += dot(f[v], displacement(X[v], n, i));
    return sum;
}

Stiffness of_triangles(const Material& law, int n, Real edge)
{
    constexpr Real a = 1e-5;
    const Tube tube = make_tube(tube_parameters, edge);
    Stiffness K{};
    for (const int i : {0, 1})
        for (const int j : {0, 1})
            K[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
                -(projected_force(tube, law, n, i, j, a) -
                  projected_force(tube, law, n, i, j, -a)) /
                (2 * a);
    return K;
}

Stiffness of_theory(const Material& law, int n)
{
    const ModeStiffness k = mode_stiffness(law, E_b, 1, n);
    constexpr int points = 64; // exact for these trigonometric functions
    Stiffness K{};
    for (int i = 0; i < points; ++i) {
        const Fade f((i + 0.5) / points * deforming_length);
        const Real weight = pi * deforming_length / points, f2 = f.value * f.value;
        K[0][0] += weight * (k.w_xx * f.d2 * f.d2 + k.w_x * f.d1 * f.d1 + k.w * f2);
        K[0][1] += weight * k.wv * f2;
        K[1][1] += weight * (k.v_x * f.d1 * f.d1 + k.v * f2);
    }
    K[1][0] = K[0][1];
    return K;
}

/// What resists w when v adjusts: the small difference that decides on buckling.
Real condensed(const Stiffness& K) { return K[0][0] - K[0][1] * K[1][0] / K[1][1]; }

TEST(WallStiffness, OfTheTrianglesConvergesToTheTheory)
{
    const Material law = Hooke{1, 0.3}; // at rest all laws are alike
    for (const int n : {2, 3}) {
        const Stiffness exact = of_theory(law, n);
        const Stiffness coarse = of_triangles(law, n, 0.2), fine = of_triangles(law, n, 0.1);
        const auto expect_second_order = [&](auto part) {
            const Real e = part(exact), error = std::abs(part(fine) / e - 1);
            EXPECT_LT(error, 0.035) << n;
            EXPECT_LT(error, std::abs(part(coarse) / e - 1) / 3.2) << n;
        };
        for (const std::size_t i : {0u, 1u})
            for (const std::size_t j : {0u, 1u})
                expect_second_order([&](const Stiffness& K) { return K[i][j]; });
        expect_second_order(condensed);
    }
}

} // namespace
} // namespace starling
