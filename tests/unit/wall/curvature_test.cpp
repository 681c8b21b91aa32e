#include "wall/curvature.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

const TubeParameters long_tube{.length = 6, .rigid_inlet = 0.8, .rigid_outlet = 0.7};

/// Vertices at least a quarter of the tube away from its ends.
template <class F>
void for_middle(const Tube& tube, F f)
{
    for (VertexIndex v = 0; v < tube.mesh.vertex_count(); ++v) {
        const Real s = tube.X[static_cast<std::size_t>(v)].x / tube.ring_x.back();
        if (s > 0.25 && s < 0.75) f(v);
    }
}

/// All vertices but those of the first and last `rings` rings.
VertexRange inner(const Tube& tube, Index rings)
{
    return {tube.first(rings), tube.first(tube.rings() - rings)};
}

Real angle(const Vec3& a) { return std::atan2(a.z, a.y); }

/// Surface r(theta, x) around the axis with its exact curvatures.
struct Surface {
    std::string name;
    /// r and its derivatives r_t, r_x, r_tt, r_tx, r_xx.
    std::function<std::array<Real, 6>(Real theta, Real x)> r;

    Array<Vec3> positions(const Tube& tube) const
    {
        Array<Vec3> x = WallState(tube).x;
        for (Vec3& p : x) {
            const Real radius = r(angle(p), p.x)[0];
            p = {p.x, radius * p.y, radius * p.z};
        }
        return x;
    }
    Curvatures curvatures(const Vec3& p) const
    {
        const Real theta = angle(p);
        const auto [R, t, x, tt, tx, xx] = r(theta, p.x);
        const Vec3 e_r{0, std::cos(theta), std::sin(theta)}, e_t{0, -e_r.z, e_r.y};
        const Vec3 X_t = t * e_r + R * e_t, X_x = x * e_r + Vec3{1, 0, 0};
        const Vec3 X_tt = (tt - R) * e_r + 2 * t * e_t, X_tx = tx * e_r + x * e_t, X_xx = xx * e_r;
        const Vec3 normal = cross(X_t, X_x) * (-1 / norm(cross(X_t, X_x)));
        const Vec3 n = dot(normal, e_r) > 0 ? normal : -normal;
        const Real E = dot(X_t, X_t), F = dot(X_t, X_x), G = dot(X_x, X_x), det = E * G - F * F;
        const Real L = dot(X_tt, n), M = dot(X_tx, n), N = dot(X_xx, n);
        return {-(E * N - 2 * F * M + G * L) / (2 * det), (L * N - M * M) / det};
    }
};

void PrintTo(const Surface& s, std::ostream* out) { *out << s.name; }

Surface cylinder(Real radius)
{
    return {"Cylinder", [=](Real, Real) { return std::array<Real, 6>{radius, 0, 0, 0, 0, 0}; }};
}

Surface sphere(Real radius, Real centre)
{
    return {"Sphere", [=](Real, Real x) {
                const Real d = x - centre, r = std::sqrt(radius * radius - d * d);
                return std::array<Real, 6>{r, 0, -d / r, 0, 0, -radius * radius / (r * r * r)};
            }};
}

/// r = 1 + a cos(n theta) cos(q x).
Surface lobed(Real a, int n, Real q)
{
    return {"Lobes" + std::to_string(n), [=](Real theta, Real x) {
                const Real c = std::cos(n * theta), s = std::sin(n * theta);
                const Real cx = std::cos(q * x), sx = std::sin(q * x);
                return std::array<Real, 6>{1 + a * c * cx,     -a * n * s * cx,
                                           -a * q * c * sx,    -a * n * n * c * cx,
                                           a * n * q * s * sx, -a * q * q * c * cx};
            }};
}

struct CurvatureOn : testing::TestWithParam<Surface> {
    /// Largest errors of mean and Gaussian curvature in the middle of a tube.
    Curvatures error(Real edge) const
    {
        const Tube tube = make_tube(long_tube, edge);
        const Array<Vec3> x = GetParam().positions(tube);
        Geometry geometry(tube.mesh);
        geometry.update(x);
        CurvatureFit fit(tube.mesh, inner(tube, 1));
        fit.update(x, geometry);
        Curvatures most;
        for_middle(tube, [&](VertexIndex v) {
            const Curvatures exact = GetParam().curvatures(x[v]), found = fit.at_vertex()[v];
            most.mean = std::max(most.mean, std::abs(found.mean - exact.mean));
            most.gaussian = std::max(most.gaussian, std::abs(found.gaussian - exact.gaussian));
        });
        return most;
    }
};

TEST_P(CurvatureOn, ConvergesAtSecondOrder)
{
    const Curvatures coarse = error(0.1), fine = error(0.05);
    EXPECT_LT(coarse.mean, 0.02);
    EXPECT_LT(coarse.gaussian, 0.02);
    EXPECT_LT(fine.mean, coarse.mean / 3.2);
    EXPECT_LT(fine.gaussian, std::max(coarse.gaussian / 3.2, 1e-12));
}

const auto surface_name = [](const auto& surface) { return surface.param.name; };

INSTANTIATE_TEST_SUITE_P(Curvature, CurvatureOn,
                         testing::Values(cylinder(1.3), sphere(2.2, 3), lobed(0.2, 2, 1),
                                         lobed(0.1, 3, 2)),
                         surface_name);

