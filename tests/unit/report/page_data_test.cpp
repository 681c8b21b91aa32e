#include <gtest/gtest.h>

#include <fstream>

#include "config/read_case.hpp"
#include "config/shipped_cases.hpp"
#include "core/error.hpp"
#include "output/field_file.hpp"
#include "report/page_data.hpp"
#include "report/write_report.hpp"
#include "temporary_directory.hpp"

namespace starling::report {
namespace {

Case shipped(const char* name)
{
    return read_case_text(std::string(shipped_case(name).text), name);
}

/// A strip of triangles with a displacement.
WallSnapshot large_wall(Real t, std::size_t vertices)
{
    WallSnapshot wall{t, static_cast<Index>(t), {}, {}, {}, {}};
    NamedArray displacement{"displacement", Quantity::length, 3, {}};
    for (std::size_t v = 0; v < vertices; ++v) {
        wall.points.push_back({static_cast<Real>(v / 2), t, static_cast<Real>(v % 2)});
        for (const Real value : {0.0, 3 * t, 4 * t}) displacement.values.push_back(value);
        const auto corner = static_cast<VertexIndex>(v);
        if (v >= 2) wall.triangles.push_back({corner - 2, corner - 1, corner});
    }
    wall.at_vertex = {displacement};
    return wall;
}

std::vector<ListedFrame> large_walls(const std::filesystem::path& directory, int frames,
                                     std::size_t vertices)
{
    WallFile file({directory, Scaling{}});
    for (int n = 0; n < frames; ++n) file.write(large_wall(n, vertices));
    return list_frames(directory, "wall");
}

TEST(WallData, KeepsAllFramesThatFit)
{
    TemporaryDirectory dir;
    Notes notes;
    const Json wall = wall_data(large_walls(dir.path(), 5, 100), notes);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(wall["frames"].size(), 5u);
    EXPECT_EQ(wall["frames"][4]["t"], 4);
    ASSERT_EQ(wall["fields"].size(), 1u); // the others are not in these frames
    EXPECT_EQ(wall["fields"][0]["name"], "displacement");
    EXPECT_EQ(wall["fields"][0]["high"], 20); // length of (0, 12, 16)
}

TEST(WallData, ThinsOutFramesSoThatThePageStaysSmall)
{
    TemporaryDirectory dir;
    Notes notes;
    const Json wall = wall_data(large_walls(dir.path(), 12, 60'000), notes);
    EXPECT_LT(wall["frames"].size(), 12u);
    EXPECT_GE(wall["frames"].size(), 3u);
    EXPECT_EQ(wall["frames"].front()["t"], 0);
    EXPECT_EQ(wall["frames"].back()["t"], 11);
    EXPECT_LT(wall.dump().size(), 13'000'000u);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].find("Of 12 frames"), std::string::npos) << notes[0];
}

TEST(WallData, LeavesOutAMeshThatIsTooLargeAndSaysSo)
{
    TemporaryDirectory dir;
    Notes notes;
    EXPECT_TRUE(wall_data(large_walls(dir.path(), 1, 600'000), notes).is_null());
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].find("600000 vertices"), std::string::npos) << notes[0];
}

TEST(TableData, ThinsOutLongTables)
{
    TableContents table{{{"t", "s", {}}, {"step", "1", {}}}};
    for (int n = 0; n < 10'000; ++n)
        for (TableColumn& column : table.columns) column.values.push_back(n);
    Notes notes;
    const Json data = table_data("series.csv", table, notes);
    EXPECT_LE(data["rows"].get<int>(), 4000);
    EXPECT_EQ(data["columns"][0]["unit"], "s");
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].find("10000 rows"), std::string::npos) << notes[0];
}

TEST(ResultData, SetsTheRunBesideTheory)
{
    const Json summary = {{"Q_mid", 3.0},
                          {"R_max", 1.3},
                          {"units", {{"Q_mid", "R_0^2 U_c"}}},
                          {"theory",
                           {{"Q_1d", 4.0},
                            {"Q_relative_difference", -0.25},
                            {"R_max_1d", 1.2},
                            {"R_max_relative_difference", 0.08},
                            {"displacement_relative_difference", 0.5}}}};
    const Json rows = result_data(summary, {}, shipped("inflation"));
    EXPECT_EQ(rows[0]["value"], 3.0);
    EXPECT_EQ(rows[0]["unit"], "R_0^2 U_c");
    EXPECT_EQ(rows[0]["theory"], 4.0);
    EXPECT_EQ(rows[0]["difference"], -0.25);
    EXPECT_EQ(rows[1]["theory"], 1.2);
    EXPECT_NEAR(rows[2]["value"].get<Real>(), 0.3, 1e-15);
    EXPECT_NEAR(rows[2]["theory"].get<Real>(), 0.2, 1e-15);
}

TEST(ResultData, ShowsTheLastCycleOfAPeriodicDrive)
{
    const Json summary = {{"Q_mid", 3.0},
                          {"units", {{"Q_mid", "m^3/s"}}},
                          {"cycle", {{"Q_mid", {{"mean", 2.0}, {"min", -1.0}, {"max", 4.0}}}}}};
    const Json rows = result_data(summary, {}, shipped("inflation"));
    std::vector<Real> found;
    for (const Json& row : rows)
        if (row["unit"] == "m^3/s") found.push_back(row["value"]);
    EXPECT_EQ(found, (std::vector<Real>{3, 2, -1, 4}));
}

TEST(ResultData, TakesTheLastRowWhereTheRunHasNotEnded)
{
    const TableContents series{{{"Q_mid", "m^3/s", {1, 2}}, {"min_area_ratio", "1", {1, 0.5}}}};
    const Json rows = result_data(nullptr, series, shipped("collapse_mode3"));
    EXPECT_EQ(rows[0]["value"], 2);
    EXPECT_EQ(rows[0]["unit"], "m^3/s");
    EXPECT_FALSE(rows[0].contains("theory"));
    EXPECT_EQ(rows[1]["value"], 0.5);
    EXPECT_GT(rows.back()["value"].get<Real>(), 1); // the load of that case buckles the tube
}

TEST(CaseData, SaysWhatTheCaseIsInItsUnits)
{
    const Json si = case_data(shipped("microchannel_si"));
    EXPECT_NE(si["words"].get<std::string>().find(" m, rigid over "), std::string::npos)
        << si["words"];
    const Json collapse = case_data(shipped("collapse_mode3"));
    for (const char* words : {"Hooke's law and resists bending", "0.4 times", "wave of 3 lobes"})
        EXPECT_NE(collapse["words"].get<std::string>().find(words), std::string::npos) << words;
    EXPECT_EQ(case_data(shipped("rigid_tube"))["words"].get<std::string>().find("A rigid tube"),
              0u);
}

TEST(WriteReport, RefusesADirectoryWithoutResults)
{
    TemporaryDirectory dir;
    EXPECT_THROW(write_report(dir.path()), InputError);
    EXPECT_THROW(write_report(dir.path() / "none"), InputError);
    std::ofstream(dir.path() / "series.csv") << "t [s]\n";
    EXPECT_THROW(write_report(dir.path()), InputError);
    EXPECT_FALSE(std::filesystem::exists(dir.path() / file_name));
}

} // namespace
} // namespace starling::report
