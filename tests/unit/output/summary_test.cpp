#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "output/summary.hpp"
#include "output/version.hpp"
#include "synthetic.hpp"
#include "temporary_directory.hpp"

namespace starling {
namespace {

Summary example()
{
    Summary s;
    s.title = "a \"quoted\" title";
    s.converged = true;
    s.reason = "steady";
    s.last.t = 3;
    s.last.step = 40;
    s.last.Q_in = s.last.Q_mid = s.last.Q_out = pi;
    s.last.R_max = 1.22;
    s.last.leak = -pi / 100;
    s.theory = TheoryValues{pi / 1.01, 1.2};
    s.phase_seconds = {{"momentum", 1.5}};
    return s;
}

TEST(Summary, HasNoLeakOverAFlowThatIsNone)
{
    Summary s = example();
    s.last.Q_in = 1e-9;
    s.last.Q_mid = s.last.Q_out = 0;
    EXPECT_TRUE(nlohmann::json::parse(summary_json(s, Scaling{}))["leak_over_Q"].is_null());
    s.last.Q_in = -2 * pi; // filled from both ends: nothing passes the middle
    EXPECT_DOUBLE_EQ(s.leak_over_Q(), -0.005);
}

TEST(Summary, ListsWarnings)
{
    Summary s = example();
    EXPECT_TRUE(nlohmann::json::parse(summary_json(s, Scaling{}))["warnings"].empty());
    s.warnings = {"a leak"};
    EXPECT_EQ(nlohmann::json::parse(summary_json(s, Scaling{}))["warnings"][0], "a leak");
}

TEST(Summary, HoldsWhatScriptsRelyOn)
{
    const auto json = nlohmann::json::parse(summary_json(example(), Scaling{}));
    for (const char* key : {"converged",
                            "reason",
                            "t",
                            "steps",
                            "dt",
                            "Q_in",
                            "Q_mid",
                            "Q_out",
                            "Q_mid_over_Q0",
                            "leak_over_Q",
                            "R_max",
                            "x_R_max",
                            "max_strain",
                            "wall_seconds",
                            "cell_steps_per_second",
                            "threads",
                            "peak_memory_bytes",
                            "cells",
                            "vertices",
                            "elements",
                            "version"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["converged"], true);
    EXPECT_EQ(json["steps"], 40);
    EXPECT_DOUBLE_EQ(json["Q_mid_over_Q0"], 2);
    EXPECT_DOUBLE_EQ(json["leak_over_Q"], -0.01);
    EXPECT_EQ(json["phase_seconds"]["momentum"], 1.5);
}

TEST(Summary, ComparesWithTheory)
{
    const auto json = nlohmann::json::parse(summary_json(example(), Scaling{}))["theory"];
    EXPECT_NEAR(json["Q_relative_difference"], 0.01, 1e-12);
    EXPECT_NEAR(json["displacement_relative_difference"], 0.1, 1e-12);
}

TEST(Summary, WithoutTheorySaysNull)
{
    Summary s = example();
    s.theory.reset();
    EXPECT_TRUE(nlohmann::json::parse(summary_json(s, Scaling{}))["theory"].is_null());
}

TEST(Summary, NamesTheUnitOfEveryScaledNumber)
{
    const auto json = nlohmann::json::parse(summary_json(example(), synthetic::si_scaling()));
    EXPECT_EQ(json["units"]["Q_mid"], "m^3/s");
    EXPECT_DOUBLE_EQ(json["Q_mid"], 12 * pi);
    EXPECT_DOUBLE_EQ(json["t"], 2);
    EXPECT_DOUBLE_EQ(json["R_max"], 2.44);
}

TEST(Summary, NonFiniteNumbersAreNull)
{
    Summary s = example();
    s.last.Q_in = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_TRUE(nlohmann::json::parse(summary_json(s, Scaling{}))["Q_in"].is_null());
}

TEST(Summary, ReplacesTheFileAsAWhole)
{
    TemporaryDirectory dir;
    write_text(dir.path() / "summary.json", std::string(100000, 'x'));
    write_summary(dir.path() / "summary.json", example(), Scaling{});
    EXPECT_EQ(read_text(dir.path() / "summary.json"), summary_json(example(), Scaling{}));
}

TEST(Version, StartsWithTheRelease) { EXPECT_EQ(version().substr(0, 2), "0."); }

TEST(Memory, PeakIsThatOfARealProcess) { EXPECT_GT(peak_memory_bytes(), 100000); }

} // namespace
} // namespace starling
