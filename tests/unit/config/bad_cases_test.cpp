#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <tuple>

#include "case_text.hpp"
#include "config/read_case.hpp"
#include "core/error.hpp"

namespace starling {
namespace {

using test::changed;
using test::good_case;
using test::good_si_case;

std::vector<Problem> problems_of(const std::string& text,
                                 const std::vector<std::string>& overrides = {})
{
    try {
        read_case_text(text, "a.toml", overrides);
    } catch (const InputError& e) {
        return e.problems();
    }
    return {};
}

/// Whether one of the problems stands at this line and key and says this.
testing::AssertionResult holds(const std::vector<Problem>& problems, int line, std::string_view key,
                               std::string_view fragment)
{
    auto result = testing::AssertionFailure() << "no \"" << fragment << "\" at line " << line;
    for (const Problem& p : problems) {
        if (p.line == line && p.key == key && p.file == "a.toml" &&
            p.message.find(fragment) != std::string::npos)
            return testing::AssertionSuccess();
        result << "\n" << p.file << ":" << p.line << ": " << p.key << ": " << p.message;
    }
    return result;
}

/// Values of a key of a good case, each of which gets this answer.
struct BadValues {
    std::string_view key;
    std::vector<std::string_view> values;
    std::string_view fragment;
};

void expect_answers(std::string_view good, const std::vector<BadValues>& rows)
{
    for (const auto& [key, values, fragment] : rows)
        for (const std::string_view value : values) {
            const auto [text, line] = test::with_value(good, key, value);
            const auto problems = problems_of(text);
            EXPECT_EQ(problems.size(), 1U) << key << " = " << value;
            EXPECT_TRUE(holds(problems, line, key, fragment)) << key << " = " << value;
        }
}

TEST(BadCases, AWrongValueIsReportedWithWhatIsAllowed)
{
    expect_answers(
        good_case,
        {
            // names
            {"wall.law", {"'hook'"}, "did you mean \"hooke\""},
            {"wall.law", {"'hookean-neo'"}, "did you mean \"neo-hookean\""},
            {"wall.law", {"''"}, "allowed: hooke, neo-hookean"},
            {"coupling.scheme", {"'reactoin'"}, "did you mean \"reaction\""},
            {"output.precision", {"'half'"}, "single, double"},
            {"units", {"'imperial'"}, "allowed: dimensionless, si"},
            {"units", {"3"}, "must be one of \"dimensionless\", \"si\""},
            // types
            {"title", {"3"}, "must be text"},
            {"fluid.reynolds", {"'0.1'", "true", "[0.1]"}, "must be a plain number"},
            {"fluid.reynolds", {"true"}, "is true; must be a plain number"},
            {"fluid.reynolds", {"1979-05-27"}, "is a date or time"},
            {"fluid.reynolds", {"{a = 1}"}, "is a table"},
            {"vessel.length", {"'5 mm'"}, "need units = \"si\""},
            {"vessel.rigid", {"'no'", "0"}, "must be true or false"},
            {"output.wall", {"1"}, "is 1; must be true or false"},
            {"output.sample_every", {"10.5", "'ten'", "nan"}, "must be a whole number"},
            {"time.step", {"'small'"}, "or \"auto\""},
            {"stop.wall_clock", {"'5 mm'"}, "is a length; must be a time"},
            // ranges
            {"fluid.reynolds", {"0", "-0.1", "1e300"}, "from 1e-06 to 10000"},
            {"fluid.reynolds", {"nan", "inf"}, "must be finite"},
            {"fluid.theta", {"0.4"}, "from 0.5 to 1"},
            {"drive.pressure_ratio", {"-inf"}, "must be finite"},
            {"drive.pressure_ratio", {"1e9"}, "from -1000 to 1000"},
            {"drive.pressure_inlet", {"1e30"}, "to 1e+12"},
            {"vessel.length", {"-12.5", "1e9"}, "from 0.5 to 10000"},
            {"vessel.rigid_inlet", {"-1"}, "greater than 0"},
            {"vessel.rigid_outlet", {"0"}, "greater than 0"},
            {"wall.eps", {"0", "-0.02"}, "from 1e-08 to 10"},
            {"wall.poisson_ratio", {"1.0", "-0.1"}, "at least 0 and less than 1"},
            {"wall.edge_over_spacing", {"5"}, "0.2 to 2"},
            {"wall.bending", {"-0.01", "11"}, "from 0 to 10"},
            {"wall.bending_thickness", {"0", "0.6"}, "greater than 0 and at most 0.5"},
            {"grid.width_y", {"1.5"}, "greater than 2"},
            {"grid.width_z", {"-4.7"}, "greater than 2"},
            {"grid.spacing", {"0", "-0.1", "0.5"}, "greater than 0 and at most 0.34"},
            {"grid.tube_offset_y", {"nan"}, "must be finite"},
            {"time.step", {"0", "-1e-3"}, "greater than 0"},
            {"time.safety", {"3"}, "at most 2"},
            {"stop.end_time", {"-1.0"}, "greater than 0"},
            {"stop.steps", {"0", "9000000000000000000"}, "from 1 to 1e+09"},
            {"stop.steady_tolerance", {"1"}, "at most 0.1"},
            {"stop.wall_clock", {"-5"}, "greater than 0"},
            {"output.sample_every", {"0"}, "from 1"},
            {"output.fluid_every", {"0.0"}, "greater than 0"},
            // geometry and other combinations
            {"vessel.rigid_inlet", {"0.15"}, "is 0.15 R_0, under 2 grid spacings of 0.1 R_0"},
            {"grid.spacing", {"1e-4", "1e-300"}, "cells; at most 2e+09"},
            {"time.step", {"1e-12"}, "needs 1e+12 steps"},
            {"time.step", {"2"}, "longer than end_time"},
            {"wall.psi", {"0.5"}, "law = \"mooney-rivlin\" only"},
            {"wall.skalak_C", {"1"}, "law = \"skalak\" only"},
            // the other unit system
            {"fluid.density", {"'1 kg/m^3'"}, "belongs to units = \"si\"; give reynolds"},
            {"vessel.radius", {"1"}, "leave it out"},
            {"wall.thickness", {"1"}, "give eps"},
            {"wall.bending_modulus", {"'1 J'"}, "give bending"},
            // no such key
            {"fluid.reynold", {"1"}, "did you mean \"reynolds\""},
            {"wall.EPS", {"1"}, "did you mean \"eps\""},
            {"fluid.thtea", {"1"}, "did you mean \"theta\"? (allowed: reynolds"},
            {"drive.inlet_pressure", {"1"}, "did you mean \"pressure_inlet\""},
            {"fluid.zzz", {"1"}, "unknown key; allowed: reynolds, theta"},
            {"fluid.eps", {"1"}, "it belongs in [wall]"},
            {"spacing", {"0.1"}, "it belongs in [grid]"},
            {"name", {"1"}, "allowed: title, units"},
        });
}

TEST(BadCases, AWrongValueInSiIsReportedInTheUnitOfTheFile)
{
    expect_answers(
        good_si_case,
        {
            {"drive.pressure_inlet", {"'5 mm'"}, "is a length; must be a pressure (Pa, kPa"},
            {"drive.pressure_inlet", {"'5'"}, "has no unit"},
            {"drive.pressure_inlet", {"50"}, "must be a pressure with a unit"},
            {"drive.pressure_inlet", {"'50 pa'"}, "unknown unit \"pa\""},
            {"drive.pressure_inlet", {"'nan Pa'", "'inf Pa'"}, "must be finite"},
            {"drive.pressure_inlet", {"'1e99999 Pa'"}, "too large"},
            {"drive.pressure_inlet", {"'1e300 Pa'"}, "out of any physical range"},
            {"drive.pressure_inlet", {"'Pa'", "''"}, "must start with a number"},
            {"drive.pressure_ratio", {"1"}, "give pressure_inlet instead"},
            {"drive.inlet_pressure", {"'1 Pa'"}, "did you mean \"pressure_inlet\""},
            {"vessel.radius", {"'-0.1 mm'", "'0 mm'"}, "must be greater than 0"},
            {"vessel.radius", {"'0.1 mL'"}, "is a volume; must be a length"},
            {"grid.width_y",
             {"'0.22 mm'"},
             "leaves 0.01 mm (0.1 R_0) between the tube and the box; 3 spacings are needed, so at "
             "least 0.26 mm (2.6 R_0)"},
            {"grid.tube_offset_y", {"'5 m/s'"}, "is a velocity; must be a length"},
            {"vessel.rigid_outlet",
             {"'0.0012 cm'"},
             "is 0.0012 cm (0.12 R_0), under 2 grid spacings of 10 um (0.1 R_0)"},
            {"vessel.rigid_inlet", {"'5 um'"}, "under 2 grid spacings of 10 um (0.1 R_0)"},
            {"fluid.viscosity", {"'4 Pa'"}, "is a pressure; must be a viscosity"},
            {"fluid.viscosity", {"'4e-9 Pa s'"}, "gives a Reynolds number"},
            {"fluid.density", {"'1060 kg'"}, "is something in kg"},
            {"fluid.density", {"'1060 kg/m^'"}, "exponent"},
            {"grid.spacing", {"0.1"}, "must be a length with a unit"},
            {"grid.spacing",
             {"'0.04 mm'"},
             "is 0.04 mm (0.4 R_0); must be greater than 0 and at most 0.034 mm (greater than 0 "
             "and "
             "at most 0.34 R_0)"},
            {"vessel.length",
             {"'1e3 cm'"},
             "is 1000 cm (1e+05 R_0); must be from 0.005 to 100 cm (from 0.5 to 10000 R_0)"},
            {"wall.surface_shear_modulus", {"'2 N/mm/s'"}, "must be a force per length"},
            {"wall.surface_shear_modulus", {"'2e-12 N/m'"}, "gives a deformability"},
            {"wall.bending_modulus", {"'1 N'"}, "is a force; must be an energy"},
            {"wall.bending_modulus", {"'1 J'"}, "gives a bending stiffness"},
            {"wall.bending", {"0.01"}, "give bending_modulus or bending_thickness"},
            {"stop.end_time", {"'20 m s'"}, "must be a time"},
            {"stop.end_time", {"'20 s/m s'"}, "its own \"/\""},
        });
}

TEST(BadCases, AMissingKeyIsReportedWithWhatItTakes)
{
    struct Missing {
        std::string_view good, key, fragment;
    };
    const std::string_view pressure =
        "a pressure with a unit, in quotes (Pa, kPa, MPa, mmHg, cmH2O)";
    for (const auto& [good, key, fragment] : std::initializer_list<Missing>{
             {good_case, "fluid.reynolds",
              "Reynolds number rho U_c R_0/mu, a plain number from 1e-06 to 10000"},
             {good_case, "drive.pressure_ratio",
              "a plain number from -1000 to 1000; or give pressure_inlet"},
             {good_case, "vessel.length",
              "length of the tube, a plain number in R_0, from 0.5 to 10000"},
             {good_case, "vessel.rigid_outlet", "a plain number in R_0, greater than 0"},
             {good_case, "wall.law",
              "elastic law, one of \"hooke\", \"neo-hookean\", \"mooney-rivlin\", \"skalak\""},
             {good_case, "wall.eps", "deformability mu U_c/G_s, a plain number from 1e-08 to 10"},
             {good_si_case, "drive.pressure_inlet", pressure},
             {good_si_case, "vessel.radius",
              "a length with a unit, in quotes (nm, um, mm, m), greater than 0"},
             {good_si_case, "vessel.length", "(nm, um, mm, m), from 0.5 to 10000 R_0"},
             {good_si_case, "fluid.viscosity", "a viscosity with a unit, in quotes (mPa s, Pa s)"},
             {good_si_case, "wall.surface_shear_modulus",
              "greater than 0; or give youngs_modulus and thickness"},
         }) {
        const auto [text, line] = test::without(good, key);
        const auto problems = problems_of(text);
        EXPECT_EQ(problems.size(), 1U) << key;
        EXPECT_TRUE(holds(problems, line, key, fragment));
        EXPECT_TRUE(holds(problems, line, key, "is missing: "));
    }
}

/// A change of a good case that takes more than the value of one key.
struct BadCase {
    std::string_view from, to;
    int line;
    std::string_view key, fragment;
};

void expect_answers(std::string_view good, const std::vector<BadCase>& rows)
{
    for (const BadCase& b : rows) {
        const auto problems = problems_of(changed(good, b.from, b.to));
        EXPECT_EQ(problems.size(), 1U) << b.from << " -> " << b.to;
        EXPECT_TRUE(holds(problems, b.line, b.key, b.fragment)) << b.from << " -> " << b.to;
    }
}

TEST(BadCases, AWrongCombinationIsReportedWithWhatIsAllowed)
{
    const std::string_view spacing = "spacing = 0.1", law = "law = \"hooke\"",
                           nu = "law = \"hooke\"\npoisson_ratio = 0.5";
    expect_answers(
        good_case,
        {
            {"[coupling]", "[couplings]", 20, "couplings", "did you mean \"coupling\""},
            {"[time]", "[qqqqqqqq]", 22, "qqqqqqqq", "unknown section; allowed: fluid, drive"},
            {"title = \"a tube\"", "\"fluid.theta\" = 1", 1, "fluid.theta", "unknown key"},
            {"title = \"a tube\"", "\"\" = 1", 1, "\"\"", "unknown key"},
            {"theta = 1.0", "deep.er = 1", 5, "fluid.deep", "unknown key"},
            {"[coupling]\nscheme = \"reaction\"", "[[coupling]]\nscheme = \"reaction\"", 20,
             "coupling", "is a section: write [coupling]"},
            {"[drive]\npressure_ratio = 1.5\n", "", 0, "drive.pressure_ratio", "is missing"},
            {"end_time = 1.0", "", 24, "stop.steady_tolerance",
             "at most 0.1; or give end_time, steps or wall_clock"},
            {"pressure_ratio = 1.5",
             "pressure_ratio = 1.5\npressure_inlet = 1\npressure_outlet = 0", 7,
             "drive.pressure_ratio", "not all three"},
            // geometry: the key that is at fault need not be the one that was changed
            {"width_y = 4.7", "width_y = 2.4", 17, "grid.width_y", "at least 2.6 R_0"},
            {"width_z = 4.7", "width_z = 2.4", 18, "grid.width_z", "3 spacings are needed"},
            {spacing, "spacing = 0.1\ntube_offset_y = 1.2", 17, "grid.width_y", "for this offset"},
            {spacing, "spacing = 0.1\ntube_offset_z = -9", 18, "grid.width_z", "for this offset"},
            {spacing, "spacing = 0.25", 11, "vessel.rigid_outlet", "under 2 grid spacings"},
            {"rigid_inlet = 1.2", "rigid_inlet = 13", 9, "vessel.length",
             "is 12.5 R_0; the rigid inlet and outlet together take 13.4 R_0 and leave nothing"},
            {"rigid_inlet = 1.2", "rigid_inlet = 11.8", 9, "vessel.length", "at least 4 spacings"},
            // cells instead of spacing
            {spacing, "cells = 100", 19, "grid.cells", "three whole numbers"},
            {spacing, "cells = [125, 47]", 19, "grid.cells", "three whole numbers"},
            {spacing, "cells = [125, 47, 47.5]", 19, "grid.cells", "three whole numbers"},
            {spacing, "cells = [125, -47, 47]", 19, "grid.cells", "holds -47; each must be"},
            {spacing, "cells = [9000000000000000000, 47, 47]", 19, "grid.cells", "each must be"},
            {spacing, "cells = [1000000, 1000000, 1000000]", 19, "grid.cells", "at most 2e+09"},
            {spacing, "cells = [125, 47, 94]", 19, "grid.cells", "must not differ"},
            {spacing, "cells = [33, 12, 12]", 19, "grid.cells", "it must be greater than 0 and"},
            {spacing, "spacing = 0.1\ncells = [125, 47, 47]", 20, "grid.cells", "not both"},
            // bending and perturbation
            {"eps = 0.02", "eps = 0.02\nbending = 0.01\nbending_thickness = 0.1", 17,
             "wall.bending_thickness", "give it or bending, not both"},
            {"eps = 0.02", "eps = 0.02\n[perturbation]\namplitude = 0.01\nmode = 3\nseed = 1", 19,
             "perturbation.seed", "give it or mode, not both"},
            {"eps = 0.02", "eps = 0.02\n[perturbation]\namplitude = 0.3", 17,
             "perturbation.amplitude", "from 0 to 0.2"},
            {"eps = 0.02", "eps = 0.02\n[perturbation]\nmode = 3", 17, "perturbation.mode",
             "does nothing without an amplitude"},
            {"eps = 0.02", "eps = 0.02\n[perturbation]\nseed = 3", 17, "perturbation.seed",
             "does nothing without an amplitude"},
            // the parameters of the laws
            {nu, "law = \"neo-hookean\"\npoisson_ratio = 0.3", 14, "wall.poisson_ratio",
             "is 0.3, but law = \"neo-hookean\" keeps the wall's volume and so has 0.5 always: "
             "remove this key"},
            {law, "law = \"skalak\"\nskalak_C = 2", 14, "wall.skalak_C",
             "contradicts poisson_ratio"},
            {nu, "law = \"skalak\"\npoisson_ratio = 0.9999", 14, "wall.poisson_ratio",
             "gives C = 9999"},
        });
}

TEST(BadCases, AWrongCombinationInSiIsReportedWithWhatIsAllowed)
{
    const std::string_view G_s = "surface_shear_modulus = \"2 mN/m\"",
                           inlet = "pressure_inlet = \"50 Pa\"";
    expect_answers(
        good_si_case,
        {
            {inlet, "pressure_inlet = 0", 5, "drive.velocity_scale", "without a pressure drop"},
            {inlet, "velocity_scale = \"1 cm/s\"", 5, "drive.pressure_inlet", "is missing"},
            {inlet, "pressure_ratio = 1", 6, "drive.pressure_ratio",
             "belongs to units = \"dimensionless\"; give pressure_inlet instead"},
            {G_s, "surface_shear_modulus = \"2 mN/m\"\nyoungs_modulus = \"5 kPa\"", 14,
             "wall.surface_shear_modulus", "not both"},
            {G_s, "youngs_modulus = \"5 kPa\"", 12, "wall.thickness", "is missing"},
            {G_s, "youngs_modulus = \"5 kPa\"\nthickness = \"1 mm\"", 15, "wall.thickness",
             "is 1 mm (10 R_0); must be greater than 0 and at most 0.05 mm"},
            // a width that is not given: in a handy unit
            {"width_y = \"0.5 mm\"", "tube_offset_y = \"0.12 mm\"", 15, "grid.width_y",
             "at least 500 um (5 R_0) for this offset"},
        });
}

TEST(BadCases, WhatIsNoTomlIsReportedWithItsLine)
{
    for (const auto& [from, to, line] :
         std::initializer_list<std::tuple<std::string_view, std::string_view, int>>{
             {"theta = 1.0", "reynolds = 0.2", 5},
             {"[time]", "[fluid]", 22},
             {"[time]", "[time", 22},
             {"theta = 1.0", "theta = ", 5},
             {"theta = 1.0", "theta = 1.0.0", 5},
             {"law = \"hooke\"", "law = \"hooke", 13},
             {"theta = 1.0", "theta = 1 \xff\xfe", 5},
             {"theta = 1.0", "theta = \x01", 5},
             {"theta = 1.0", "theta = 99999999999999999999", 5}})
        EXPECT_TRUE(holds(problems_of(changed(good_case, from, to)), line, "", "no valid TOML"));
}

std::vector<std::string> keys_of_problems(const std::vector<Problem>& problems)
{
    std::vector<std::string> keys;
    for (const Problem& p : problems) keys.push_back(p.key);
    return keys;
}

TEST(BadCases, ReportAllProblemsOfAFileInTheOrderOfItsLines)
{
    const auto problems = problems_of(R"(units = "dimensionless"
colour = "red"
[fluid]
reynolds = -1
[vessel]
length = "long"
[wall]
law = "rubber"
eps = 0.02
[gird]
spacing = 1
)");
    EXPECT_EQ(keys_of_problems(problems),
              (std::vector<std::string>{"drive.pressure_ratio", "colour", "fluid.reynolds",
                                        "vessel.rigid_inlet", "vessel.rigid_outlet",
                                        "vessel.length", "wall.law", "gird"}));
}

TEST(BadCases, AMisspeltUnitSystemHidesNoOtherProblem)
{
    const auto problems = problems_of(
        changed(changed(changed(good_si_case, "\"si\"", "\"SI\""), "\"10 um\"", "\"1 mm\""),
                "0.1 mm", "0.1 mL"));
    EXPECT_TRUE(holds(problems, 1, "units", "did you mean \"si\""));
    EXPECT_TRUE(holds(problems, 8, "vessel.radius", "is a volume; must be a length"));
    EXPECT_EQ(problems.size(), 2U) << "what follows from them is not to be reported";
    EXPECT_EQ(keys_of_problems(
                  problems_of(changed(changed(good_case, "\"dimensionless\"", "\"dimensionles\""),
                                      "eps = 0.02", "length = 3"))),
              (std::vector<std::string>{"units", "wall.eps", "wall.length"}));
}

TEST(BadCases, AnUnknownUnitSystemHidesOnlyWhatDependsOnIt)
{
    EXPECT_EQ(keys_of_problems(problems_of(R"(units = "imperial"
[fluid]
theta = 3
[vessel]
length = "5 feet"
[wall]
law = "rubber"
psi = "half"
[output]
sample_every = 0
[gird]
spacing = 1
)")),
              (std::vector<std::string>{"units", "fluid.theta", "wall.law", "wall.psi",
                                        "output.sample_every", "gird"}));
}

TEST(BadCases, AnEmptyFileLacksEverythingThatHasNoDefault)
{
    EXPECT_EQ(keys_of_problems(problems_of("")),
              (std::vector<std::string>{"fluid.reynolds", "vessel.length", "vessel.rigid_inlet",
                                        "vessel.rigid_outlet", "wall.law", "wall.eps",
                                        "drive.pressure_ratio"}));
    EXPECT_EQ(keys_of_problems(problems_of("units = \"si\"")),
              (std::vector<std::string>{"vessel.radius", "fluid.density", "drive.pressure_inlet",
                                        "fluid.viscosity", "vessel.length", "vessel.rigid_inlet",
                                        "vessel.rigid_outlet", "wall.law",
                                        "wall.surface_shear_modulus"}));
}

TEST(BadCases, ProblemsOfOverridesNameTheCommandLine)
{
    const std::pair<std::string, std::string_view> bad[] = {
        {"fluid.reynolds=-1", "from 1e-06"},     {"fluid.reynolds=fast", "plain number"},
        {"fluid.renolds=1", "did you mean"},     {"flud.reynolds=1", "unknown section"},
        {"reynolds=1", "it belongs in [fluid]"}, {"fluid=3", "is a section"},
        {"nonsense", "section.key=value"},       {"=3", "section.key=value"},
        {".a=3", "section.key=value"},           {"fluid.=3", "section.key=value"},
        {"title=a\nb", "neither TOML nor"},      {"title=\xff\xfe", "neither TOML nor"},
        {"wall.law={a=1}", "is a table"},        {"grid.width_y=2.4", "3 spacings"},
        {"a.b.c=1", "unknown section"},
    };
    for (const auto& [text, fragment] : bad) {
        const auto problems = problems_of(std::string(good_case), {text});
        ASSERT_EQ(problems.size(), 1U) << text;
        EXPECT_EQ(problems[0].file, "--set") << text;
        EXPECT_EQ(problems[0].line, 0) << text;
        EXPECT_NE(problems[0].message.find(fragment), std::string::npos) << problems[0].message;
    }
}

TEST(BadCases, MessagesHoldNoControlCharacters)
{
    for (const char* text : {"title = 3\n\"\\u001b[2Jx\" = 1", "[\"\\u001b\"]\na = 1",
                             "units = \"\\u001b[31m\"", "[wall]\nlaw = \"\\u0007\""})
        for (const Problem& p : problems_of(text))
            for (char c : p.key + p.message)
                EXPECT_GE(static_cast<unsigned char>(c), 0x20U) << text;
}

TEST(BadCases, FilesThatAreNoCaseFilesAreRefused)
{
    namespace fs = std::filesystem;
    const fs::path dir = fs::path(testing::TempDir()) / "starling_bad_cases";
    fs::create_directories(dir);
    std::ofstream(dir / "empty.toml").flush();
    std::ofstream(dir / "binary.toml").write("\x7f\x45LF\0\1\2", 7);
    std::ofstream(dir / "large.toml") << std::string((1 << 20) + 1, '#');
    for (const fs::path& file :
         {dir, dir / "missing.toml", dir / "empty.toml", dir / "empty.toml" / "below.toml",
          dir / "binary.toml", dir / "large.toml", fs::path("/dev/zero"), fs::path()})
        EXPECT_THROW(read_case(file), InputError) << file;
    fs::remove_all(dir);
}

TEST(BadCases, ASharedFaultIsReportedOnce)
{
    EXPECT_EQ(keys_of_problems(problems_of(changed(good_si_case, "\"0.1 mm\"", "1"))),
              (std::vector<std::string>{"vessel.radius"}));
}

/// The message at `key` of the good case with a waveform at the inlet made of these lines.
std::string waveform_message(std::string_view key, const std::string& lines)
{
    for (const Problem& p : problems_of(std::string(good_case) + "[inlet_waveform]\n" + lines))
        if (p.key == "inlet_waveform." + std::string(key)) return p.message;
    return "";
}

TEST(BadCases, WaveformsThatAreIncompleteOrContradictThemselves)
{
    const std::string a = "amplitude = 1.0\n", T = "period = 2.0\n";
    struct Row {
        std::string lines;
        std::string_view key, fragment;
    };
    const Row rows[] = {
        {"cosine = [1.0]\n" + T, "amplitude", "is missing"},
        {a + T, "amplitude", "needs one shape"},
        {a + T + "cosine = [1.0]\ntimes = [0.0]\nvalues = [1]\n", "amplitude", "needs one shape"},
        {a + "cosine = [1.0]\n", "period", "is missing"},
        {a + T + "cosine = []\n", "cosine", "is empty"},
        {a + T + "cosine = 1.0\n", "cosine", "must be an array of plain numbers"},
        {a + T + "cosine = ['1']\n", "cosine", "an array of other things than numbers"},
        {a + T + "cosine = [nan]\n", "cosine", "each must be from -1e+06 to 1e+06"},
        {a + T + "sine = [2e6]\n", "sine", "holds 2e+06"},
        {a + T + "sine = [1]\ntime_scale = 1.0\n", "time_scale", "belongs to a table"},
        {a + "times = [0, 1]\nvalues = [1, 2]\n", "time_scale", "or give a period"},
        {a + T + "times = [0, 1]\n", "values", "is missing"},
        {a + T + "times = [0, 0.5]\nvalues = [1, 2, 3]\n", "values", "holds 3 numbers for 2 times"},
        {a + T + "times = [0.5, 0.2]\nvalues = [1, 2]\n", "times",
         "do not increase from 0 at row 2"},
        {a + T + "times = [0, 1.5]\nvalues = [1, 2]\n", "times", "past the period"},
        {a + T + "times = [0, 1]\nvalues = [1, 2]\n", "times", "other values at the end"},
        {a + T + "file = 'none.csv'\n", "file", "no such file"},
    };
    for (const auto& [lines, key, fragment] : rows)
        EXPECT_NE(waveform_message(key, lines).find(fragment), std::string::npos)
            << lines << key << ": " << waveform_message(key, lines);
}

TEST(BadCases, ADriveWithAWaveformIsNeverSteady)
{
    const std::string waveform = "[inlet_waveform]\namplitude = 1.0\nperiod = 1.0\nsine = [1]\n";
    const std::string steady =
        changed(good_case, "end_time = 1.0", "steady_tolerance = 1e-4") + waveform;
    EXPECT_TRUE(holds(problems_of(steady), 25, "stop.steady_tolerance", "cannot be met"));
    const std::string none = changed(good_case, "[stop]\nend_time = 1.0\n", "") + waveform;
    const auto problems = problems_of(none);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].key, "stop.end_time");
}

TEST(BadCases, OnlyADriveThatRepeatsBecomesPeriodic)
{
    const std::string periodic = changed(good_case, "end_time = 1.0", "periodic_tolerance = 0.01");
    const std::string series = "[inlet_waveform]\namplitude = 1.0\nperiod = 1.0\nsine = [1]\n";
    const std::string table = "[inlet_waveform]\namplitude = 1.0\ntime_scale = 1.0\n"
                              "times = [0, 1]\nvalues = [0, 1]\n";
    const std::string other =
        "[outlet_waveform]\namplitude = 1.0\nperiod = 1.41421356\nsine = [1]\n";
    EXPECT_TRUE(problems_of(periodic + series).empty());
    for (const std::string& drive : {std::string(), table, series + other})
        EXPECT_TRUE(holds(problems_of(periodic + drive), 25, "stop.periodic_tolerance", "period"))
            << drive;
    const std::string few =
        changed(periodic, "step = \"auto\"", "step = \"auto\"\ncycle_samples = 7");
    EXPECT_TRUE(holds(problems_of(few + series), 24, "time.cycle_samples", "at least 8"));
}

TEST(BadCases, EndsThatAreGivenTwice)
{
    const std::string flow = std::string(good_case) + "[inlet_flow]\nmean = 1.0\n";
    EXPECT_TRUE(holds(problems_of(flow), 7, "drive.pressure_ratio", "the inlet has a flow rate"));
    const std::string none = changed(good_case, "pressure_ratio = 1.5\n", "") + "[inlet_flow]\n";
    EXPECT_TRUE(holds(problems_of(none), 27, "inlet_flow.mean", "or give a waveform"));
    const std::string windkessel = std::string(good_case) + "[windkessel]\nR1 = 1.0\nR2 = 0.0\n";
    const auto problems = problems_of(windkessel);
    EXPECT_TRUE(holds(problems, 7, "drive.pressure_ratio", "follows from [windkessel]"));
    EXPECT_TRUE(holds(problems, 28, "windkessel.C", "is missing"));
    EXPECT_TRUE(holds(problems, 30, "windkessel.R2", "greater than 0"));
    EXPECT_TRUE(holds(problems_of(windkessel + "C = 1.0\n[outlet_waveform]\namplitude = 1.0\n"), 33,
                      "outlet_waveform.amplitude", "leave it out"));
}

} // namespace
} // namespace starling
