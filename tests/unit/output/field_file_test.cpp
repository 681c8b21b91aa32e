#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "output/field_file.hpp"
#include "synthetic.hpp"
#include "temporary_directory.hpp"

namespace starling {
namespace {

/// Reads a whole array as doubles, independently of the code under test.
std::vector<double> read(const std::filesystem::path& path, const char* name)
{
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
    const hid_t space = H5Dget_space(set);
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    EXPECT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    H5Sclose(space);
    H5Dclose(set);
    H5Fclose(file);
    return values;
}

std::size_t bytes_per_number(const std::filesystem::path& path, const char* name)
{
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
    const hid_t type = H5Dget_type(set);
    const std::size_t size = H5Tget_size(type);
    H5Tclose(type);
    H5Dclose(set);
    H5Fclose(file);
    return size;
}

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

TEST(WallFile, ReturnsWhatWasWritten)
{
    TemporaryDirectory dir;
    const std::filesystem::path file = dir.path() / "wall.h5";
    WallFile wall({dir.path(), Scaling{}});
    for (Index n : {0, 1}) wall.write(synthetic::wall(0.5 * static_cast<Real>(n), n));
    EXPECT_EQ(read(file, "/triangles"), (std::vector<double>{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}));
    EXPECT_EQ(read(file, "/frames/000001/points"),
              (std::vector<double>{.5, 1, 1.5, 1.5, 1, 1.5, .5, 2, 1.5, .5, 1, 2.5}));
    EXPECT_EQ(read(file, "/frames/000001/tension1"), (std::vector<double>{.5, 1.5, 2.5, 3.5}));
    EXPECT_EQ(bytes_per_number(file, "/frames/000000/points"), 4u);
}

TEST(WallFile, DoublePrecisionIsKept)
{
    TemporaryDirectory dir;
    WallFile wall({dir.path(), Scaling{}, hdf5::Precision::full});
    wall.write(synthetic::wall(0.1, 1));
    EXPECT_EQ(bytes_per_number(dir.path() / "wall.h5", "/frames/000000/points"), 8u);
    EXPECT_EQ(read(dir.path() / "wall.h5", "/frames/000000/points")[2], 3 * 0.1);
}

TEST(WallFile, NumbersAreInTheUnitsOfTheCase)
{
    TemporaryDirectory dir;
    WallFile wall({dir.path(), synthetic::si_scaling()});
    wall.write(synthetic::wall(0, 0));
    EXPECT_EQ(read(dir.path() / "wall.h5", "/frames/000000/points")[3], 2);
    EXPECT_EQ(read(dir.path() / "wall.h5", "/frames/000000/transmural_pressure")[1], 450);
}

TEST(FluidFile, HoldsTheTransposeWithXFastest)
{
    TemporaryDirectory dir;
    FluidFile fluid({dir.path(), Scaling{}});
    fluid.write(synthetic::fluid(0, 0));
    const auto pressure = read(dir.path() / "fluid.h5", "/frames/000000/pressure");
    const auto velocity = read(dir.path() / "fluid.h5", "/frames/000000/velocity");
    ASSERT_EQ(pressure.size(), 6u * 4 * 5);
    for (std::size_t k = 0, n = 0; k < 5; ++k)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t i = 0; i < 6; ++i, ++n) {
                const double x = .5 * (double(i) + .5), y = -1 + .25 * (double(j) + .5),
                             z = -2 + .75 * (double(k) + .5);
                EXPECT_FLOAT_EQ(float(pressure[n]), float(x + 10 * y + 100 * z));
                EXPECT_FLOAT_EQ(float(velocity[3 * n + 1]), float(y));
            }
}

TEST(FieldFile, XdmfIsMadeAnewFromTheFrames)
{
    TemporaryDirectory dir;
    const std::filesystem::path list = dir.path() / "wall.xdmf";
    std::string of_two;
    {
        WallFile wall({dir.path(), Scaling{}});
        for (Index n : {0, 1, 2}) {
            wall.write(synthetic::wall(static_cast<Real>(n) / 3, n));
            if (n == 1) of_two = read_text(list);
        }
    }
    const FieldFileOptions keep = {.directory = dir.path(), .scaling = {}, .keep = 2};
    EXPECT_TRUE(FrameWriter::lists_frames(keep, "wall"));
    for (std::size_t size : {std::size_t{0}, of_two.size() / 2}) {
        write_text(list, of_two.substr(0, size));
        if (size == 0) std::filesystem::remove(list);
        EXPECT_FALSE(FrameWriter::lists_frames(keep, "wall"));
        const WallFile again(keep);
        EXPECT_EQ(read_text(list), of_two);
    }
    std::filesystem::remove(list);
    std::filesystem::resize_file(dir.path() / "frames/wall_000001.h5", 5000);
    EXPECT_THROW(FrameWriter::lists_frames(keep, "wall"), InputError);
    EXPECT_THROW(WallFile{keep}, InputError);
}

TEST(FieldFile, XdmfListsEveryFrameInOrder)
{
    TemporaryDirectory dir;
    WallFile wall({dir.path(), synthetic::si_scaling()});
    for (Index n : {0, 1, 2}) {
        wall.write(synthetic::wall(static_cast<Real>(n), n));
        const std::string text = read_text(dir.path() / "wall.xdmf");
        EXPECT_EQ(count(text, "<Time "), static_cast<std::size_t>(n) + 1);
        EXPECT_EQ(count(text, "<Grid "), count(text, "</Grid>"));
        EXPECT_EQ(text.substr(text.size() - 8), "</Xdmf>\n");
    }
    EXPECT_LT(read_text(dir.path() / "wall.xdmf").find("Value=\"0.6666"),
              read_text(dir.path() / "wall.xdmf").find("Value=\"1.3333"));
}

TEST(FieldFile, LeavesNoTemporaryFile)
{
    TemporaryDirectory dir;
    WallFile({dir.path(), Scaling{}}).write(synthetic::wall(0, 0));
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(dir.path()))
        files.push_back(entry.path().filename());
    std::ranges::sort(files);
    EXPECT_EQ(files,
              (std::vector<std::string>{"frames", "wall.h5", "wall.xdmf", "wall_000000.h5"}));
}

TEST(FieldFile, DirectoryThatVanishedIsReported)
{
    TemporaryDirectory dir;
    EXPECT_THROW(WallFile({dir.path() / "vanished", Scaling{}}), std::runtime_error);
}

TEST(FieldFile, EmptyWallIsWritten)
{
    TemporaryDirectory dir;
    WallFile({dir.path(), Scaling{}}).write(WallSnapshot{});
    EXPECT_TRUE(read(dir.path() / "wall.h5", "/frames/000000/points").empty());
}

} // namespace
} // namespace starling
