#include "theory/boundary_layer.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "theory/one_dimensional.hpp"

namespace starling {
namespace {

std::vector<Real> nodes(Real length, int intervals)
{
    std::vector<Real> x;
    for (int i = 0; i <= intervals; ++i) x.push_back(length * i / intervals);
    return x;
}

template <class F>
std::vector<Real> values(const std::vector<Real>& x, F f)
{
    std::vector<Real> y;
    for (const Real p : x) y.push_back(f(p));
    return y;
}

TEST(BoundaryLayer, PoiseuilleFlowStaysThroughACylinder)
{
    MarchedProfile p(0.3);
    for (int n = 0; n < 10; ++n) EXPECT_NEAR(p.advance(0.1, 0), 0, 1e-9);
    for (std::size_t j = 0; j < p.s().size(); ++j) EXPECT_NEAR(p.w()[j], 2 * (1 - p.s()[j]), 1e-9);
}

TEST(BoundaryLayer, InertiaOfASlenderTubeIsThatOfFirstOrder)
{
    const std::vector<Real> x = nodes(2000, 2000);
    const std::vector<Real> R =
        values(x, [](Real p) { return 1 + 0.2 * std::pow(std::sin(pi * p / 2000), 2); });
    const std::vector<Real> P = inertial_pressure(x, R, 1, 1);
    ASSERT_EQ(P.size(), x.size() + 1);
    const Real largest = 1 - std::pow(1.2, -4);
    for (std::size_t i = 0; i < x.size(); ++i)
        EXPECT_NEAR(P[i], 1 - std::pow(R[i], -4), 0.01 * largest);
}

TEST(BoundaryLayer, InertiaAloneIsBernoullisOnTheAxis)
{
    const std::vector<Real> x = nodes(1, 2000);
    const std::vector<Real> R = values(x, [](Real p) { return 1 - 0.1 * p; });
    MarchedProfile p(1e-5);
    Real P = 0;
    for (std::size_t i = 1; i < x.size(); ++i)
        P -= (p.advance(x[i] - x[i - 1], std::log(R[i] / R[i - 1])) + 2e-5) * (x[i] - x[i - 1]) /
             std::pow(R[i] * R[i - 1], 2);
    const Real u = p.w()[0] / (R.back() * R.back());
    EXPECT_NEAR(P, (4 - u * u) / 2, 2e-3);
}

TEST(BoundaryLayer, FlowTurnsBackWhereATubeWidensFast)
{
    MarchedProfile p(0.02);
    for (int n = 0; n < 100; ++n) p.advance(0.01, 0.01);
    EXPECT_TRUE(p.turns_back());
    MarchedProfile slow(2);
    for (int n = 0; n < 100; ++n) slow.advance(0.01, 0.01);
    EXPECT_FALSE(slow.turns_back());
}

TubeProblem main_case(Real reynolds)
{
    TubeProblem p;
    p.fluid.reynolds = reynolds;
    p.drive.pressure_inlet = 4 * p.tube.length / reynolds;
    return p;
}

TEST(Marched, IsTheLubricationModelWhereInertiaIsSmall)
{
    const OneDimensionalTube a = solve_one_dimensional(main_case(0.1));
    const OneDimensionalTube b = solve_marched(main_case(0.1));
    EXPECT_NEAR(b.Q, a.Q, 1e-4 * a.Q);
    EXPECT_NEAR(b.R_max - 1, a.R_max - 1, 1e-3 * (a.R_max - 1));
}

/// Q/Q_0 and R_max - 1 of tools/axisymmetric_tube, docs/theory.md.
TEST(Marched, AgreesWithTheAxisymmetricSolution)
{
    struct Known {
        Real reynolds, flow, widening;
    };
    for (const Known k : {Known{1, 1.4533, 0.2074},
                          {10, 1.4901, 0.2193},
                          {20, 1.5399, 0.2307},
                          {30, 1.6088, 0.2414}}) {
        const OneDimensionalTube t = solve_marched(main_case(k.reynolds));
        EXPECT_NEAR(t.Q / (pi / 2), k.flow, 0.005 * k.flow) << k.reynolds;
        EXPECT_NEAR(t.R_max - 1, k.widening, 0.002 * k.widening) << k.reynolds;
    }
}

TEST(Marched, LargestRadiusMovesDownstreamWithInertia)
{
    Real last = 0;
    for (const Real reynolds : {1.0, 10.0, 30.0}) {
        const Real x = solve_marched(main_case(reynolds)).x_R_max;
        EXPECT_GT(x, last + 0.05);
        last = x;
    }
}

TEST(Marched, SaysUpToWhichReynoldsNumberItFindsATube)
{
    TubeProblem p = main_case(40);
    p.drive.pressure_inlet *= 2;
    try {
        solve_marched(p);
        ADD_FAILURE() << "no error";
    } catch (const NumericalError& e) {
        EXPECT_NE(std::string(e.what()).find("beyond Re = "), std::string::npos) << e.what();
    }
}

TEST(Marched, HalfTheMeshGivesTheSameTube)
{
    const OneDimensionalTube fine = solve_marched(main_case(20));
    const OneDimensionalTube coarse = solve_marched(main_case(20), 500);
    EXPECT_NEAR(coarse.Q, fine.Q, 1e-3 * fine.Q);
    EXPECT_NEAR(coarse.R_max, fine.R_max, 1e-3);
}

} // namespace
} // namespace starling
