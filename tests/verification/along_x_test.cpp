/// Walls whose properties vary along x, against the one-dimensional model.
#include <gtest/gtest.h>

#include "simulation/simulation.hpp"
#include "theory/one_dimensional.hpp"

namespace starling {
namespace {

Case low_re_tube(Real length, Real spacing)
{
    Case c;
    c.tube.length = length;
    c.grid.spacing = spacing;
    c.grid.width_y = c.grid.width_z = 4.4;
    c.drive.pressure_inlet = c.baseline_pressure_drop();
    return c;
}

OneDimensionalTube model_of(const Case& c)
{
    return solve_one_dimensional({c.tube, c.material, c.fluid, c.drive});
}

/// Steps until t.
Simulation run_to(const Case& c, Real t)
{
    Simulation s(c);
    while (s.time() < t) s.step(t);
    return s;
}

Real flow_through_rigid_tube(Case c, Real change)
{
    c.tube.rigid = true;
    c.tube.rest_radius = {
        .shape = AlongX::Shape::bump, .position = 3.5, .length = 6, .change = change};
    return run_to(c, 1.5).sample().Q_mid;
}

class Bump : public testing::TestWithParam<Real> {};

// What a circle on this grid does to any tube drops out of the ratio, but for R^4 at the throat.
TEST_P(Bump, OfARigidTubeLetsThroughWhatLubricationTheorySays)
{
    Case c = low_re_tube(7, 0.125);
    const Real found = flow_through_rigid_tube(c, GetParam()) / flow_through_rigid_tube(c, 0);
    c.tube.rigid = true;
    const Real straight = model_of(c).Q;
    c.tube.rest_radius = {
        .shape = AlongX::Shape::bump, .position = 3.5, .length = 6, .change = GetParam()};
    const Real expected = model_of(c).Q / straight;
    RecordProperty("expected", std::to_string(expected));
    RecordProperty("error_percent", std::to_string(100 * (found / expected - 1)));
    EXPECT_NEAR(found, expected, 0.02 * expected);
}

INSTANTIATE_TEST_SUITE_P(StenosisAndAneurysm, Bump, testing::Values(-0.2, 0.2));

TEST(Stiffness, TwiceAsHighDownstreamInflatesEachPartAsTheModelSays)
{
    Case c = low_re_tube(8, 0.2);
    c.tube.rigid_inlet = c.tube.rigid_outlet = 0.8;
    c.material.stiffness = {
        .shape = AlongX::Shape::step, .position = 4, .length = 0.5, .change = 1};
    c.drive.pressure_outlet = 0.5 * c.drive.pressure_inlet; // so that both parts widen
    c.drive.pressure_inlet *= 1.5;
    const OneDimensionalTube model = model_of(c);
    Simulation s = run_to(c, 5);
    Real worst = 0, before = 0, behind = 0;
    for (const ProfileRow& row : s.profile()) {
        const bool flat = std::abs(row.x - 2.4) < 0.7 || std::abs(row.x - 5.6) < 0.7;
        if (!flat) continue;
        const Real expected = model.R_at(row.x) - 1;
        worst = std::max(worst, std::abs((row.R_mean - 1) / expected - 1));
        (row.x < 4 ? before : behind) = row.R_mean - 1;
    }
    RecordProperty("worst_percent", std::to_string(100 * worst));
    RecordProperty("displacements", std::to_string(before) + " " + std::to_string(behind));
    EXPECT_LT(worst, 0.02);
    EXPECT_GT(before, 1.8 * behind);
}

} // namespace
} // namespace starling
