#include "theory/theory_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "theory/poiseuille.hpp"

namespace starling {
namespace {

TubeProblem main_case(Real ratio = 1)
{
    TubeProblem p;
    p.drive.pressure_inlet = ratio * 4 * p.tube.length / p.fluid.reynolds;
    return p;
}

TEST(TheoryReport, SecondOrderRelationIsClosestToTheModel)
{
    for (const Real ratio : {0.5, 1.0, 1.5}) {
        const TheoryReport r = theory_report(main_case(ratio));
        EXPECT_NEAR(r.law_Q_over_Q0[2] / r.Q_over_Q0, 1, 0.005);
        EXPECT_GT(r.law_Q_over_Q0[0], r.Q_over_Q0);
        EXPECT_LT(r.law_Q_over_Q0[1], r.Q_over_Q0);
    }
}

TEST(TheoryReport, MainCaseHasItsKnownValues)
{
    const TheoryReport r = theory_report(main_case());
    EXPECT_NEAR(r.problem.pressure_ratio(), 1, 1e-14);
    EXPECT_NEAR(r.Q_over_Q0, 1.448321, 1e-6);
    EXPECT_NEAR(r.tube.R_max, 1.206045, 1e-6);
    EXPECT_EQ(r.max_strain, r.tube.R_max - 1);
    // Poiseuille flow in the rigid ends gives the pressures at the clamps.
    const Real gradient = poiseuille::pressure_gradient(r.tube.Q, 0.1);
    EXPECT_NEAR(r.P_clamp_inlet, r.problem.drive.pressure_inlet + gradient * 1.18, 1e-8);
    EXPECT_NEAR(r.P_clamp_outlet, -gradient * 0.39, 1e-8);
}

TEST(TheoryReport, LawsAreShownOnlyWhereTheWallDeforms)
{
    const TheoryReport r = theory_report(main_case());
    EXPECT_TRUE(std::isnan(r.law_radius(RadiusLaw::second_order, 0.5)));
    EXPECT_FALSE(std::isnan(r.law_radius(RadiusLaw::second_order, r.problem.clamp_inlet())));
    EXPECT_NEAR(r.law_radius(RadiusLaw::second_order, 6), r.tube.R_at(6), 1e-3);
}

TEST(TheoryReport, TableNamesEveryResult)
{
    const std::string text = to_text(theory_report(main_case()), Scaling{});
    for (const char* part :
         {"Re ", "eps", "Delta P/Delta P_0", "Q/Q_0", "largest radius", "largest strain", "clamp",
          "Eq. (55)", "Eq. (56)", "Eq. (57)", "1.44832", "1.20604"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(TheoryReport, ValuesComeInTheUnitsOfTheCase)
{
    const Scaling si{.si = true, .length = 0.005, .velocity = 0.1, .density = 1060};
    const TheoryReport r = theory_report(main_case());
    std::istringstream csv(to_csv(r, si));
    std::string header, inlet, clamp;
    std::getline(csv, header);
    std::getline(csv, inlet);
    std::getline(csv, clamp);
    EXPECT_EQ(header, "x [m],R [m],P [Pa],R_laplace [m],R_anand_christov [m],R_second_order [m]");
    EXPECT_EQ(inlet.substr(0, 8), "0,0.005,");
    EXPECT_NE(inlet.find("nan,nan,nan"), std::string::npos);
    EXPECT_EQ(clamp.find("nan"), std::string::npos);
    EXPECT_EQ(std::stod(clamp), 1.18 * 0.005);
    EXPECT_NE(to_text(r, si).find(" Pa"), std::string::npos);
}

TEST(TheoryReport, CsvHasARowPerNode)
{
    const TheoryReport r = theory_report(main_case());
    const std::string csv = to_csv(r, Scaling{});
    EXPECT_EQ(csv.find("x [R_0],R [R_0],P [rho U_c^2],R_laplace [R_0],"), 0U);
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
              1 + r.tube.x.size());
}

TEST(TheoryReport, LawsWithoutAValueAreMarked)
{
    // The law of Laplace diverges at this load.
    const std::string text = to_text(theory_report(main_case(10)), Scaling{});
    EXPECT_NE(text.find("none"), std::string::npos);
    EXPECT_EQ(text.find(" nan"), std::string::npos);
}

TEST(TheoryReport, RigidTubeIsPoiseuille)
{
    TubeProblem p = main_case(2);
    p.tube.rigid = true;
    const TheoryReport r = theory_report(p);
    EXPECT_NEAR(r.Q_over_Q0, 2, 1e-14);
    EXPECT_NE(to_text(r, Scaling{}).find("rigid tube"), std::string::npos);
}

} // namespace
} // namespace starling
