/// Damaged checkpoints and frames: none is taken for a whole one, none ends the program. All is
/// drawn from fixed seeds.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "core/error.hpp"
#include "example_checkpoint.hpp"
#include "output/field_file.hpp"
#include "output/frame_file.hpp"
#include "synthetic.hpp"
#include "temporary_directory.hpp"

namespace starling {
namespace {

namespace fs = std::filesystem;

/// A kind of file: how one is made in a directory, and how all of it is read.
struct Kind {
    const char* name;
    std::function<fs::path(const fs::path&)> make;
    std::function<void(const fs::path&)> read;
    Seal seal;
};

void read_checkpoint(const fs::path& path)
{
    test::ExampleCheckpoint example;
    const CheckpointFile file(path);
    file.read(example.state);
    file.read_memory();
}

const Kind kinds[] = {
    {"checkpoint",
     [](const fs::path& directory) { return test::ExampleCheckpoint().write(directory); },
     read_checkpoint, checkpoint_seal},
    {"wall",
     [](const fs::path& directory) {
         WallFile({directory, Scaling{}}).write(synthetic::wall(0.5, 3));
         return directory / "frames" / "wall_000000.h5";
     },
     [](const fs::path& path) { FrameFile(path).read_wall(); }, frame_seal},
    {"fluid",
     [](const fs::path& directory) {
         FluidFile({directory, Scaling{}}).write(synthetic::fluid(0.5, 3));
         return directory / "frames" / "fluid_000000.h5";
     },
     [](const fs::path& path) { FrameFile(path).read_fluid(); }, frame_seal},
};

class Damage : public testing::TestWithParam<Kind> {
protected:
    /// Whether the file is refused with a message that names it.
    bool refused() const
    {
        try {
            GetParam().read(path_);
            return false;
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find(path_.filename()), std::string::npos) << e.what();
            return true;
        }
    }

    TemporaryDirectory directory_;
    fs::path path_ = GetParam().make(directory_.path());
    std::string whole_ = read_text(path_);
};

TEST_P(Damage, WholeFileIsRead) { EXPECT_FALSE(refused()); }

TEST_P(Damage, CutOffAnywhereIsRefused)
{
    for (std::size_t size = 0; size < whole_.size(); size += size < 600 ? 1 : 251) {
        write_text(path_, whole_.substr(0, size));
        ASSERT_TRUE(refused()) << size << " bytes";
    }
}

TEST_P(Damage, LongerThanItWasIsRefused)
{
    write_text(path_, whole_ + '\0');
    EXPECT_TRUE(refused());
}

TEST_P(Damage, OneWrongBitAnywhereIsRefused)
{
    std::mt19937 random(7);
    for (std::size_t place = 0; place < whole_.size();
         place += place < 530 ? 1 : 1 + random() % 120) {
        std::string text = whole_;
        text[place] = static_cast<char>(text[place] ^ (1 << random() % 8));
        write_text(path_, text);
        ASSERT_TRUE(refused()) << "byte " << place;
    }
}

TEST_P(Damage, NoiseIsRefused)
{
    std::mt19937 random(8);
    for (int n = 0; n < 300; ++n) {
        std::string text = whole_;
        const std::size_t begin = n % 2 == 0 ? random() % text.size() : 0;
        const std::size_t end = begin + 1 + random() % (text.size() - begin);
        for (std::size_t place = begin; place < end; ++place)
            text[place] = static_cast<char>(random());
        write_text(path_, text);
        ASSERT_TRUE(refused()) << n;
    }
}

TEST_P(Damage, BlockOfAnotherPlaceIsRefused)
{
    std::mt19937 random(9);
    for (int n = 0; n < 300; ++n) {
        std::string text = whole_;
        const std::size_t length = 1 + random() % (text.size() / 2);
        const std::size_t from = random() % (text.size() - length),
                          to = random() % (text.size() - length);
        text.replace(to, length, whole_, from, length);
        if (text == whole_) continue;
        write_text(path_, text);
        ASSERT_TRUE(refused()) << n;
    }
}

// --- Files that are whole, as their checksum says, but hold what no Starling has written.

/// Every group, array and attribute of an open file: "/fluid/P", "/state@t".
void list(hid_t file, const std::string& path, std::vector<std::string>& all)
{
    const hid_t object = H5Oopen(file, path.c_str(), H5P_DEFAULT);
    for (hsize_t n = 0; n < static_cast<hsize_t>(H5Aget_num_attrs(object)); ++n) {
        char name[64];
        H5Aget_name_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, n, name, sizeof(name),
                           H5P_DEFAULT);
        all.push_back(path + "@" + name);
    }
    const bool group = H5Iget_type(object) == H5I_GROUP;
    H5G_info_t info = {};
    if (group) H5Gget_info(object, &info);
    for (hsize_t n = 0; group && n < info.nlinks; ++n) {
        char name[64];
        H5Lget_name_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, n, name, sizeof(name),
                           H5P_DEFAULT);
        const std::string child = (path == "/" ? "" : path) + "/" + name;
        all.push_back(child);
        list(file, child, all);
    }
    H5Oclose(object);
}

