#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "case_text.hpp"
#include "config/read_case.hpp"
#include "core/error.hpp"

namespace starling {
namespace {

using test::changed;
using test::good_case;
using test::good_si_case;

struct BadCase {
    std::string_view from, to; ///< the change to a good case
    int line;
    std::string_view key, fragment;
};

void PrintTo(const BadCase& b, std::ostream* out) { *out << b.from << " -> " << b.to; }

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

testing::AssertionResult holds(const std::vector<Problem>& problems, const BadCase& b)
{
    auto result = testing::AssertionFailure();
    for (const Problem& p : problems) {
        if (p.line == b.line && p.key == b.key && p.file == "a.toml" &&
            p.message.find(b.fragment) != std::string::npos)
            return testing::AssertionSuccess();
        result << p.file << ":" << p.line << ": " << p.key << ": " << p.message << "\n";
    }
    return result;
}

class BadDimensionlessCase : public testing::TestWithParam<BadCase> {};

TEST_P(BadDimensionlessCase, IsReportedWithLineKeyAndWhatIsAllowed)
{
    const auto problems = problems_of(changed(good_case, GetParam().from, GetParam().to));
    EXPECT_EQ(problems.size(), 1U);
    EXPECT_TRUE(holds(problems, GetParam()));
}

const BadCase dimensionless_cases[] = {
    // names
    {"reynolds = 0.1", "reynolds = 0.1\nreynold = 1", 5, "fluid.reynold",
     "did you mean \"reynolds\""},
    {"eps = 0.02", "eps = 0.02\nEPS = 1", 16, "wall.EPS", "did you mean \"eps\""},
    {"theta", "thtea", 5, "fluid.thtea", "did you mean \"theta\"? (allowed: reynolds"},
    {"theta = 1.0", "zzz = 1", 5, "fluid.zzz", "unknown key; allowed: reynolds, theta"},
    {"theta = 1.0", "eps = 1", 5, "fluid.eps", "it belongs in [wall]"},
    {"[coupling]", "[couplings]", 20, "couplings", "did you mean \"coupling\""},
    {"[time]", "[qqqqqqqq]", 22, "qqqqqqqq", "unknown section; allowed: fluid, drive"},
    {"title", "name", 1, "name", "allowed: title, units"},
    {"title = \"a tube\"", "spacing = 0.1", 1, "spacing", "it belongs in [grid]"},
    {"title = \"a tube\"", "\"fluid.theta\" = 1", 1, "fluid.theta", "unknown key"},
    {"title = \"a tube\"", "\"\" = 1", 1, "\"\"", "unknown key"},
    {"theta = 1.0", "deep.er = 1", 5, "fluid.deep", "unknown key"},
    {"[coupling]\nscheme = \"reaction\"", "[[coupling]]\nscheme = \"reaction\"", 20, "coupling",
     "is a section: write [coupling]"},
    {"law = \"hooke\"", "law = \"hook\"", 13, "wall.law", "did you mean \"hooke\""},
    {"law = \"hooke\"", "law = \"\"", 13, "wall.law", "allowed: hooke, neo-hookean"},
    {"\"reaction\"", "\"reactoin\"", 21, "coupling.scheme", "did you mean \"reaction\""},
    {"\"dimensionless\"", "\"SI\"", 2, "units", "did you mean \"si\""},
    {"\"dimensionless\"", "\"imperial\"", 2, "units", "allowed: dimensionless, si"},
    {"\"dimensionless\"", "3", 2, "units", "must be one of"},
    // types
    {"title = \"a tube\"", "title = 3", 1, "title", "must be text"},
    {"reynolds = 0.1", "reynolds = \"0.1\"", 4, "fluid.reynolds", "must be a plain number"},
    {"reynolds = 0.1", "reynolds = true", 4, "fluid.reynolds", "is true; must be a plain number"},
    {"reynolds = 0.1", "reynolds = [0.1]", 4, "fluid.reynolds", "must be a plain number"},
    {"reynolds = 0.1", "reynolds = 1979-05-27", 4, "fluid.reynolds", "is a date or time"},
    {"reynolds = 0.1", "reynolds = {a = 1}", 4, "fluid.reynolds", "is a table"},
    {"length = 12.5", "length = \"5 mm\"", 9, "vessel.length", "need units = \"si\""},
    {"length = 12.5", "length = 12.5\nrigid = \"no\"", 10, "vessel.rigid", "true or false"},
    {"length = 12.5", "length = 12.5\nrigid = 0", 10, "vessel.rigid",
     "is 0; must be true or false"},
    {"sample_every = 10", "sample_every = 10.5", 27, "output.sample_every", "whole number"},
    {"sample_every = 10", "sample_every = \"ten\"", 27, "output.sample_every", "whole number"},
    {"sample_every = 10", "sample_every = nan", 27, "output.sample_every", "whole number"},
    {"spacing = 0.1", "cells = 100", 19, "grid.cells", "three whole numbers"},
    {"spacing = 0.1", "cells = [125, 47]", 19, "grid.cells", "three whole numbers"},
    {"spacing = 0.1", "cells = [125, 47, 47.5]", 19, "grid.cells", "three whole numbers"},
    {"step = \"auto\"", "step = \"small\"", 23, "time.step", "or \"auto\""},
    {"end_time = 1.0", "wall_clock = \"5 mm\"", 25, "stop.wall_clock",
     "is a length; must be a time"},
    {"sample_every = 10", "precision = \"half\"", 27, "output.precision", "single, double"},
    {"sample_every = 10", "wall = 1", 27, "output.wall", "true or false"},
    // ranges
    {"reynolds = 0.1", "reynolds = 0", 4, "fluid.reynolds", "from 1e-06 to 10000"},
    {"reynolds = 0.1", "reynolds = -0.1", 4, "fluid.reynolds", "from 1e-06 to 10000"},
    {"reynolds = 0.1", "reynolds = nan", 4, "fluid.reynolds", "must be finite"},
    {"reynolds = 0.1", "reynolds = inf", 4, "fluid.reynolds", "must be finite"},
    {"reynolds = 0.1", "reynolds = 1e300", 4, "fluid.reynolds", "from 1e-06 to 10000"},
    {"theta = 1.0", "theta = 0.4", 5, "fluid.theta", "from 0.5 to 1"},
    {"pressure_ratio = 1.5", "pressure_ratio = -inf", 7, "drive.pressure_ratio", "finite"},
    {"pressure_ratio = 1.5", "pressure_ratio = 1e9", 7, "drive.pressure_ratio", "from -1000"},
    {"pressure_ratio = 1.5", "pressure_inlet = 1e30", 7, "drive.pressure_inlet", "to 1e+12"},
    {"length = 12.5", "length = -12.5", 9, "vessel.length", "from 0.5 to 10000"},
    {"length = 12.5", "length = 1e9", 9, "vessel.length", "from 0.5 to 10000"},
    {"rigid_inlet = 1.2", "rigid_inlet = -1", 10, "vessel.rigid_inlet", "greater than 0"},
    {"rigid_outlet = 0.4", "rigid_outlet = 0", 11, "vessel.rigid_outlet", "greater than 0"},
    {"eps = 0.02", "eps = 0", 15, "wall.eps", "from 1e-08 to 10"},
    {"eps = 0.02", "eps = -0.02", 15, "wall.eps", "from 1e-08 to 10"},
    {"poisson_ratio = 0.5", "poisson_ratio = 1.0", 14, "wall.poisson_ratio", "less than 1"},
    {"poisson_ratio = 0.5", "poisson_ratio = -0.1", 14, "wall.poisson_ratio", "at least 0"},
    {"poisson_ratio = 0.5", "edge_over_spacing = 5", 14, "wall.edge_over_spacing", "0.2 to 2"},
    {"width_y = 4.7", "width_y = 1.5", 17, "grid.width_y", "greater than 2"},
    {"width_z = 4.7", "width_z = -4.7", 18, "grid.width_z", "greater than 2"},
    {"spacing = 0.1", "spacing = 0", 19, "grid.spacing", "greater than 0 and at most 0.34"},
    {"spacing = 0.1", "spacing = -0.1", 19, "grid.spacing", "greater than 0"},
    {"spacing = 0.1", "spacing = 0.5", 19, "grid.spacing", "at most 0.34"},
    {"spacing = 0.1", "cells = [125, -47, 47]", 19, "grid.cells", "holds -47; each must be"},
    {"spacing = 0.1", "cells = [9000000000000000000, 47, 47]", 19, "grid.cells", "each must be"},
    {"spacing = 0.1", "spacing = 0.1\ntube_offset_y = nan", 20, "grid.tube_offset_y", "finite"},
    {"step = \"auto\"", "step = 0", 23, "time.step", "greater than 0"},
    {"step = \"auto\"", "step = -1e-3", 23, "time.step", "greater than 0"},
    {"step = \"auto\"", "safety = 3", 23, "time.safety", "at most 2"},
    {"end_time = 1.0", "end_time = -1.0", 25, "stop.end_time", "greater than 0"},
    {"end_time = 1.0", "steps = 0", 25, "stop.steps", "from 1 to 1e+09"},
    {"end_time = 1.0", "steps = 9000000000000000000", 25, "stop.steps", "from 1 to 1e+09"},
    {"end_time = 1.0", "steady_tolerance = 1", 25, "stop.steady_tolerance", "at most 0.1"},
    {"end_time = 1.0", "wall_clock = -5", 25, "stop.wall_clock", "greater than 0"},
    {"sample_every = 10", "sample_every = 0", 27, "output.sample_every", "from 1"},
    {"sample_every = 10", "fluid_every = 0.0", 27, "output.fluid_every", "greater than 0"},
    // geometry and other combinations
    {"width_y = 4.7", "width_y = 2.4", 17, "grid.width_y", "at least 2.6 R_0"},
    {"width_z = 4.7", "width_z = 2.4", 18, "grid.width_z", "3 spacings are needed"},
    {"spacing = 0.1", "spacing = 0.1\ntube_offset_y = 1.2", 17, "grid.width_y", "for this offset"},
    {"spacing = 0.1", "spacing = 0.1\ntube_offset_z = -9", 18, "grid.width_z", "for this offset"},
    {"spacing = 0.1", "spacing = 0.25", 11, "vessel.rigid_outlet", "under 2 grid spacings"},
    {"rigid_inlet = 1.2", "rigid_inlet = 0.15", 10, "vessel.rigid_inlet", "under 2 grid spacings"},
    {"rigid_inlet = 1.2", "rigid_inlet = 13", 9, "vessel.length", "leave nothing that deforms"},
    {"rigid_inlet = 1.2", "rigid_inlet = 11.8", 9, "vessel.length", "at least 4 spacings"},
    {"spacing = 0.1", "spacing = 1e-4", 19, "grid.spacing", "cells; at most 2e+09"},
    {"spacing = 0.1", "spacing = 1e-300", 19, "grid.spacing", "cells; at most 2e+09"},
    {"spacing = 0.1", "cells = [1000000, 1000000, 1000000]", 19, "grid.cells", "at most 2e+09"},
    {"spacing = 0.1", "cells = [125, 47, 94]", 19, "grid.cells", "must not differ"},
    {"spacing = 0.1", "cells = [33, 12, 12]", 19, "grid.cells", "it must be greater than 0 and"},
    {"spacing = 0.1", "spacing = 0.1\ncells = [125, 47, 47]", 20, "grid.cells", "not both"},
    {"step = \"auto\"", "step = 1e-12", 23, "time.step", "needs 1e+12 steps"},
    {"step = \"auto\"", "step = 2", 23, "time.step", "longer than end_time"},
    {"end_time = 1.0", "", 24, "stop.steady_tolerance", "is missing"},
    {"pressure_ratio = 1.5", "pressure_ratio = 1.5\npressure_inlet = 1\npressure_outlet = 0", 7,
     "drive.pressure_ratio", "not all three"},
    {"eps = 0.02", "eps = 0.02\npsi = 0.5", 16, "wall.psi", "law = \"mooney-rivlin\" only"},
    {"eps = 0.02", "eps = 0.02\nskalak_C = 1", 16, "wall.skalak_C", "law = \"skalak\" only"},
    {"law = \"hooke\"\npoisson_ratio = 0.5", "law = \"neo-hookean\"\npoisson_ratio = 0.3", 14,
     "wall.poisson_ratio", "is 0.5 for this law"},
    {"law = \"hooke\"", "law = \"skalak\"\nskalak_C = 2", 14, "wall.skalak_C",
     "contradicts poisson_ratio"},
    {"law = \"hooke\"\npoisson_ratio = 0.5", "law = \"skalak\"\npoisson_ratio = 0.9999", 14,
     "wall.poisson_ratio", "gives C = 9999"},
    // missing
    {"reynolds = 0.1", "", 3, "fluid.reynolds", "is missing: Reynolds number"},
    {"pressure_ratio = 1.5", "", 6, "drive.pressure_ratio", "is missing"},
    {"[drive]\npressure_ratio = 1.5\n", "", 0, "drive.pressure_ratio", "is missing"},
    {"length = 12.5", "", 8, "vessel.length", "is missing: length of the tube"},
    {"rigid_outlet = 0.4", "", 8, "vessel.rigid_outlet", "is missing"},
    {"law = \"hooke\"", "", 12, "wall.law", "is missing: elastic law"},
    {"eps = 0.02", "", 12, "wall.eps", "is missing: deformability"},
    // the other unit system
    {"reynolds = 0.1", "reynolds = 0.1\ndensity = \"1 kg/m^3\"", 5, "fluid.density",
     "belongs to units = \"si\"; give reynolds"},
    {"length = 12.5", "length = 12.5\nradius = 1", 10, "vessel.radius", "leave it out"},
    {"eps = 0.02", "eps = 0.02\nthickness = 1", 16, "wall.thickness", "give eps"},
    // no TOML
    {"theta = 1.0", "reynolds = 0.2", 5, "", "no valid TOML"},
    {"[time]", "[fluid]", 22, "", "no valid TOML"},
    {"[time]", "[time", 22, "", "no valid TOML"},
    {"theta = 1.0", "theta = ", 5, "", "no valid TOML"},
    {"theta = 1.0", "theta = 1.0.0", 5, "", "no valid TOML"},
    {"law = \"hooke\"", "law = \"hooke", 13, "", "no valid TOML"},
    {"theta = 1.0", "theta = 1 \xff\xfe", 5, "", "no valid TOML"},
    {"theta = 1.0", "theta = \x01", 5, "", "no valid TOML"},
    {"theta = 1.0", "theta = 99999999999999999999", 5, "", "no valid TOML"},
};
INSTANTIATE_TEST_SUITE_P(All, BadDimensionlessCase, testing::ValuesIn(dimensionless_cases));

class BadSiCase : public testing::TestWithParam<BadCase> {};

TEST_P(BadSiCase, IsReportedWithLineKeyAndWhatIsAllowed)
{
    EXPECT_TRUE(
        holds(problems_of(changed(good_si_case, GetParam().from, GetParam().to)), GetParam()));
}

const BadCase si_cases[] = {
    {"\"50 Pa\"", "\"5 mm\"", 6, "drive.pressure_inlet",
     "is a length; must be a pressure (Pa, kPa"},
    {"\"50 Pa\"", "\"5\"", 6, "drive.pressure_inlet", "has no unit"},
    {"\"50 Pa\"", "50", 6, "drive.pressure_inlet", "must be a pressure with a unit"},
    {"\"50 Pa\"", "\"50 pa\"", 6, "drive.pressure_inlet", "unknown unit \"pa\""},
    {"\"50 Pa\"", "\"nan Pa\"", 6, "drive.pressure_inlet", "must be finite"},
    {"\"50 Pa\"", "\"inf Pa\"", 6, "drive.pressure_inlet", "must be finite"},
    {"\"50 Pa\"", "\"1e99999 Pa\"", 6, "drive.pressure_inlet", "too large"},
    {"\"50 Pa\"", "\"1e300 Pa\"", 6, "drive.pressure_inlet", "out of any physical range"},
    {"\"50 Pa\"", "\"Pa\"", 6, "drive.pressure_inlet", "must start with a number"},
    {"\"50 Pa\"", "\"\"", 6, "drive.pressure_inlet", "must start with a number"},
    {"\"50 Pa\"", "0", 5, "drive.velocity_scale", "without a pressure drop"},
    {"pressure_inlet = \"50 Pa\"", "", 5, "drive.pressure_inlet", "is missing"},
    {"pressure_inlet = \"50 Pa\"", "velocity_scale = \"1 cm/s\"", 5, "drive.pressure_inlet",
     "is missing"},
    {"pressure_inlet = \"50 Pa\"", "pressure_ratio = 1", 6, "drive.pressure_ratio",
     "belongs to units = \"dimensionless\"; give pressure_inlet"},
    {"\"0.1 mm\"", "\"-0.1 mm\"", 8, "vessel.radius", "must be greater than 0"},
    {"\"0.1 mm\"", "\"0 mm\"", 8, "vessel.radius", "must be greater than 0"},
    {"\"0.1 mm\"", "\"0.1 mL\"", 8, "vessel.radius", "is a volume; must be a length"},
    {"radius = \"0.1 mm\"", "", 7, "vessel.radius", "is missing"},
    {"\"0.5 mm\"", "\"0.22 mm\"", 16, "grid.width_y", "3 spacings are needed"},
    {"viscosity = \"4 mPa s\"", "reynolds = 0.1", 4, "fluid.reynolds",
     "give density and viscosity"},
    {"\"4 mPa s\"", "\"4 Pa\"", 4, "fluid.viscosity", "is a pressure; must be a viscosity"},
    {"\"4 mPa s\"", "\"4e-9 Pa s\"", 4, "fluid.viscosity", "gives a Reynolds number"},
    {"\"1060 kg/m^3\"", "\"1060 kg\"", 3, "fluid.density", "is something in kg"},
    {"\"1060 kg/m^3\"", "\"1060 kg/m^\"", 3, "fluid.density", "exponent"},
    {"\"10 um\"", "0.1", 18, "grid.spacing", "must be a length with a unit"},
    {"\"10 um\"", "\"10 mm\"", 18, "grid.spacing", "is 100 R_0; must be greater than 0"},
    {"\"2 mN/m\"", "\"2 N/mm/s\"", 14, "wall.surface_shear_modulus", "must be a force per length"},
    {"\"2 mN/m\"", "\"2e-12 N/m\"", 14, "wall.surface_shear_modulus", "gives a deformability"},
    {"\"2 mN/m\"", "\"2 mN/m\"\nyoungs_modulus = \"5 kPa\"", 14, "wall.surface_shear_modulus",
     "not both"},
    {"surface_shear_modulus = \"2 mN/m\"", "", 12, "wall.surface_shear_modulus", "is missing"},
    {"surface_shear_modulus = \"2 mN/m\"", "youngs_modulus = \"5 kPa\"", 12, "wall.thickness",
     "is missing"},
    {"surface_shear_modulus = \"2 mN/m\"", "eps = 0.02", 14, "wall.eps", "surface_shear_modulus"},
    {"surface_shear_modulus = \"2 mN/m\"", "youngs_modulus = \"5 kPa\"\nthickness = \"1 mm\"", 15,
     "wall.thickness", "is 10 R_0; must be greater than 0 and at most 0.5"},
    {"\"20 ms\"", "\"20 m s\"", 20, "stop.end_time", "must be a time"},
    {"\"20 ms\"", "\"20 s/m s\"", 20, "stop.end_time", "its own \"/\""},
};
INSTANTIATE_TEST_SUITE_P(All, BadSiCase, testing::ValuesIn(si_cases));

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

} // namespace
} // namespace starling
