#include "config/shipped_cases.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "config/read_case.hpp"
#include "core/error.hpp"
#include "same_case.hpp"

namespace starling {
namespace {

const std::filesystem::path folder = std::filesystem::path(STARLING_SOURCE_DIR) / "cases";

TEST(ShippedCases, AreTheFilesOfTheFolder)
{
    std::set<std::string> files, carried;
    for (const auto& file : std::filesystem::directory_iterator(folder))
        if (file.path().extension() == ".toml") files.insert(file.path().stem().string());
    for (const ShippedCase& c : shipped_cases()) {
        carried.emplace(c.name);
        std::ostringstream text;
        text << std::ifstream(folder / (std::string(c.name) + ".toml")).rdbuf();
        EXPECT_EQ(text.str(), c.text) << c.name;
    }
    EXPECT_EQ(files, carried);
}

TEST(ShippedCases, ReadAndRoundTrip)
{
    for (const ShippedCase& s : shipped_cases()) {
        const Case c = read_case_text(s.text, std::string(s.name));
        EXPECT_TRUE(test::same(c, read_case_text(write_case(c), "written"))) << write_case(c);
        EXPECT_TRUE(test::same(c, read_case(folder / (std::string(s.name) + ".toml"))));
    }
}

TEST(ShippedCases, SayWhatTheyShowAndHowLongTheyTake)
{
    for (const ShippedCase& c : shipped_cases()) {
        EXPECT_GT(c.description.size(), 20U) << c.name;
        EXPECT_NE(c.text.find("# Takes "), std::string_view::npos) << c.name;
    }
}

TEST(ShippedCases, TheMainCaseIsThatOfThePaper)
{
    const Case c = read_case_text(shipped_case("inflation").text, "inflation");
    EXPECT_EQ(c.fluid.reynolds, 0.1);
    EXPECT_EQ(c.tube.length, 4 * pi);
    EXPECT_NEAR(c.tube.length - c.tube.rigid_inlet - c.tube.rigid_outlet, 11, 0.01);
    EXPECT_EQ(c.material.law, ElasticLaw::hooke);
    EXPECT_EQ(c.material.eps, 0.02);
    EXPECT_DOUBLE_EQ(c.pressure_ratio(), 1.5);
}

TEST(ShippedCases, TheExampleOfTheReadmeIsTheMainCase)
{
    std::ostringstream text;
    text << std::ifstream(std::string(STARLING_SOURCE_DIR) + "/README.md").rdbuf();
    const std::string readme = text.str(), fence = "```toml\n";
    const auto begin = readme.find(fence) + fence.size();
    Case example =
        read_case_text(readme.substr(begin, readme.find("```", begin) - begin), "README");
    const Case main = read_case_text(shipped_case("inflation").text, "inflation");
    EXPECT_NEAR(example.tube.length, main.tube.length, 1e-3); // rounded for the reader
    EXPECT_DOUBLE_EQ(example.pressure_ratio(), main.pressure_ratio());
    example.title = main.title;
    example.tube.length = main.tube.length;
    example.drive = main.drive;
    example.stop = main.stop;
    EXPECT_TRUE(test::same(example, main)) << write_case(example);
}

TEST(ShippedCases, AMisspeltNameIsAnsweredWithTheNearest)
{
    try {
        shipped_case("inflaton");
        FAIL();
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("did you mean \"inflation\""), std::string::npos);
    }
}

} // namespace
} // namespace starling