/// What is put in the place of an array or attribute.
enum class Wrong { nothing, text, one_number, many_numbers, huge, empty, group, count };

void put_attribute(hid_t file, const std::string& path, const std::string& name, Wrong wrong)
{
    H5Adelete_by_name(file, path.c_str(), name.c_str(), H5P_DEFAULT);
    if (wrong == Wrong::nothing || wrong == Wrong::group) return;
    const hsize_t size = wrong == Wrong::many_numbers || wrong == Wrong::huge ? 5000
                         : wrong == Wrong::empty                              ? 0
                                                                              : 1;
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    const hid_t type = H5Tcopy(wrong == Wrong::text ? H5T_C_S1 : H5T_NATIVE_DOUBLE);
    if (wrong == Wrong::text) H5Tset_size(type, H5T_VARIABLE);
    const hid_t attribute = H5Acreate_by_name(file, path.c_str(), name.c_str(), type, space,
                                              H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Aclose(attribute);
    H5Tclose(type);
    H5Sclose(space);
}

void put_array(hid_t file, const std::string& path, Wrong wrong)
{
    H5Ldelete(file, path.c_str(), H5P_DEFAULT);
    if (wrong == Wrong::nothing) return;
    if (wrong == Wrong::group) {
        H5Gclose(H5Gcreate2(file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        return;
    }
    const hsize_t size = wrong == Wrong::many_numbers ? 5000
                         : wrong == Wrong::huge       ? hsize_t{1} << 40
                         : wrong == Wrong::empty      ? 0
                                                      : 1;
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    const hid_t type = H5Tcopy(wrong == Wrong::text ? H5T_C_S1 : H5T_NATIVE_DOUBLE);
    if (wrong == Wrong::text) H5Tset_size(type, 7);
    const hid_t layout = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk = 1000;
    if (wrong == Wrong::huge) H5Pset_chunk(layout, 1, &chunk); // takes no room
    H5Dclose(H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, layout, H5P_DEFAULT));
    H5Pclose(layout);
    H5Tclose(type);
    H5Sclose(space);
}

/// Makes size and checksum fit again.
void seal(const fs::path& path, const Seal& seal)
{
    const std::string body = read_text(path).substr(seal_size);
    write_text(path, seal_of(body, seal) + body);
}

TEST_P(Damage, WholeFileWithAnythingElseInItIsReadOrRefused)
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    std::vector<std::string> all;
    const hid_t whole = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    list(whole, "/", all);
    H5Fclose(whole);
    ASSERT_GT(all.size(), 5u);
    int refusals = 0, tried = 0;
    for (const std::string& entry : all)
        for (int n = 0; n < static_cast<int>(Wrong::count); ++n, ++tried) {
            write_text(path_, whole_);
            const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
            const std::size_t at = entry.find('@');
            if (at == std::string::npos)
                put_array(file, entry, static_cast<Wrong>(n));
            else
                put_attribute(file, entry.substr(0, at), entry.substr(at + 1),
                              static_cast<Wrong>(n));
            H5Fclose(file);
            seal(path_, GetParam().seal);
            refusals += refused();
        }
    EXPECT_GT(refusals, tried / 2);
    EXPECT_LT(refusals, tried); // some are read: the seal is not what all of them fail at
}

INSTANTIATE_TEST_SUITE_P(Files, Damage, testing::ValuesIn(kinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST(CheckpointDamage, WindowWithoutWholeNumbersOfStepsIsRefused)
{
    TemporaryDirectory directory;
    const fs::path path = test::ExampleCheckpoint().write(directory.path());
    for (const Real wrong : {1e300, -1e19, 0.5, std::nan("")}) {
        const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
        const hid_t window = H5Dopen2(file, "/run/window", H5P_DEFAULT);
        const hid_t space = H5Dget_space(window);
        const std::vector<Real> values(
            static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)), wrong);
        H5Dwrite(window, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        H5Sclose(space);
        H5Dclose(window);
        H5Fclose(file);
        seal(path, checkpoint_seal);
        try {
            CheckpointFile(path).read_memory();
            ADD_FAILURE() << wrong;
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find("whole number"), std::string::npos) << e.what();
        }
    }
}

} // namespace
} // namespace starling
