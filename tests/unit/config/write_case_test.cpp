#include "config/write_case.hpp"

#include <gtest/gtest.h>

#include <random>

#include <fmt/format.h>

#include "case_text.hpp"
#include "config/read_case.hpp"
#include "same_case.hpp"

namespace starling {
namespace {

using test::good_case;
using test::good_si_case;
using test::same;

void expect_round_trip(const Case& c)
{
    const std::string text = write_case(c);
    const Case again = read_case_text(text, "written");
    EXPECT_TRUE(same(c, again)) << text << "\n" << write_case(again);
    EXPECT_EQ(write_case(again), text);
}

TEST(WriteCase, ReadsBackToTheSameBits)
{
    const std::vector<std::vector<std::string>> changes = {
        {},
        {"wall.law=mooney-rivlin", "wall.psi=0.3"},
        {"wall.law=neo-hookean"},
        {"wall.law=skalak", "wall.poisson_ratio=", "wall.skalak_C=7.3"},
        {"wall.law=skalak", "wall.poisson_ratio=0.3"},
        {"coupling.scheme=conserving", "fluid.theta=0.5", "output.precision=double"},
        {"output.fluid_region=tube", "output.fluid_stride=2"},
        {"output.fluid_region=plane_y"},
        {"output.fluid_region=plane_z"},
        {"coupling.scheme=printed", "stop.wall_clock=2 min", "stop.steady_tolerance=1e-5"},
        {"time.safety=0.7", "output.wall=false", "output.fluid=false", "stop.steps=7"},
        {"grid.spacing=", "grid.cells=[125, 47, 48]"},
        {"vessel.rigid=true"},
        {"wall.contact=0.3", "wall.smoothing=1e-4"},
        {"title=\"quotes \\\" and \\\\ and \\n and \\u001b and µ\""},
    };
    for (const auto& overrides : changes) {
        expect_round_trip(read_case_text(good_case, "good", overrides));
        auto si = overrides;
        if (overrides.size() > 1 && overrides[1] == "wall.poisson_ratio=")
            si.push_back("drive.pressure_external=-3 mmHg");
        expect_round_trip(read_case_text(good_si_case, "good", si));
    }
}

TEST(WriteCase, ReadsViscosityAndTissueOfTheWallBackToTheSameBits)
{
    expect_round_trip(read_case_text(good_case, "good",
                                     {"wall.support_stiffness=3.7", "wall.support_damping=0.11",
                                      "wall.surface_viscosity=0.37"}));
    expect_round_trip(
        read_case_text(good_si_case, "good",
                       {"wall.support_stiffness=3.7 MPa/m", "wall.support_damping=1.3 kPa s/m",
                        "wall.surface_viscosity=0.7 mPa s m"}));
}

TEST(WriteCase, ReadsWhatFollowsCyclesBackToTheSameBits)
{
    expect_round_trip(read_case_text(good_case, "good",
                                     {"inlet_waveform.amplitude=3.1", "inlet_waveform.period=0.3",
                                      "inlet_waveform.sine=[1]", "stop.periodic_tolerance=0.003",
                                      "time.cycle_samples=77"}));
}

TEST(WriteCase, ReadsADriveThatChangesInTimeBackToTheSameBits)
{
    const std::vector<std::vector<std::string>> changes = {
        {"drive.ramp=1.7 ms", "inlet_waveform.amplitude=3.1 Pa", "inlet_waveform.period=7.3 ms",
         "inlet_waveform.cosine=[0.1, -0.3]", "inlet_waveform.sine=[0, 0, 1]"},
        {"outlet_waveform.amplitude=-0.7 mmHg", "outlet_waveform.times=[0.1, 0.37, 1.1]",
         "outlet_waveform.values=[1, 2.3, -0.1]", "outlet_waveform.time_scale=3.3 ms",
         "external_waveform.amplitude=11 Pa", "external_waveform.period=13 ms",
         "external_waveform.times=[0, 0.3]", "external_waveform.values=[1, 0.7]"},
    };
    for (const auto& overrides : changes) {
        expect_round_trip(read_case_text(good_si_case, "good", overrides));
        auto plain = overrides;
        for (std::string& text : plain) // "3.1 Pa" becomes "3.1"
            if (text.find(']') == std::string::npos) text.erase(text.find(' '));
        expect_round_trip(read_case_text(good_case, "good", plain));
    }
}

TEST(WriteCase, ReadsEndsThatAnswerToTheFlowBackToTheSameBits)
{
    const std::vector<std::string> windkessel = {"windkessel.R1=0.31", "windkessel.R2=2.7",
                                                 "windkessel.C=0.13",
                                                 "windkessel.pressure_distal=-0.7"};
    std::vector<std::string> flow = {"inlet_flow.mean=0.3", "inlet_flow.amplitude=1.3",
                                     "inlet_flow.period=0.7", "inlet_flow.sine=[1, 0.1]"};
    expect_round_trip(read_case_text(good_case, "good", {"drive.end_pressure=total"}));
    expect_round_trip(
        read_case_text(test::changed(good_case, "pressure_ratio = 1.5", "pressure_inlet = 7.1"),
                       "good", windkessel));
    flow.insert(flow.end(), windkessel.begin(), windkessel.end());
    expect_round_trip(
        read_case_text(test::changed(good_case, "pressure_ratio = 1.5\n", ""), "good", flow));
    expect_round_trip(
        read_case_text(test::changed(good_si_case, "pressure_inlet = \"50 Pa\"\n", ""), "good",
                       {"inlet_flow.mean=3.1 ul/min", "windkessel.R1=1.7e12 Pa s/m^3",
                        "windkessel.R2=0.9 mmHg s/ml", "windkessel.C=1.3e-15 m^3/Pa",
                        "windkessel.pressure_distal=1.1 mmHg", "drive.pressure_outlet=2 Pa"}));
}

TEST(WriteCase, ReadsAPerturbationBackToTheSameBits)
{
    for (const char* choice : {"perturbation.mode=3", "perturbation.seed=7"}) {
        expect_round_trip(
            read_case_text(good_case, "good", {"perturbation.amplitude=0.013", choice}));
        expect_round_trip(
            read_case_text(good_si_case, "good", {"perturbation.amplitude=1.3 um", choice}));
    }
}

TEST(WriteCase, ReadsBackToTheSameBitsForAnySiValues)
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(0.9, 1.1);
    const auto near = [&](double x) { return fmt::format("{:.17g}", x * uniform(random)); };
    for (int n = 0; n < 300; ++n)
        expect_round_trip(read_case_text(
            good_si_case, "good",
            {"fluid.density=" + near(1060) + " kg/m^3", "fluid.viscosity=" + near(4) + " mPa s",
             "drive.pressure_inlet=" + near(0.4) + " mmHg",
             "drive.pressure_outlet=" + near(-3) + " Pa",
             "drive.pressure_external=" + near(1) + " Pa", "vessel.radius=" + near(100) + " um",
             "vessel.length=" + near(1.2) + " mm", "vessel.rigid_inlet=" + near(0.1) + " mm",
             "wall.surface_shear_modulus=" + near(2) + " dyn/cm",
             "wall.bending_modulus=" + near(2e-13) + " N m",
             "perturbation.amplitude=" + near(1) + " um", "grid.width_y=" + near(0.5) + " mm",
             "grid.spacing=" + near(10) + " um", "grid.tube_offset_y=" + near(-5) + " um",
             "time.step=" + near(1) + " us", "output.wall_every=" + near(1) + " ms"}));
}

TEST(WriteCase, WritesEveryDefault)
{
    const std::string text = write_case(read_case_text(good_case, "good"));
    for (const char* line :
         {"theta = 1.0", "rigid = false", "bending = 0.0", "edge_over_spacing = 0.65",
          "mesh_filter = 1.0", "tube_offset_y = 0.0", "step = \"auto\"", "safety = 1.0",
          "precision = \"single\"", "pressure_external = 0.0"})
        EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
}

TEST(WriteCase, KeepsShortSiValuesShort)
{
    const std::string text = write_case(read_case_text(good_si_case, "good"));
    for (const char* line :
         {"density = \"1060 kg/m^3\"", "viscosity = \"4 mPa s\"", "radius = \"100 um\"",
          "pressure_inlet = \"50 Pa\"", "surface_shear_modulus = \"2 mN/m\"", "spacing = \"10 um\"",
          "end_time = \"20 ms\"", "tube_offset_y = \"0 m\""})
        EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
}

TEST(WriteCase, WithAnEndCutOffAnywhereBehindItsFirstLineIsFound)
{
    const std::string whole = write_case_with_end("# Written", Case{});
    EXPECT_FALSE(lacks_end(whole));
    EXPECT_FALSE(lacks_end(whole + "\n\n"));
    EXPECT_FALSE(lacks_end(write_case(Case{}))); // which promises none
    for (std::size_t size = whole.find('\n'); size + 1 < whole.size(); ++size)
        EXPECT_TRUE(lacks_end(whole.substr(0, size))) << size;
}

} // namespace
} // namespace starling