/// Largest error of Lap_s phi = `exact` in the middle of a tube.
template <class Phi, class Exact>
Real laplacian_error(const Surface& surface, Real edge, Phi phi, Exact exact)
{
    const Tube tube = make_tube(long_tube, edge);
    const Array<Vec3> x = surface.positions(tube);
    Geometry geometry(tube.mesh);
    geometry.update(x);
    Array<Real> values(x.size()), laplacian(x.size());
    for (Index v = 0; v < x.size(); ++v) values[v] = phi(x[v]);
    SurfaceLaplacian(tube.mesh, inner(tube, 2), inner(tube, 1))
        .apply(x, geometry, values, laplacian);
    Real most = 0;
    for_middle(tube,
               [&](VertexIndex v) { most = std::max(most, std::abs(laplacian[v] - exact(x[v]))); });
    return most;
}

TEST(SurfaceLaplacian, ConvergesAtSecondOrderOnACylinder)
{
    constexpr Real R = 1.3, q = 1.5;
    const auto phi = [](const Vec3& p) { return std::cos(3 * angle(p)) * std::cos(q * p.x); };
    const auto error = [&](Real edge) {
        return laplacian_error(cylinder(R), edge, phi,
                               [&](const Vec3& p) { return -(9 / (R * R) + q * q) * phi(p); });
    };
    const Real coarse = error(0.1), fine = error(0.05);
    EXPECT_LT(coarse, 0.03 * (9 / (R * R) + q * q));
    EXPECT_LT(fine, coarse / 3.2);
}

TEST(SurfaceLaplacian, ConvergesAtSecondOrderOnASphere)
{
    // a spherical harmonic of degree 2: Lap_s phi = -6 phi/R^2
    constexpr Real R = 2.2, centre = 3;
    const auto phi = [](const Vec3& p) { return (p.x - centre) * p.y / (R * R); };
    const auto error = [&](Real edge) {
        return laplacian_error(sphere(R, centre), edge, phi,
                               [&](const Vec3& p) { return -6 * phi(p) / (R * R); });
    };
    const Real coarse = error(0.1), fine = error(0.05);
    EXPECT_LT(coarse, 0.02);
    EXPECT_LT(fine, coarse / 3.2);
}

TEST(SurfaceLaplacian, OfALinearFunctionInAPlaneVanishes)
{
    // the plane of the undeformed tube's parameters (x, theta), cut open
    const Tube tube = make_tube(long_tube, 0.3);
    Array<Vec3> x = WallState(tube).x;
    for (Vec3& p : x) p = {p.x, angle(p), 0.4 * p.x};
    Geometry geometry(tube.mesh);
    geometry.update(x);
    Array<Real> phi(x.size()), laplacian(x.size());
    for (Index v = 0; v < x.size(); ++v) phi[v] = 2 * x[v].x - 3 * x[v].y;
    SurfaceLaplacian(tube.mesh, inner(tube, 2), inner(tube, 1)).apply(x, geometry, phi, laplacian);
    for_middle(tube, [&](VertexIndex v) {
        if (std::abs(x[v].y) < 2) { // away from the cut
            EXPECT_NEAR(laplacian[v], 0, 1e-12);
        }
    });
}

TEST(Curvature, IsTheSameWhereverTheWallIsTurned)
{
    const Tube tube = make_tube(support::short_tube(), 0.2);
    const Array<Vec3> x = support::positions(tube, support::random_smooth(1, 0.5));
    Array<Vec3> turned = x;
    for (Vec3& p : turned) p = support::rotated(p, {1, -2, 0.5}, 2.1) + Vec3{10, -3, 7};
    const auto curvatures = [&](const Array<Vec3>& positions) {
        Geometry geometry(tube.mesh);
        geometry.update(positions);
        CurvatureFit fit(tube.mesh, inner(tube, 1));
        fit.update(positions, geometry);
        return fit.at_vertex();
    };
    const Array<Curvatures> a = curvatures(x), b = curvatures(turned);
    for (Index v = 0; v < a.size(); ++v) {
        EXPECT_NEAR(a[v].mean, b[v].mean, 1e-11);
        EXPECT_NEAR(a[v].gaussian, b[v].gaussian, 1e-11);
    }
}

TEST(Curvature, NeedsInteriorVertices)
{
    const Tube tube = make_tube(support::short_tube(), 0.4);
    EXPECT_THROW(CurvatureFit(tube.mesh, inner(tube, 0)), std::invalid_argument);
    EXPECT_NO_THROW(CurvatureFit(tube.mesh, inner(tube, 1)));
}

TEST(Curvature, RangeOfTheBendingWallEndsWithTheClampsAndIsEmptyForARigidTube)
{
    const Tube tube = make_tube(support::short_tube(), 0.4);
    EXPECT_EQ(bending_range(tube).first, tube.moving_begin() - tube.ring_size);
    EXPECT_EQ(bending_range(tube).last, tube.moving_end() + tube.ring_size);
    const VertexRange rigid = bending_range(make_tube({.length = 2, .rigid = true}, 0.3));
    EXPECT_EQ(rigid.first, rigid.last);
}

} // namespace
} // namespace starling
