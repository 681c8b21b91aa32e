#include "wall/mesh_filter.hpp"

#include <gtest/gtest.h>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

constexpr Real dt = 0.01, strength = 0.5; // share removed per step

struct Filter : testing::Test {
    Tube tube = make_tube(support::short_tube(), 0.1);
    WallState wall{tube};
    Geometry geometry{tube.mesh};

    void add_velocity(WallState& to, Real rate)
    {
        geometry.update(to.x);
        MeshFilter(tube, rate).add_velocity(geometry, to, dt);
    }
    /// Radial displacements d(ring, position in the ring) of the moving vertices.
    template <class F>
    void displace(F d)
    {
        for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) {
            const Vec3& X = tube.X[static_cast<std::size_t>(v)];
            const Real size = d(v / tube.ring_size, v % tube.ring_size);
            wall.x[v] = X + size * Vec3{0, X.y, X.z};
        }
    }
    /// Largest velocity the filter adds at rings at least `margin` rings off the clamps, times dt.
    Real change(Index margin = 1)
    {
        WallState moved = wall;
        add_velocity(moved, strength / dt);
        Real most = 0;
        const auto first = tube.first(tube.clamp_in + margin),
                   last = tube.first(tube.clamp_out - margin + 1);
        for (VertexIndex v = first; v < last; ++v)
            most = std::max(most, dt * norm(moved.velocity[v] - wall.velocity[v]));
        return most;
    }
};

TEST_F(Filter, LeavesTheUndeformedWallAlone) { EXPECT_EQ(change(), 0); }

TEST_F(Filter, LeavesAUniformDisplacementAloneAwayFromTheClamps)
{
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v)
        wall.x[v] += Vec3{0, 0.3, -0.2};
    EXPECT_LT(change(5), 1e-15);
}

TEST_F(Filter, LeavesWavesThatTheFluidSeesAlone)
{
    // four spacings or more long: (1 - cos) of the wave number to the fourth power
    const auto wave = [this](Real rings) {
        displace([=](Index ring, Index) {
            return 0.1 * std::cos(2 * pi * static_cast<Real>(ring) / rings);
        });
        return change(5) / 0.1;
    };
    EXPECT_LT(wave(20), 3e-6);
    EXPECT_LT(wave(40), 2e-8);
}

TEST_F(Filter, RemovesTheZigZagOfRings)
{
    displace([](Index ring, Index) { return ring % 2 ? 0.01 : -0.01; });
    // on the triangles a zig-zag of rings has 4 of 6 neighbours opposite: L d = 4/3 d
    const Real response = std::pow(4. / 3 / 1.5, 4);
    EXPECT_NEAR(change(5) / (strength * 0.01), response, 0.003); // radial directions differ
}

TEST_F(Filter, NeverOvershoots)
{
    support::shake(tube, wall.x, 0.01);
    const auto energy = [this](const WallState& w) {
        Real sum = 0;
        for (Index v = 0; v < w.x.size(); ++v) {
            const Vec3 d = w.x[v] - tube.X[static_cast<std::size_t>(v)];
            sum += dot(d, d);
        }
        return sum;
    };
    MeshFilter filter(tube, 1 / dt);
    for (int n = 0; n < 5; ++n) {
        const Real before = energy(wall);
        wall.velocity.fill({});
        geometry.update(wall.x);
        filter.add_velocity(geometry, wall, dt);
        wall.move(tube, dt);
        EXPECT_LT(energy(wall), before);
    }
}

TEST_F(Filter, MovesNoVolumeInFolds)
{
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) {
        const Vec3& X = tube.X[static_cast<std::size_t>(v)];
        const Real share = (X.x - tube.x_clamp_in()) / (tube.x_clamp_out() - tube.x_clamp_in());
        const Real along = std::sin(pi * share) * std::sin(pi * share);
        const Real fold = 0.1 * along * std::cos(10 * std::atan2(X.z, X.y));
        wall.x[v] = X + fold * Vec3{0, X.y, X.z};
    }
    add_velocity(wall, strength / dt);
    HighPass waves(tube.mesh, tube.moving_begin(), tube.moving_end(), HighPass::Beyond::as_zero);
    for (VertexIndex v = waves.first(); v < waves.last(); ++v) {
        const Vec3 d = wall.x[v] - tube.X[static_cast<std::size_t>(v)];
        waves.values()[v - waves.first()] = {d.y, d.z};
    }
    waves.apply();
    Real moved = 0, by_waves = 0;
    for (VertexIndex v = waves.first(); v < waves.last(); ++v) {
        const Vec3& A = geometry.vertex_area()[v];
        const Across& d = waves.values()[v - waves.first()];
        moved += dt / strength * dot(A, wall.velocity[v]);
        by_waves -= A.y * d.y + A.z * d.z;
    }
    EXPECT_GT(std::abs(by_waves), 1e-4); // if it were not given back
    EXPECT_LT(std::abs(moved), 1e-3 * std::abs(by_waves));
}

TEST_F(Filter, NeverMovesTheRigidParts)
{
    support::shake(tube, wall.x, 0.05);
    add_velocity(wall, strength / dt);
    for (VertexIndex v = 0; v < tube.mesh.vertex_count(); ++v)
        if (v < tube.moving_begin() || v >= tube.moving_end()) {
            EXPECT_EQ(wall.velocity[v], Vec3{});
        }
}

TEST_F(Filter, KeepsVerticesAtTheirX)
{
    wall.x = support::positions(tube, support::random_smooth(1, 0.4));
    add_velocity(wall, strength / dt);
    for (const Vec3& U : wall.velocity) EXPECT_EQ(U.x, 0);
}

TEST(MeshFilter, HasNothingToDoOnARigidTube)
{
    const Tube tube = make_tube({.length = 2, .rigid = true}, 0.3);
    WallState wall(tube);
    Geometry geometry(tube.mesh);
    geometry.update(wall.x);
    MeshFilter(tube, 0.5).add_velocity(geometry, wall, 0.01);
    for (const Vec3& U : wall.velocity) EXPECT_EQ(U, Vec3{});
}

} // namespace
} // namespace starling
