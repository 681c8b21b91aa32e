#include "config/read_case.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "../output/temporary_directory.hpp"
#include "case_text.hpp"
#include "core/error.hpp"
#include "same_case.hpp"

namespace starling {
namespace {

using test::changed;
using test::good_case;
using test::good_si_case;
using test::same;

Case with(const std::vector<std::string>& overrides)
{
    return read_case_text(good_case, "good", overrides);
}

Case si_with(const std::vector<std::string>& overrides)
{
    return read_case_text(good_si_case, "good", overrides);
}

TEST(ReadCase, TakesEveryValueOfTheFile)
{
    const Case c = with({});
    EXPECT_EQ(c.title, "a tube");
    EXPECT_EQ(c.fluid.reynolds, 0.1);
    EXPECT_EQ(c.tube.length, 12.5);
    EXPECT_EQ(c.tube.rigid_inlet, 1.2);
    EXPECT_EQ(c.tube.rigid_outlet, 0.4);
    EXPECT_EQ(c.material.eps, 0.02);
    EXPECT_EQ(c.grid.spacing, 0.1);
    EXPECT_FALSE(c.time.step);
    EXPECT_EQ(c.stop.end_time, 1.0);
    EXPECT_FALSE(c.stop.steps);
    EXPECT_FALSE(c.scaling.si);
}

TEST(ReadCase, ThePressureRatioSetsThePressureThatIsNotGiven)
{
    EXPECT_DOUBLE_EQ(with({}).pressure_ratio(), 1.5);
    EXPECT_DOUBLE_EQ(with({}).drive.pressure_inlet, 1.5 * 4 * 12.5 / 0.1);
    const Case outlet = with({"drive.pressure_outlet=-20"});
    EXPECT_DOUBLE_EQ(outlet.pressure_ratio(), 1.5);
    EXPECT_EQ(outlet.drive.pressure_outlet, -20);
    const Case inlet = with({"drive.pressure_inlet=0"});
    EXPECT_DOUBLE_EQ(inlet.pressure_ratio(), 1.5);
    EXPECT_EQ(inlet.drive.pressure_inlet, 0);
}

TEST(ReadCase, OverridesWinAndAnEmptyOneRemoves)
{
    const Case c = with({"fluid.reynolds=0.2", "fluid.reynolds = 0.3", "wall.law=neo-hookean",
                         "title=\"new\"", "drive.pressure_ratio=", "drive.pressure_inlet=5"});
    EXPECT_EQ(c.fluid.reynolds, 0.3);
    EXPECT_EQ(c.material.law, ElasticLaw::neo_hookean);
    EXPECT_EQ(c.title, "new");
    EXPECT_EQ(c.drive.pressure_inlet, 5);
    EXPECT_EQ(si_with({"drive.pressure_outlet=\"1 Pa\""}).drive.pressure_outlet,
              si_with({"drive.pressure_outlet=1 Pa"}).drive.pressure_outlet);
}

TEST(ReadCase, AnOverrideGivesWhatTheFileWouldGive)
{
    EXPECT_TRUE(same(with({"grid.spacing=0.12", "vessel.rigid=true"}),
                     read_case_text(changed(changed(good_case, "spacing = 0.1", "spacing = 0.12"),
                                            "[vessel]", "[vessel]\nrigid = true"),
                                    "good")));
}

TEST(ReadCase, WithoutStopSectionARunEndsWhenItIsSteady)
{
    const Case c = read_case_text(changed(good_case, "[stop]\nend_time = 1.0\n", ""), "good");
    EXPECT_EQ(c.stop.steady_tolerance, 1e-4);
    EXPECT_EQ(c.stop.steps, 200000);
    EXPECT_FALSE(c.stop.end_time);
}

TEST(ReadCase, ARigidTubeNeedsNoWall)
{
    auto text =
        changed(good_case, "[wall]\nlaw = \"hooke\"\npoisson_ratio = 0.5\neps = 0.02\n", "");
    text = changed(text, "rigid_inlet = 1.2\nrigid_outlet = 0.4\n", "rigid = true\n");
    EXPECT_TRUE(read_case_text(text, "rigid").tube.rigid);
}

TEST(ReadCase, WholeNumbersServeAsNumbersAndWholeFloatsAsCounts)
{
    const Case c = with({"fluid.reynolds=1", "stop.steps=1e5"});
    EXPECT_EQ(c.fluid.reynolds, 1);
    EXPECT_EQ(c.stop.steps, 100000);
}

TEST(ReadCase, CellsSetTheSpacing)
{
    const Case c = with({"grid.spacing=", "grid.cells=[125, 47, 47]"});
    EXPECT_EQ(c.grid.cells, (std::array<Index, 3>{125, 47, 47}));
    EXPECT_NEAR(c.grid.spacing, 0.1, 1e-12);
}

TEST(ReadCase, SkalaksModulusAndPoissonRatioFollowFromEachOther)
{
    const Case nu = with({"wall.law=skalak", "wall.poisson_ratio=0.75"});
    EXPECT_DOUBLE_EQ(nu.material.skalak_C, 3);
    const Case C = with({"wall.law=skalak", "wall.poisson_ratio=", "wall.skalak_C=3"});
    EXPECT_DOUBLE_EQ(C.material.poisson_ratio, 0.75);
    EXPECT_NO_THROW(with({"wall.law=skalak", "wall.poisson_ratio=0.75", "wall.skalak_C=3"}));
}

TEST(ReadCase, SiValuesAreScaledAsInThePaper)
{
    const Case c = si_with({});
    const double U = 50 * 1e-8 / (4 * 4e-3 * 1.2e-3);
    EXPECT_TRUE(c.scaling.si);
    EXPECT_DOUBLE_EQ(c.scaling.length, 1e-4);
    EXPECT_DOUBLE_EQ(c.scaling.velocity, U);
    EXPECT_DOUBLE_EQ(c.scaling.density, 1060);
    EXPECT_DOUBLE_EQ(c.fluid.reynolds, 1060 * U * 1e-4 / 4e-3);
    EXPECT_DOUBLE_EQ(c.material.eps, 4e-3 * U / 2e-3);
    EXPECT_DOUBLE_EQ(c.pressure_ratio(), 1);
    EXPECT_DOUBLE_EQ(c.tube.length, 12);
    EXPECT_DOUBLE_EQ(c.grid.spacing, 0.1);
    EXPECT_DOUBLE_EQ(*c.stop.end_time, 20e-3 * U / 1e-4);
    EXPECT_DOUBLE_EQ(c.drive.pressure_inlet * c.scaling.factor(Quantity::pressure), 50);
}

TEST(ReadCase, ViscosityAndTissueOfTheWallAreScaled)
{
    const Case c = si_with({"wall.surface_viscosity=0.5 mPa s m", "wall.support_stiffness=3 MPa/m",
                            "wall.support_damping=2 kPa s/m"});
    const Real rho = 1060, R = 1e-4, U = c.scaling.velocity;
    EXPECT_DOUBLE_EQ(c.material.viscosity, 0.5e-3 / (rho * U * R * R));
    EXPECT_DOUBLE_EQ(c.material.support.stiffness, 3e6 * R / (rho * U * U));
    EXPECT_DOUBLE_EQ(c.material.support.damping, 2e3 / (rho * U));
}

TEST(ReadCase, AGivenVelocityScaleWins)
{
    const Case c = si_with({"drive.velocity_scale=1 cm/s"});
    EXPECT_EQ(c.scaling.velocity, 0.01);
    EXPECT_NEAR(c.pressure_ratio(), 50 * 1e-8 / (4 * 4e-3 * 1.2e-3) / 0.01, 1e-12);
    EXPECT_NO_THROW(si_with({"drive.velocity_scale=1 cm/s", "drive.pressure_inlet=0"}));
}

TEST(ReadCase, TheScaleOfAReversedDropIsPositive)
{
    const Case c = si_with({"drive.pressure_inlet=0", "drive.pressure_outlet=50 Pa"});
    EXPECT_EQ(c.scaling.velocity, si_with({}).scaling.velocity);
    EXPECT_DOUBLE_EQ(c.pressure_ratio(), -1);
}

TEST(ReadCase, YoungsModulusAndThicknessGiveTheSurfaceShearModulus)
{
    const std::vector<std::string> film = {
        "wall.surface_shear_modulus=", "wall.youngs_modulus=6 kPa", "wall.thickness=1 um"};
    EXPECT_DOUBLE_EQ(si_with(film).material.eps, si_with({}).material.eps); // nu_s = 1/2
    auto other = film;
    other.push_back("wall.poisson_ratio=0.2");
    EXPECT_DOUBLE_EQ(si_with(other).material.eps, si_with({}).material.eps * 2.4 / 3);
}

TEST(ReadCase, AThicknessGivesTheBendingStiffness)
{
    const auto bending = [](const std::vector<std::string>& overrides) {
        return read_case_text(good_case, "good", overrides).material.bending;
    };
    EXPECT_EQ(bending({}), 0);
    EXPECT_EQ(bending({"wall.bending=0.01"}), 0.01);
    // E h^3/(12 (1 - nu^2)) over E h/(2 (1 + nu)) R_0^2
    const Real h = 0.1, nu = 0.3;
    const Real B = h * h * h / (12 * (1 - nu * nu)) / (h / (2 * (1 + nu)));
    EXPECT_DOUBLE_EQ(bending({"wall.bending_thickness=0.1", "wall.poisson_ratio=0.3"}), B);
    EXPECT_DOUBLE_EQ(
        si_with({"wall.bending_thickness=10 um", "wall.poisson_ratio=0.3"}).material.bending, B);
    // R_0^2 G_s = (0.1 mm)^2 * 2 mN/m
    EXPECT_DOUBLE_EQ(si_with({"wall.bending_modulus=2e-13 N m"}).material.bending, 0.01);
}

TEST(ReadCase, APerturbationIsOffUnlessItIsGiven)
{
    EXPECT_EQ(read_case_text(good_case, "good").perturbation.amplitude, 0);
    const auto p =
        read_case_text(good_case, "good", {"perturbation.amplitude=0.01", "perturbation.mode=3"})
            .perturbation;
    EXPECT_EQ(p.amplitude, 0.01);
    EXPECT_EQ(p.mode, 3);
    EXPECT_EQ(si_with({"perturbation.amplitude=1 um", "perturbation.seed=9"}).perturbation.seed, 9);
}

TEST(ReadCase, TheSamePhysicsInOtherUnitsIsTheSameCase)
{
    const Case a = si_with({});
    const Case b = si_with({"vessel.radius=100 um", "fluid.viscosity=4 cP",
                            "fluid.density=1.06 g/cm^3", "wall.surface_shear_modulus=2 dyn/cm"});
    EXPECT_DOUBLE_EQ(a.fluid.reynolds, b.fluid.reynolds);
    EXPECT_DOUBLE_EQ(a.material.eps, b.material.eps);
    EXPECT_DOUBLE_EQ(a.drive.pressure_inlet, b.drive.pressure_inlet);
}

/// The inlet's waveform of the good case with a table in a file beside it.
Waveform from_csv(const std::string& rows, const std::string& more)
{
    TemporaryDirectory directory;
    std::ofstream(directory.path() / "flow.csv") << rows;
    const auto file = directory.path() / "case.toml";
    std::ofstream(file) << test::good_case
                        << "[inlet_waveform]\namplitude = 2.0\nfile = 'flow.csv'\n"
                        << more;
    return read_case(file).drive.inlet_waveform;
}

TEST(ReadCase, TakesAWaveformFromACsvFileBesideTheCase)
{
    const Waveform w =
        from_csv("time,value\r\n0,1\r\n 0.5 , 3e0\r\n\n1,+2\n", "time_scale = 4.0\n");
    EXPECT_EQ(w.times, (std::vector<Real>{0, 2, 4}));
    EXPECT_EQ(w.values, (std::vector<Real>{1, 3, 2}));
    EXPECT_EQ(w(3), 5);
    const Waveform periodic = from_csv("0,1\n0.5,3\n1,1\n", "period = 4.0\n");
    EXPECT_EQ(periodic.times, (std::vector<Real>{0, 2})) << "the last row says the first again";
    EXPECT_EQ(periodic(7), 2 * 2);
}

TEST(ReadCase, NamesTheLineOfACsvFileThatIsWrong)
{
    for (const char* rows :
         {"time,value\n0,1\n1;2\n", "time,value\n0,1\n1,x\n", "t,v\n0,1\n1\n", "t,v\n0,1\n1,nan\n"})
        try {
            from_csv(rows, "period = 4.0\n");
            ADD_FAILURE() << rows;
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find("line 3 is"), std::string::npos) << e.what();
        }
    EXPECT_THROW(from_csv("time,value\n", "period = 4.0\n"), InputError);
    EXPECT_THROW(from_csv("", "period = 4.0\n"), InputError);
}

} // namespace
} // namespace starling
