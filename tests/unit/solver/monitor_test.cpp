#include "solver/monitor.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "unit/grid/random_fields.hpp"
#include "unit/solver/coupled.hpp"

namespace starling {
namespace {

using support::Coupled;
using support::CoupledParameters;

struct Monitored : testing::Test {
    Coupled c{CoupledParameters{.spacing = 0.25}};
    Monitor monitor{c.g, c.op, Coupled::fluid, {}};

    template <class F>
    void fill(Location where, ScalarField& field, F f)
    {
        support::visit(
            {{-1, -1, -1}, {c.g.nx() + 2, c.g.ny() + 1, c.g.nz() + 1}},
            [&](Index i, Index j, Index k) { field(i, j, k) = f(c.g.position(where, i, j, k)); });
    }
    /// 2 (1 - r^2), continued oddly near the wall.
    void fill_poiseuille()
    {
        fill(Location::u, c.s.fluid.u[Location::u], [](const Vec3& p) {
            const Real r = std::min(std::hypot(p.y, p.z), 1.5);
            return r < 1 ? 2 * (1 - r * r) : -2 * (1 - (2 - r) * (2 - r));
        });
    }
    Real gap_of(const support::Shape& shape)
    {
        c.s.wall.x = support::positions(c.tube, shape);
        return monitor.sample(c.s).smallest_gap;
    }
};

TEST_F(Monitored, SampleOfTheUndeformedTubeAtRest)
{
    const Sample a = monitor.sample(c.s);
    EXPECT_EQ(a.t, 0);
    EXPECT_EQ(a.step, 0);
    EXPECT_EQ(a.dt, c.s.dt);
    for (Real zero : {a.Q_in, a.Q_mid, a.Q_out, a.Q_exterior, a.dV_dt, a.leak, a.kinetic_energy,
                      a.largest_displacement, a.cfl})
        EXPECT_EQ(zero, 0);
    EXPECT_NEAR(a.volume, 4 * pi, 0.1);
    EXPECT_NEAR(a.R_max, 1, 1e-14);
    EXPECT_NEAR(a.R_min, 1, 1e-14);
    EXPECT_NEAR(a.elastic_energy, 0, 1e-11);
    EXPECT_NEAR(a.max_strain, 0, 1e-14);
    EXPECT_NEAR(a.smallest_gap, 2, 1e-13);
}

TEST_F(Monitored, GapIsTheWidthOfTheLumen)
{
    EXPECT_NEAR(gap_of(support::inflated(-0.4)), 1.2, 0.03);
    EXPECT_NEAR(gap_of(support::dumbbell(0.25)), 0.5, 0.04);
    EXPECT_NEAR(gap_of(support::dumbbell(0.1)), 0.2, 0.04);
    // r = 1 + 0.3 cos 2 theta: 1.4 across the waist
    EXPECT_NEAR(gap_of(support::lobed(2, 0.3, 0)), 1.4, 0.04);
}

TEST_F(Monitored, RadiiOfAnInflatedTube)
{
    c.s.wall.x = support::positions(c.tube, support::inflated(0.5));
    const Sample a = monitor.sample(c.s);
    EXPECT_NEAR(a.R_max, 1.5, 0.01);
    EXPECT_NEAR(a.x_R_max, (0.8 + 3.3) / 2, 0.1);
    EXPECT_NEAR(a.R_min, 1, 1e-14);
    EXPECT_NEAR(a.largest_displacement, a.R_max - 1, 1e-13);
    EXPECT_GT(a.max_strain, 0.45);
    EXPECT_GT(a.elastic_energy, 0);
}

TEST_F(Monitored, NarrowestSectionHasItsAreaPlaceAndLobes)
{
    const Sample round = monitor.sample(c.s);
    EXPECT_NEAR(round.min_area_ratio, 1, 1e-12);
    EXPECT_EQ(round.lobes, 0);
    c.s.wall.x = support::positions(c.tube, support::dumbbell(0.2));
    const Sample narrow = monitor.sample(c.s);
    EXPECT_EQ(narrow.lobes, 2);
    EXPECT_NEAR(narrow.x_min_area, (c.tube.x_clamp_in() + c.tube.x_clamp_out()) / 2, 0.1);
    Real least = 1;
    for (const ProfileRow& row : monitor.profile(c.s)) least = std::min(least, row.area / pi);
    EXPECT_NEAR(narrow.min_area_ratio, least, 0.02);
    EXPECT_LT(least, 0.8);
}

TEST_F(Monitored, ProfileHasTheShapeOfEverySection)
{
    c.s.wall.x = support::positions(c.tube, support::lobed(3, 0.3));
    const std::vector<ProfileRow> rows = monitor.profile(c.s);
    const ProfileRow &rigid = rows.front(), &middle = rows[rows.size() / 2];
    EXPECT_EQ(rigid.lobes, 0);
    EXPECT_NEAR(rigid.mode_3, 0, 1e-12);
    EXPECT_NEAR(rigid.gap, 2, 1e-12);
    EXPECT_EQ(middle.lobes, 3);
    EXPECT_NEAR(middle.mode_3, 0.3, 0.02);
    EXPECT_NEAR(middle.mode_2, 0, 1e-12);
}

TEST_F(Monitored, SectionsAreTheRings)
{
    c.s.wall.x = support::positions(c.tube, support::dumbbell(0.2));
    const std::vector<SectionPoint> points = monitor.sections(c.s);
    ASSERT_EQ(points.size(), c.tube.X.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
        const Vec3& p = c.s.wall.x[static_cast<Index>(v)];
        EXPECT_EQ(points[v].x, p.x);
        EXPECT_EQ(points[v].y, p.y);
        EXPECT_EQ(points[v].z, p.z);
        EXPECT_NEAR(std::cos(points[v].theta), c.tube.X[v].y, 1e-14);
    }
}

TEST_F(Monitored, FlowRatesOfPoiseuilleFlow)
{
    fill_poiseuille();
    c.s.dt = 0.01;
    const Sample a = monitor.sample(c.s);
    for (Real Q : {a.Q_in, a.Q_mid, a.Q_out}) EXPECT_NEAR(Q, pi, 0.03 * pi);
    EXPECT_NEAR(a.leak, 0, 0.01);
    EXPECT_NEAR(a.cfl, 0.01 * 2 / c.g.spacing().x, 0.03 * a.cfl);
}

// The volume is a cubic in time while vertices move uniformly: Simpson's rule is exact.
TEST_F(Monitored, VolumeRateIsTheChangeOfVolumeOverTheStep)
{
    ASSERT_TRUE(c.run(4));
    const Real before = monitor.sample(c.s).volume;
    ASSERT_TRUE(c.run(1));
    const Sample after = monitor.sample(c.s);
    EXPECT_GT(std::abs(after.volume - before), 1e-4);
    EXPECT_NEAR(after.dV_dt * c.s.fluid.dt_before, after.volume - before, 1e-12);
    EXPECT_DOUBLE_EQ(after.leak, after.dV_dt - (after.Q_in - after.Q_out));
}

TEST_F(Monitored, SampleDoesNotChangeTheRun)
{
    Coupled other(CoupledParameters{.spacing = 0.25});
    for (int n = 0; n < 3; ++n) {
        ASSERT_TRUE(c.run(1));
        ASSERT_TRUE(other.run(1));
        monitor.sample(c.s);
        monitor.profile(c.s);
    }
    EXPECT_TRUE(std::ranges::equal(c.s.wall.x, other.s.wall.x));
}

TEST_F(Monitored, ProfileOfPoiseuilleFlow)
{
    fill_poiseuille();
    fill(Location::cell, c.s.fluid.P,
         [](const Vec3& p) { return (std::hypot(p.y, p.z) < 1 ? 10 : 4) - 0.5 * p.x; });
    const std::vector<ProfileRow> rows = monitor.profile(c.s);
    ASSERT_EQ(rows.size(), c.tube.ring_x.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const ProfileRow& a = rows[r];
        EXPECT_EQ(a.x, c.tube.ring_x[r]);
        for (Real R : {a.R_mean, a.R_min, a.R_max}) EXPECT_NEAR(R, 1, 1e-14);
        EXPECT_NEAR(a.area, pi, 0.02);
        EXPECT_NEAR(a.P_centre, 10 - 0.5 * a.x, 1e-12);
        EXPECT_NEAR(a.P_transmural, 6, 0.01);
        EXPECT_NEAR(a.Q, pi, 0.03 * pi);
    }
}

const NamedArray& named(const std::vector<NamedArray>& arrays, const std::string& name)
{
    for (const NamedArray& a : arrays)
        if (a.name == name) return a;
    throw std::out_of_range(name);
}

TEST_F(Monitored, WallSnapshotHasTheShearStressOfPoiseuilleFlow)
{
    fill_poiseuille();
    Array<Vec3> f(c.s.wall.x.size());
    const WallSnapshot a = monitor.wall(c.s, f);
    // mu du/dr = 4/Re at the wall; exact for a parabola but for the trilinear interpolation
    for (Real tau : named(a.at_vertex, "wall_shear_stress").values)
        EXPECT_NEAR(tau, 4 / Coupled::reynolds, 0.08 * 4 / Coupled::reynolds);
}

TEST_F(Monitored, WallSnapshotHasTheStretchesOfAnInflatedTube)
{
    for (Vec3& x : c.s.wall.x) x = {x.x, 1.5 * x.y, 1.5 * x.z};
    Array<Vec3> f(c.s.wall.x.size());
    const WallSnapshot a = monitor.wall(c.s, f);
    EXPECT_EQ(a.points.size(), c.tube.X.size());
    EXPECT_EQ(a.triangles, c.tube.mesh.elements());
    const Tensions tau = NeoHookean{1 / (0.1 * 0.02)}.tensions(1.5, 1.);
    for (Real l : named(a.at_element, "lambda1").values) EXPECT_NEAR(l, 1.5, 1e-6);
    for (Real l : named(a.at_element, "lambda2").values) EXPECT_NEAR(l, 1, 0.01);
    for (Real t : named(a.at_element, "tau1").values) EXPECT_NEAR(t, tau.tau1, 0.02 * tau.tau1);
    const auto& d = named(a.at_vertex, "displacement").values;
    for (std::size_t v = 0; v < c.tube.X.size(); ++v) {
        EXPECT_EQ(d[3 * v], 0);
        EXPECT_NEAR(std::hypot(d[3 * v + 1], d[3 * v + 2]), 0.5, 1e-6);
    }
}

TEST_F(Monitored, FluidSnapshotAveragesFacesToCells)
{
    const auto f = [](const Vec3& p) { return 1 + p.x + 2 * p.y - p.z; };
    for (Location d : components) fill(d, c.s.fluid.u[d], f);
    fill(Location::cell, c.s.fluid.P, f);
    const FluidSnapshot a = monitor.fluid(c.s);
    std::size_t n = 0;
    support::visit(c.g.unknowns(Location::cell), [&](Index i, Index j, Index k) {
        const Real expected = f(c.g.position(Location::cell, i, j, k));
        EXPECT_NEAR(named(a.at_cell, "pressure").values[n], expected, 1e-5);
        for (std::size_t d = 0; d < 3; ++d)
            EXPECT_NEAR(named(a.at_cell, "velocity").values[3 * n + d], expected, 1e-5);
        ++n;
    });
    EXPECT_EQ(n, named(a.at_cell, "pressure").values.size());
}

TEST_F(Monitored, SpeedCheckFindsTheLargestComponentOverItsSpacing)
{
    VectorField u(c.g);
    u[Location::u](3, 4, 5) = -2;
    u[Location::w](1, 2, 0) = 1.5;
    const SpeedCheck check = check_speed(c.g, u, 0.1);
    EXPECT_EQ(check.u_max, 2);
    EXPECT_DOUBLE_EQ(check.cfl, 0.1 * 2 / c.g.spacing().x);
}

TEST_F(Monitored, SpeedCheckFindsASingleValueThatIsNotFinite)
{
    for (Location d : components)
        for (Real bad :
             {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity()}) {
            VectorField u(c.g);
            const Box b = c.g.unknowns(d);
            u[d](b.end[0] - 1, b.begin[1], b.end[2] - 1) = bad;
            EXPECT_TRUE(std::isnan(check_speed(c.g, u, 0.1).u_max));
            EXPECT_TRUE(std::isnan(check_speed(c.g, u, 0.1).cfl));
        }
}

} // namespace
} // namespace starling
