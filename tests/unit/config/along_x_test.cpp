#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "case_text.hpp"
#include "config/read_case.hpp"
#include "config/write_case.hpp"
#include "core/error.hpp"
#include "same_case.hpp"

namespace starling {
namespace {

using test::good_case;
using test::good_si_case;

/// The message at `key` of the good case with these lines behind it; "" where there is none.
std::string message(const std::string& lines, const std::string& key)
{
    try {
        read_case_text(std::string(good_case) + lines, "case");
    } catch (const InputError& e) {
        for (const Problem& p : e.problems())
            if (p.key == key) return p.message;
    }
    return "";
}

const std::string bump = "[rest_radius]\nshape = \"bump\"\nposition = 6.0\nlength = 4.0\n";

TEST(PropertiesAlongX, ReadBackToTheSameBits)
{
    const std::vector<std::string> table = {"stiffness.x=[1, 2.7, 3.1]",
                                            "stiffness.values=[1, 0.3, 2.2]"};
    for (const auto& [text, position, length] :
         {std::tuple{good_case, "6.1", "4.3"}, std::tuple{good_si_case, "0.61 mm", "430 um"}}) {
        std::vector<std::string> overrides = {
            "rest_radius.shape=bump", std::string("rest_radius.position=") + position,
            std::string("rest_radius.length=") + length, "rest_radius.change=-0.31"};
        overrides.insert(overrides.end(), table.begin(), table.end());
        Case c;
        try {
            c = read_case_text(text, "good", overrides);
        } catch (const InputError& e) {
            ADD_FAILURE() << e.what();
            continue;
        }
        EXPECT_EQ(c.tube.rest_radius.change, -0.31);
        EXPECT_EQ(c.material.stiffness.values[1], 0.3);
        EXPECT_TRUE(test::same(c, read_case_text(write_case(c), "written"))) << write_case(c);
    }
}

TEST(PropertiesAlongX, ATableMayStandInAFileInItsOwnUnit)
{
    const auto folder = std::filesystem::temp_directory_path() / "starling_along_x_test";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "stiffness.csv") << "x,value\n1,1\n2,3\n";
    std::ofstream(folder / "case.toml")
        << good_case << "[stiffness]\nfile = \"stiffness.csv\"\nx_scale = 2.0\n";
    const AlongX a = read_case(folder / "case.toml").material.stiffness;
    EXPECT_EQ(a.x, (std::vector<Real>{2, 4}));
    EXPECT_EQ(a(3), 2);
    std::filesystem::remove_all(folder);
}

TEST(PropertiesAlongX, WhatCannotWorkIsRefused)
{
    const std::string none;
    EXPECT_EQ(message(bump + "change = -0.3\n", "rest_radius.shape"), none);
    EXPECT_NE(message(bump, "rest_radius.change"), none);
    EXPECT_NE(message(bump + "change = -0.3\nx = [1]\n", "rest_radius.shape").find("one"),
              std::string::npos);
    EXPECT_NE(message("[rest_radius]\nshape = \"bump\"\nposition = 0.5\nlength = 4.0\n"
                      "change = 0.3\n",
                      "rest_radius.shape")
                  .find("1 at both ends"),
              std::string::npos);
    EXPECT_NE(message("[rest_radius]\nx = [1, 2, 3]\nvalues = [1, 1.2]\n", "rest_radius.values"),
              none);
    EXPECT_NE(message("[stiffness]\nx = [1, 1]\nvalues = [1, 2]\n", "stiffness.x"), none);
    EXPECT_NE(message("[stiffness]\nfile = \"nowhere.csv\"\n", "stiffness.file"), none);
    EXPECT_NE(message(bump + "change = 1.2\n", "grid.width_y").find("between the tube"),
              std::string::npos)
        << "an aneurysm must fit the box";
}

} // namespace
} // namespace starling
