#include <gtest/gtest.h>

#include <sstream>

#include "core/error.hpp"
#include "output/export.hpp"
#include "output/field_file.hpp"
#include "output/frame_file.hpp"
#include "synthetic.hpp"
#include "temporary_directory.hpp"

namespace starling {
namespace {

namespace fs = std::filesystem;

TEST(FrameFile, GivesBackTheWallInTheUnitsOfTheCase)
{
    TemporaryDirectory dir;
    WallFile file({dir.path(), synthetic::si_scaling()});
    for (Index n : {0, 1}) file.write(synthetic::wall(0.5 * static_cast<Real>(n), n));
    const WallFrame wall = FrameFile(dir.path() / "frames/wall_000001.h5").read_wall();
    EXPECT_EQ(wall.head.of, "wall");
    EXPECT_NEAR(wall.head.t, 0.5 * 2 / 3, 1e-15);
    EXPECT_EQ(wall.head.unit_of_t, "s");
    EXPECT_EQ(wall.head.step, 1);
    EXPECT_EQ(wall.points.unit, "m");
    EXPECT_EQ(wall.points.at(1, 0), 2 * 1.5);
    ASSERT_EQ(wall.triangles.size(), 4u); // they stand in the first frame only
    EXPECT_EQ(wall.triangles[2], (std::array<std::int32_t, 3>{1, 2, 3}));
    ASSERT_EQ(wall.at_vertex.size(), 2u);
    EXPECT_EQ(wall.at_vertex[1].name, "transmural_pressure");
    EXPECT_EQ(wall.at_vertex[1].at(1, 0), 450);
    ASSERT_EQ(wall.at_element.size(), 1u);
    EXPECT_EQ(wall.at_element[0].name, "tension1");
}

TEST(FrameFile, GivesBackTheFluid)
{
    TemporaryDirectory dir;
    FluidFile({dir.path(), Scaling{}}).write(synthetic::fluid(2, 7));
    const FrameFile file(dir.path() / "frames/fluid_000000.h5");
    const FluidFrame fluid = file.read_fluid();
    EXPECT_EQ(fluid.head.step, 7);
    EXPECT_EQ(fluid.cells, (std::array<std::size_t, 3>{6, 4, 5}));
    EXPECT_EQ(fluid.origin, (Vec3{0, -1, -2}));
    EXPECT_EQ(fluid.spacing, (Vec3{0.5, 0.25, 0.75}));
    ASSERT_EQ(fluid.at_cell.size(), 2u);
    const FrameArray& velocity = fluid.at_cell[1];
    EXPECT_EQ(velocity.components, 3);
    EXPECT_EQ(velocity.at(1, 0), 0.75); // the second cell in x
    EXPECT_THROW(file.read_wall(), InputError);
    EXPECT_THROW(file.read("vorticity"), InputError);
}

TEST(FrameFile, ListsFramesInOrderWithWhatIsWrong)
{
    TemporaryDirectory dir;
    WallFile file({dir.path(), Scaling{}});
    for (Index n : {0, 1, 2}) file.write(synthetic::wall(static_cast<Real>(n), n));
    fs::resize_file(dir.path() / "frames/wall_000001.h5", 1000);
    const auto frames = list_frames(dir.path(), "wall");
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_EQ(frames[2].head.t, 2);
    EXPECT_TRUE(frames[2].problem.empty());
    EXPECT_NE(frames[1].problem.find("truncated"), std::string::npos);
    EXPECT_TRUE(list_frames(dir.path(), "fluid").empty());
}

std::string line_of(const fs::path& path, int number)
{
    std::istringstream text(read_text(path));
    std::string line;
    for (int n = 0; n <= number; ++n) std::getline(text, line);
    return line;
}

TEST(Export, CsvNamesUnitsAndHoldsEveryVertex)
{
    TemporaryDirectory dir;
    WallFile({dir.path(), synthetic::si_scaling()}).write(synthetic::wall(0.5, 3));
    WallFrame wall = FrameFile(dir.path() / "frames/wall_000000.h5").read_wall();
    wall.at_element[0].values = {3, 6, 9, 12};
    write_csv(dir.path() / "wall.csv", wall);
    EXPECT_EQ(line_of(dir.path() / "wall.csv", 0),
              "x [m],y [m],z [m],displacement_x [m],displacement_y [m],displacement_z [m],"
              "transmural_pressure [Pa],tension1 [N/m]");
    // Vertex 1 belongs to the triangles 0, 1 and 2.
    EXPECT_EQ(line_of(dir.path() / "wall.csv", 2), "3,2,3,1,2,3,450,6");
    EXPECT_EQ(line_of(dir.path() / "wall.csv", 5), "");
}

TEST(Export, CsvHoldsEveryCellAtItsCentre)
{
    TemporaryDirectory dir;
    FluidFile({dir.path(), Scaling{}}).write(synthetic::fluid(2, 7));
    write_csv(dir.path() / "fluid.csv",
              FrameFile(dir.path() / "frames/fluid_000000.h5").read_fluid());
    EXPECT_EQ(line_of(dir.path() / "fluid.csv", 0),
              "x [R_0],y [R_0],z [R_0],pressure [rho U_c^2],velocity_x [U_c],velocity_y [U_c],"
              "velocity_z [U_c]");
    // 6 x 4 x 5 cells: row 1 + 1 + 6 * 2 + 24 * 3 is cell (1, 2, 3)
    const Real x = 0.75, y = -0.375, z = 0.625;
    EXPECT_EQ(line_of(dir.path() / "fluid.csv", 86),
              "0.75,-0.375,0.625," + std::to_string(2 + x + 10 * y + 100 * z).substr(0, 4) +
                  ",0.75,-0.375,0.625");
    EXPECT_NE(line_of(dir.path() / "fluid.csv", 120), "");
    EXPECT_EQ(line_of(dir.path() / "fluid.csv", 121), "");
}

} // namespace
} // namespace starling
