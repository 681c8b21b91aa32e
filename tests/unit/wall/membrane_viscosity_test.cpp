#include "wall/membrane_viscosity.hpp"

#include <gtest/gtest.h>

#include <omp.h>

#include <algorithm>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

constexpr Real mu_s = 3, nu_s = 0.4;

struct ViscousWall : testing::Test {
    Tube tube = make_tube(support::short_tube(), 0.3);
    Array<Vec3> x = support::positions(tube, support::random_smooth(1, 0.5)), U{x.size()};

    ViscousWall()
    {
        support::shake(tube, x, 0.03);
        for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v)
            U[v] = {std::sin(0.7 * v), std::sin(1.3 * v), std::cos(0.9 * v)};
    }
    static Array<Vec3> force(const Tube& tube, const Array<Vec3>& x, const Array<Vec3>& U)
    {
        Array<Vec3> f(x.size());
        MembraneViscosity(tube, mu_s, nu_s).add(x, U, f);
        return f;
    }
    static Real largest(const Array<Vec3>& f)
    {
        Real m = 0;
        for (const Vec3& a : f) m = std::max(m, norm(a));
        return m;
    }
};

TEST_F(ViscousWall, FeelsNothingAtRestNorInRigidMotion)
{
    const Real scale = largest(force(tube, x, U));
    EXPECT_GT(scale, 1);
    const Vec3 omega{0.3, -1, 2};
    for (Index v = 0; v < x.size(); ++v) U[v] = cross(omega, x[v]) + Vec3{1, 4, -2};
    EXPECT_LT(largest(force(tube, x, U)), 1e-12 * scale);
    EXPECT_LT(MembraneViscosity(tube, mu_s, nu_s).dissipation(x, U), 1e-24 * scale);
    for (Vec3& u : U) u = {};
    EXPECT_EQ(largest(force(tube, x, U)), 0);
}

TEST_F(ViscousWall, DissipatesWhatItsForcesTake)
{
    const MembraneViscosity model(tube, mu_s, nu_s);
    const Array<Vec3> f = force(tube, x, U);
    Real power = 0;
    for (Index v = 0; v < f.size(); ++v) power += dot(f[v], U[v]);
    EXPECT_LT(power, 0);
    EXPECT_NEAR(model.dissipation(x, U), -power, 1e-12 * -power);
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) { // one at a time
        Array<Vec3> one(x.size());
        one[v] = U[v];
        EXPECT_GT(model.dissipation(x, one), 0) << v;
    }
}

TEST_F(ViscousWall, HasNoNetForceAndNoNetTorque)
{
    const Array<Vec3> f = force(tube, x, U);
    Vec3 total, torque;
    for (Index v = 0; v < f.size(); ++v) {
        total += f[v];
        torque += cross(x[v], f[v]);
    }
    EXPECT_LT(norm(total), 1e-12 * largest(f));
    EXPECT_LT(norm(torque), 1e-12 * largest(f));
}

TEST_F(ViscousWall, IsLinearInTheVelocityAndFallsToNothingWithIt)
{
    const Array<Vec3> f = force(tube, x, U);
    for (Real factor : {-1., 1e-3, 1e-9}) {
        Array<Vec3> slow = U;
        for (Vec3& u : slow) u *= factor;
        const Array<Vec3> g = force(tube, x, slow);
        for (Index v = 0; v < f.size(); ++v)
            EXPECT_LT(norm(g[v] - factor * f[v]), 1e-12 * std::abs(factor) * largest(f));
    }
}

/// Relative error of the radial force on a ring of the tube that inflates through radius R at the
/// rate V: the hoop tension is 2 mu_s (1 + chi) V/R = 2 mu_s/(1 - nu_s) V/R.
Real ring_force_error(Real edge, Real R, Real V)
{
    const Tube tube = make_tube(support::short_tube(), edge);
    Array<Vec3> x = WallState(tube).x, U(x.size());
    for (Index v = 0; v < x.size(); ++v) {
        U[v] = V * Vec3{0, x[v].y, x[v].z};
        x[v] = {x[v].x, R * x[v].y, R * x[v].z};
    }
    const Array<Vec3> f = ViscousWall::force(tube, x, U);
    const Index ring = (tube.clamp_in + tube.clamp_out) / 2;
    const auto r = static_cast<std::size_t>(ring);
    Real radial = 0;
    for (VertexIndex v = tube.first(ring); v < tube.first(ring + 1); ++v)
        radial += (f[v].y * x[v].y + f[v].z * x[v].z) / R;
    const Real tension = 2 * mu_s / (1 - nu_s) * V / R;
    return radial / (-2 * pi * tension * (tube.ring_x[r + 1] - tube.ring_x[r])) - 1;
}

TEST_F(ViscousWall, InflatingRingCarriesItsViscousHoopTension)
{
    // second order in the edge
    for (Real R : {0.8, 1., 1.5})
        for (Real edge : {0.2, 0.1, 0.05})
            EXPECT_LT(std::abs(ring_force_error(edge, R, 0.7)), 0.3 * edge * edge)
                << R << " " << edge;
}

TEST_F(ViscousWall, DoesNotDependOnThreads)
{
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const Array<Vec3> one = force(tube, x, U);
    omp_set_num_threads(2);
    const Array<Vec3> two = force(tube, x, U);
    omp_set_num_threads(before);
    EXPECT_TRUE(std::ranges::equal(one, two));
}

TEST_F(ViscousWall, IsNothingWithoutViscosityOrInARigidTube)
{
    Array<Vec3> f(x.size());
    MembraneViscosity(tube, 0, nu_s).add(x, U, f);
    EXPECT_EQ(largest(f), 0);
    EXPECT_EQ(MembraneViscosity(tube, 0, nu_s).dissipation(x, U), 0);
    const Tube rigid = make_tube({.length = 2, .rigid = true}, 0.3);
    const Array<Vec3> at_rest = WallState(rigid).x;
    EXPECT_EQ(largest(force(rigid, at_rest, at_rest)), 0);
}

} // namespace
} // namespace starling
