#include "wall/smoothing.hpp"

#include <gtest/gtest.h>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

constexpr Real alpha = 0.3;
const TubeParameters long_tube{.length = 6, .rigid_inlet = 0.8, .rigid_outlet = 0.7};

/// Wall velocity that smoothing adds at the positions x.
Array<Vec3> velocity(const Tube& tube, const Array<Vec3>& x, Real strength = alpha)
{
    WallState wall(tube);
    wall.x = x;
    Geometry geometry(tube.mesh);
    geometry.update(x);
    SurfaceSmoothing(tube, strength).add_velocity(geometry, wall);
    return wall.velocity;
}

TEST(SurfaceSmoothing, LeavesTheUndeformedWallAloneToTheLastBit)
{
    const Tube tube = make_tube(support::short_tube(), 0.2);
    for (const Vec3& U : velocity(tube, WallState(tube).x)) EXPECT_EQ(U, Vec3{});
}

// kappa of r = 1 + a cos(n theta) cos(q x) is 1/2 + a/2 (n^2 - 1 + q^2) cos cos, so that the wave
// shrinks at the rate alpha/2 (n^2 + q^2)(n^2 - 1 + q^2): with the printed sign it would grow.
TEST(SurfaceSmoothing, ShrinksAWaveAtItsRate)
{
    constexpr Real a = 1e-5, q = 1.5;
    constexpr int n = 3;
    const Real rate = alpha / 2 * (n * n + q * q) * (n * n - 1 + q * q);
    const auto error = [&](Real edge) {
        const Tube tube = make_tube(long_tube, edge);
        const auto wave = [&](const Vec3& p) {
            return a * std::cos(n * std::atan2(p.z, p.y)) * std::cos(q * p.x);
        };
        Array<Vec3> x = WallState(tube).x;
        for (Vec3& p : x) p += wave(p) * Vec3{0, p.y, p.z};
        const Array<Vec3> U = velocity(tube, x);
        Real most = 0;
        for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) {
            const Vec3& X = tube.X[static_cast<std::size_t>(v)];
            if (X.x < 2 || X.x > 4) continue;
            most = std::max(most, std::abs(U[v].y * X.y + U[v].z * X.z + rate * wave(X)));
        }
        return most / (rate * a);
    };
    const Real coarse = error(0.1), fine = error(0.05);
    EXPECT_LT(coarse, 0.06);
    EXPECT_LT(fine, coarse / 3.2);
}

TEST(SurfaceSmoothing, MovesTheSurfaceAlongItsNormalAcrossX)
{
    const Tube tube = make_tube(support::short_tube(), 0.2);
    const Array<Vec3> x = support::positions(tube, support::random_smooth(1, 0.4));
    Geometry geometry(tube.mesh);
    geometry.update(x);
    const Array<Vec3> U = velocity(tube, x), twice = velocity(tube, x, 2 * alpha);
    Real most = 0;
    for (VertexIndex v = 0; v < tube.mesh.vertex_count(); ++v) {
        const Vec3 a = geometry.vertex_area()[v];
        EXPECT_EQ(U[v].x, 0);
        EXPECT_NEAR(U[v].y * a.z - U[v].z * a.y, 0, 1e-12 * (1 + norm(U[v])));
        EXPECT_LT(norm(twice[v] - 2 * U[v]), 1e-12 * (1 + norm(U[v])));
        if (v < tube.moving_begin() || v >= tube.moving_end()) {
            EXPECT_EQ(U[v], Vec3{});
        }
        most = std::max(most, norm(U[v]));
    }
    EXPECT_GT(most, 0.1);
}

TEST(SurfaceSmoothing, LetsNoWaveGrowAtTheLimitOfItsStep)
{
    constexpr Real edge = 0.2, dt = 0.4 * edge * edge * edge * edge / alpha;
    const Tube tube = make_tube(support::short_tube(), edge);
    WallState wall(tube);
    Array<Vec3> noise = wall.x;
    support::shake(tube, noise, 1e-4);
    const auto size = [&] {
        Real sum = 0;
        for (Index v = 0; v < wall.x.size(); ++v)
            sum += dot(wall.x[v] - tube.X[static_cast<std::size_t>(v)],
                       wall.x[v] - tube.X[static_cast<std::size_t>(v)]);
        return sum;
    };
    for (Index v = 0; v < noise.size(); ++v) wall.x[v] = {wall.x[v].x, noise[v].y, noise[v].z};
    SurfaceSmoothing smoothing(tube, alpha);
    Geometry geometry(tube.mesh);
    const Real before = size();
    for (int step = 0; step < 300; ++step) {
        geometry.update(wall.x);
        wall.velocity.fill({});
        smoothing.add_velocity(geometry, wall);
        wall.move(tube, dt);
    }
    EXPECT_LT(size(), before);
}

TEST(SurfaceSmoothing, DoesNothingWithoutAlphaAndOnARigidTube)
{
    const Tube tube = make_tube(support::short_tube(), 0.3);
    const Array<Vec3> x = support::positions(tube, support::lobed(2, 0.3));
    for (const Vec3& U : velocity(tube, x, 0)) EXPECT_EQ(U, Vec3{});
    const Tube rigid = make_tube({.length = 2, .rigid = true}, 0.3);
    for (const Vec3& U : velocity(rigid, WallState(rigid).x)) EXPECT_EQ(U, Vec3{});
}

} // namespace
} // namespace starling
