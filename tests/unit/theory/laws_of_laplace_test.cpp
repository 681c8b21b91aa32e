#include "theory/laws_of_laplace.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "theory/poiseuille.hpp"

namespace starling {
namespace {

const std::vector<RadiusLaw> laws{RadiusLaw::laplace, RadiusLaw::anand_christov,
                                  RadiusLaw::second_order};

constexpr TubeStretch stretch{0.4, 0.1, 9.5, 4000, 0.1};

/// Eqs. (55)-(57) as printed.
Real printed_flow_rate(RadiusLaw law, const TubeStretch& s)
{
    const Real a = s.P_bar_upstream, b = s.P_bar_downstream;
    const Real k = pi * s.modulus * s.reynolds / s.length;
    const auto power = [](Real base, Real exponent) { return std::pow(base, exponent); };
    if (law == RadiusLaw::laplace) return k / 24 * (power(1 - a, -3) - power(1 - b, -3));
    if (law == RadiusLaw::anand_christov) return k / 40 * (power(1 + a, 5) - power(1 + b, 5));
    return k / 120 *
           (15 * (a - b) - 20 * (power(a * a + 1, 1.5) - power(b * b + 1, 1.5)) +
            24 * (power(a * a + 1, 2.5) - power(b * b + 1, 2.5)) + 40 * (a * a * a - b * b * b) +
            24 * (power(a, 5) - power(b, 5)));
}

/// Eq. (54) integrated over the pressure by Simpson's rule.
Real integrated_flow_rate(RadiusLaw law, const TubeStretch& s)
{
    constexpr int n = 2000;
    const Real h = (s.P_bar_upstream - s.P_bar_downstream) / n;
    Real sum = 0;
    for (int i = 0; i <= n; ++i) {
        const Real weight = i == 0 || i == n ? 1 : (i % 2 == 1 ? 4 : 2);
        sum += weight * h / 3 * std::pow(radius(law, s.P_bar_downstream + i * h), 4);
    }
    return pi * s.reynolds * s.modulus / (8 * s.length) * sum;
}

TEST(LawsOfLaplace, FlowRateIsTheIntegralOfPoiseuilleFlow)
{
    for (const RadiusLaw law : laws) {
        const Real Q = flow_rate(law, stretch);
        EXPECT_NEAR(Q, integrated_flow_rate(law, stretch), 1e-10 * Q);
    }
}

TEST(LawsOfLaplace, FlowRateIsThePrintedOne)
{
    for (const RadiusLaw law : laws) {
        const Real Q = flow_rate(law, stretch);
        EXPECT_NEAR(Q, printed_flow_rate(law, stretch), 1e-12 * Q);
    }
}

TEST(LawsOfLaplace, AllAgreeToFirstOrderInThePressure)
{
    const Real P_bar = 1e-4;
    for (const RadiusLaw law : laws) {
        EXPECT_EQ(radius(law, 0), 1);
        EXPECT_NEAR(radius(law, P_bar), 1 + P_bar, 1.01 * P_bar * P_bar);
        const Real Q = flow_rate(law, {P_bar, 0, 9.5, 4000, 0.1});
        const Real rigid = poiseuille::flow_rate(P_bar * 4000, 9.5, 0.1);
        EXPECT_NEAR(Q / rigid, 1, 2.1 * P_bar);
    }
}

TEST(LawsOfLaplace, LaplaceLiesAboveSecondOrderAboveAnandChristov)
{
    for (const Real P_bar : {0.05, 0.2, 0.6, 0.9}) {
        EXPECT_GT(radius(RadiusLaw::laplace, P_bar), radius(RadiusLaw::second_order, P_bar));
        EXPECT_GT(radius(RadiusLaw::second_order, P_bar), radius(RadiusLaw::anand_christov, P_bar));
    }
}

TEST(LawsOfLaplace, SecondOrderSolvesItsRingBalance)
{
    for (const Real P_bar : {-0.7, -0.1, 0.3, 2.0}) {
        const Real R = radius(RadiusLaw::second_order, P_bar);
        EXPECT_NEAR((R * R - 1) / 2, P_bar * R, 1e-14); // Eqs. (49)-(51)
    }
}

TEST(LawsOfLaplace, OutsideTheirDomainTheLawsHaveNoValue)
{
    EXPECT_TRUE(std::isnan(radius(RadiusLaw::laplace, 1)));
    EXPECT_TRUE(std::isnan(radius(RadiusLaw::laplace, 3)));
    EXPECT_TRUE(std::isnan(radius(RadiusLaw::anand_christov, -1)));
    EXPECT_FALSE(std::isnan(radius(RadiusLaw::second_order, 100)));
    EXPECT_TRUE(std::isnan(flow_rate(RadiusLaw::laplace, {1.2, 0.1, 1, 1, 1})));
}

TEST(Poiseuille, BaselineDropDrivesUnitCentrelineVelocity)
{
    const Real Re = 0.1, L = 4 * pi;
    const Real Q = poiseuille::flow_rate(4 * L / Re, L, Re);
    EXPECT_NEAR(Q, poiseuille::baseline_flow_rate, 1e-15);
    EXPECT_NEAR(poiseuille::velocity(Q, 0), 1, 1e-15);
    EXPECT_EQ(poiseuille::velocity(Q, 1), 0);
    EXPECT_NEAR(poiseuille::pressure_gradient(Q, Re), -4 / Re, 1e-13);
}

TEST(Poiseuille, ProfileCarriesTheFlowRate)
{
    const Real Q = 3.7, R = 1.4;
    constexpr int n = 2000;
    Real sum = 0;
    for (int i = 0; i < n; ++i) {
        const Real r = (i + 0.5) * R / n;
        sum += poiseuille::velocity(Q, r, R) * 2 * pi * r * R / n;
    }
    EXPECT_NEAR(sum, Q, 1e-6 * Q);
}

} // namespace
} // namespace starling
