#include "config/case_keys.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

namespace starling {
namespace {

std::string document()
{
    std::ostringstream text;
    text << std::ifstream(std::string(STARLING_SOURCE_DIR) + "/docs/case_file.md").rdbuf();
    return text.str();
}

/// The part of the document on one section; all up to the first section for an empty name.
std::string chapter(const std::string& text, std::string_view section)
{
    const std::string heading = "## `[" + std::string(section) + "]`";
    const auto start = section.empty() ? text.find("## Above the sections") : text.find(heading);
    if (start == std::string::npos) return "";
    return text.substr(start, text.find("\n## ", start) - start);
}

TEST(CaseKeys, EveryKeyIsInTheReference)
{
    const std::string text = document();
    for (const KeyRule& rule : case_keys()) {
        const std::string row = "\n| `" + std::string(rule.key) + "` |";
        EXPECT_NE(chapter(text, rule.section).find(row), std::string::npos) << rule.name();
    }
}

TEST(CaseKeys, TheReferenceGivesEveryRangeAndName)
{
    const std::string text = document();
    for (const KeyRule& rule : case_keys()) {
        const std::string part = chapter(text, rule.section);
        const auto at = part.find("\n| `" + std::string(rule.key) + "` |");
        const std::string row = part.substr(at, part.find('\n', at + 1) - at);
        for (std::string_view choice : rule.choices)
            EXPECT_NE(row.find("`\"" + std::string(choice) + "\"`"), std::string::npos) << row;
        const bool bounded = std::isfinite(rule.range.min) || std::isfinite(rule.range.max);
        const std::string cell = bounded ? "| " + rule.range.describe() + " |" : "|";
        EXPECT_NE(row.find(cell), std::string::npos) << row << "\n" << cell;
    }
}

TEST(CaseKeys, AreUnique)
{
    std::set<std::string> names;
    for (const KeyRule& rule : case_keys()) EXPECT_TRUE(names.insert(rule.name()).second);
    EXPECT_EQ(case_sections().size(), 18U);
}

TEST(Range, HoldsItsBoundsUnlessTheyAreOpen)
{
    const Range closed{0, 1, false, false}, open{0, 1, true, true};
    EXPECT_TRUE(closed.contains(0) && closed.contains(1));
    EXPECT_FALSE(open.contains(0) || open.contains(1));
    EXPECT_FALSE(closed.contains(std::nan("")));
    EXPECT_EQ(closed.describe(), "from 0 to 1");
    EXPECT_EQ(open.describe(), "greater than 0 and less than 1");
}

} // namespace
} // namespace starling
