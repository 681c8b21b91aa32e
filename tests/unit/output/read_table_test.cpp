#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/error.hpp"
#include "output/read_table.hpp"
#include "temporary_directory.hpp"

namespace starling {
namespace {

TableContents table_of(const std::string& text)
{
    TemporaryDirectory dir;
    const auto path = dir.path() / "table.csv";
    std::ofstream(path) << text;
    return read_table(path);
}

TEST(ReadTable, KnowsNamesUnitsAndNumbers)
{
    const TableContents table =
        table_of("t [R_0/U_c],elastic_energy [J],plain\n0,nan,1\n0.5,2e-3,-4\n");
    ASSERT_EQ(table.columns.size(), 3u);
    EXPECT_EQ(table.columns[0].name, "t");
    EXPECT_EQ(table.columns[0].unit, "R_0/U_c");
    EXPECT_EQ(table.columns[2].unit, "");
    EXPECT_TRUE(std::isnan(table.find("elastic_energy")->values[0]));
    EXPECT_EQ(table.find("elastic_energy")->values[1], 2e-3);
    EXPECT_EQ(table.rows(), 2u);
    EXPECT_EQ(table.find("Q"), nullptr);
}

TEST(ReadTable, EndsBeforeTheFirstRowThatIsNotWhole)
{
    EXPECT_EQ(table_of("a [1],b [1]\n1,2\n3\n4,5\n").rows(), 1u);
    EXPECT_EQ(table_of("a [1],b [1]\n1,2\n3,x\n").rows(), 1u);
    EXPECT_EQ(table_of("a [1],b [1]\n1,2\n3,4").rows(), 1u); // 4 may be the start of 45
    EXPECT_EQ(table_of("a [1],b [1]\n").rows(), 0u);
}

TEST(ReadTable, RefusesAMissingOrEmptyFile)
{
    EXPECT_THROW(table_of(""), InputError);
    EXPECT_THROW(read_table("/none/series.csv"), InputError);
}

} // namespace
} // namespace starling
