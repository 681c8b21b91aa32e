#include "theory/buckling_report.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace starling {
namespace {

/// Fig. 16 of the paper, with another B where given.
TubeProblem dumbbell_case(Real B = 1.953e-3)
{
    TubeProblem p;
    p.material.bending = B;
    p.tube.length = 21;
    p.tube.rigid_inlet = 1;
    p.tube.rigid_outlet = 10;
    p.material.eps = 2.5e-4;
    p.material.poisson_ratio = 0.49;
    const Real baseline = 4 * 21 / p.fluid.reynolds;
    p.drive.pressure_inlet = 0.065 * baseline;
    p.drive.pressure_outlet = -2.493 * baseline;
    return p;
}

TEST(BucklingReport, PaperSDumbbellIsPredictedJustAboveItsLoad)
{
    const TubeProblem p = dumbbell_case();
    const auto r = buckling_report(p);
    ASSERT_TRUE(r);
    EXPECT_EQ(r->under_own_pressure->n, 2);
    EXPECT_TRUE(r->buckles());
    EXPECT_GT(r->under_own_pressure->factor, 0.9);
    EXPECT_EQ(r->length, 10);
    // Pressures at the clamps of the undeformed tube: linear from x = 0 to 21.
    const Real drop = p.pressure_drop();
    EXPECT_NEAR(r->pressure.inlet, p.drive.pressure_inlet - drop / 21, 1e-9);
    EXPECT_NEAR(r->pressure.outlet, p.drive.pressure_outlet + drop * 10 / 21, 1e-9);
}

TEST(BucklingReport, OnlyDifferencesOfPressureCount)
{
    TubeProblem p = dumbbell_case(1e-3);
    const Real before = buckling_report(p)->under_own_pressure->factor;
    for (Real* q : {&p.drive.pressure_inlet, &p.drive.pressure_outlet, &p.drive.pressure_external})
        *q += 1000;
    EXPECT_NEAR(buckling_report(p)->under_own_pressure->factor, before, 1e-8);
}

TEST(BucklingReport, ReachesBeyondThePredictedMode)
{
    for (const Real B : {1e-2, 1e-4, 1e-7}) {
        const auto r = buckling_report(dumbbell_case(B));
        EXPECT_LT(r->under_uniform_pressure->n, r->loads.back().n);
        EXPECT_LT(r->under_own_pressure->n, r->loads.back().n);
        EXPECT_GE(r->loads.back().n, 8);
        EXPECT_EQ(r->loads.front().n, 2);
    }
}

TEST(BucklingReport, InflatedTubesDoNotBuckle)
{
    TubeProblem p;
    p.material.bending = 1e-3;
    p.drive.pressure_inlet = 100;
    const auto r = buckling_report(p);
    EXPECT_FALSE(r->under_own_pressure);
    EXPECT_FALSE(r->buckles());
    EXPECT_EQ(r->under_uniform_pressure->n, 3); // of its own uniform load there is still a mode
    EXPECT_NE(to_text(*r, Scaling{}).find("do not compress"), std::string::npos);
}

TEST(BucklingReport, IsEmptyWhereTissueSupportsTheWall)
{
    TubeProblem p = dumbbell_case();
    p.material.support.stiffness = 1;
    EXPECT_FALSE(buckling_report(p));
}

TEST(BucklingReport, IsEmptyWithoutBendingOrForARigidTube)
{
    EXPECT_FALSE(buckling_report(dumbbell_case(0)));
    TubeProblem p = dumbbell_case();
    p.tube.rigid = true;
    EXPECT_FALSE(buckling_report(p));
}

TEST(BucklingReport, TextNamesModeAndLoads)
{
    const TubeProblem p = dumbbell_case();
    const std::string text = to_text(*buckling_report(p), Scaling{});
    for (const char* part : {"n = 2", "collapses", "tube at rest", "0.9579", "contact", "0.270948"})
        EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
}

TEST(BucklingReport, TablesAreInTheUnitsOfTheCase)
{
    const TubeProblem p = dumbbell_case();
    const auto r = buckling_report(p);
    const Scaling si{.si = true, .length = 0.005, .velocity = 0.1, .density = 1060};
    std::istringstream loads(to_csv(*r, si)), law(tube_law_csv(*r, si));
    std::string header, row;
    std::getline(loads, header);
    std::getline(loads, row);
    EXPECT_EQ(header, "n [1],p_ring [Pa],p_at_rest [Pa],p_tube [Pa],load_factor [1]");
    EXPECT_NEAR(std::stod(row.substr(2)), 3 * r->E_b * 10.6, 1e-6 * r->E_b);
    std::getline(law, header);
    std::getline(law, row);
    EXPECT_EQ(header, "n [1],p [Pa],area_ratio [1],tip_distance [m],waist_distance [m],gap [m]");
    EXPECT_NEAR(std::stod(row.substr(2)), 3 * r->E_b * 10.6, 1e-6 * r->E_b);
    EXPECT_NE(row.find(",1,0.005,0.005,0.01"), std::string::npos);
}

} // namespace
} // namespace starling
