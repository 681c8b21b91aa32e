#include "config/nearest_name.hpp"

#include <gtest/gtest.h>

namespace starling {
namespace {

TEST(EditDistance, CountsEdits)
{
    EXPECT_EQ(edit_distance("spacing", "spacing"), 0);
    EXPECT_EQ(edit_distance("Spacing", "spacing"), 0);
    EXPECT_EQ(edit_distance("spacng", "spacing"), 1);
    EXPECT_EQ(edit_distance("spaicng", "spacing"), 1);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
    EXPECT_EQ(edit_distance("", "abc"), 3);
    EXPECT_EQ(edit_distance("abc", ""), 3);
}

TEST(EditDistance, IsSymmetric)
{
    const char* words[] = {"", "eps", "psi", "spacing", "step", "steps", "thickness"};
    for (const char* a : words)
        for (const char* b : words) EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
}

TEST(NearestName, FindsTypingErrorsAndNothingElse)
{
    const std::vector<std::string_view> names = {"width_y", "width_z", "spacing", "cells"};
    EXPECT_EQ(nearest_name("spaceing", names), "spacing");
    EXPECT_EQ(nearest_name("cell", names), "cells");
    EXPECT_EQ(nearest_name("WIDTH_Z", names), "width_z");
    EXPECT_EQ(nearest_name("viscosity", names), "");
    EXPECT_EQ(nearest_name("", names), "");
    EXPECT_EQ(nearest_name("x", {}), "");
}

TEST(NearestName, FindsWordsInAnotherOrder)
{
    const std::vector<std::string_view> names = {"pressure_inlet", "pressure_outlet",
                                                 "pressure_external", "neo-hookean"};
    EXPECT_EQ(nearest_name("inlet_pressure", names), "pressure_inlet");
    EXPECT_EQ(nearest_name("Outlet_Pressure", names), "pressure_outlet");
    EXPECT_EQ(nearest_name("extrenal-pressure", names), "pressure_external");
    EXPECT_EQ(nearest_name("hookean neo", names), "neo-hookean");
    EXPECT_EQ(nearest_name("inlet_velocity", names), "");
}

TEST(InQuotes, IsSafeAndShort)
{
    EXPECT_EQ(in_quotes("plain"), "\"plain\"");
    EXPECT_EQ(in_quotes("a\x1b[2J\n"), "\"a?[2J?\"");
    EXPECT_LE(in_quotes(std::string(1000, 'x')).size(), 66U);
    const std::string greek = in_quotes(std::string(59, 'x') + "\xCE\xBC\xCE\xBC");
    EXPECT_EQ(greek, "\"" + std::string(59, 'x') + "...\"");
}

} // namespace
} // namespace starling
