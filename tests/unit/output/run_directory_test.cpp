#include <algorithm>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/error.hpp"
#include "output/run_directory.hpp"
#include "temporary_directory.hpp"

namespace starling {
namespace {

namespace fs = std::filesystem;

std::string message(const fs::path& path, bool force)
{
    try {
        RunDirectory run({path, force, {}});
    } catch (const InputError& e) {
        return e.what();
    }
    return "";
}

std::vector<std::string> names(const fs::path& path)
{
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(path)) found.push_back(entry.path().filename());
    std::ranges::sort(found);
    return found;
}

TEST(RunDirectory, IsCreatedWithItsParents)
{
    TemporaryDirectory dir;
    RunDirectory run({dir.path() / "a" / "b", false, {}});
    EXPECT_TRUE(fs::is_directory(dir.path() / "a" / "b"));
}

TEST(RunDirectory, WithResultsIsRefusedAndUntouched)
{
    TemporaryDirectory dir;
    write_text(dir.path() / "series.csv", "precious");
    write_text(dir.path() / "notes.txt", "mine");
    EXPECT_NE(message(dir.path(), false).find("series.csv"), std::string::npos);
    EXPECT_EQ(names(dir.path()), (std::vector<std::string>{"notes.txt", "series.csv"}));
    EXPECT_EQ(read_text(dir.path() / "series.csv"), "precious");
}

TEST(RunDirectory, ForceRemovesOnlyWhatStarlingWrites)
{
    TemporaryDirectory dir;
    for (const char* name : {"series.csv", "wall.h5", "notes.txt", "series.csv.bak"})
        write_text(dir.path() / name, "text");
    {
        RunDirectory run({dir.path(), true, {}});
    }
    EXPECT_EQ(names(dir.path()), (std::vector<std::string>{"notes.txt", "series.csv.bak"}));
}

TEST(RunDirectory, ForceRemovesWhatAKilledRunLeaves)
{
    TemporaryDirectory dir;
    for (const char* name : {"summary.json.new", "case.toml.new", "fluid.xdmf.new"})
        write_text(dir.path() / name, "text");
    EXPECT_EQ(message(dir.path(), true), "");
    EXPECT_TRUE(names(dir.path()).empty());
}

TEST(RunDirectory, ForceTakesOfALinkTheLinkOnly)
{
    TemporaryDirectory dir;
    write_text(dir.path() / "far.h5", "precious");
    fs::create_symlink(dir.path() / "far.h5", dir.path() / "fluid.h5");
    fs::create_symlink(dir.path() / "nowhere", dir.path() / "wall.h5");
    EXPECT_NE(message(dir.path(), false).find("wall.h5"), std::string::npos);
    EXPECT_EQ(message(dir.path(), true), "");
    EXPECT_EQ(names(dir.path()), std::vector<std::string>{"far.h5"});
    EXPECT_EQ(read_text(dir.path() / "far.h5"), "precious");
}

TEST(RunDirectory, WithADirectoryInPlaceOfAResultIsRefusedAndUntouched)
{
    TemporaryDirectory dir;
    write_text(dir.path() / "series.csv", "results");
    fs::create_directory(dir.path() / "fluid.h5");
    EXPECT_NE(message(dir.path(), true).find("fluid.h5"), std::string::npos);
    EXPECT_EQ(names(dir.path()), (std::vector<std::string>{"fluid.h5", "series.csv"}));
}

TEST(RunDirectory, ForceNeverTakesTheUsersCaseFile)
{
    TemporaryDirectory dir;
    const fs::path own = dir.path() / "case.toml";
    write_text(own, "[fluid]\n");
    EXPECT_NE(message(dir.path(), true).find("not written by a run"), std::string::npos);
    write_text(own, std::string(written_case_mark) + "\n");
    EXPECT_THROW(RunDirectory({dir.path(), true, own}), InputError); // the run's own input
    EXPECT_TRUE(fs::exists(own));
    EXPECT_EQ(message(dir.path(), true), "");
    EXPECT_FALSE(fs::exists(own));
}

TEST(RunDirectory, WithForeignFilesIsAccepted)
{
    TemporaryDirectory dir;
    write_text(dir.path() / "notes.txt", "mine");
    EXPECT_EQ(message(dir.path(), false), "");
}

TEST(RunDirectory, SecondRunIsRefusedEvenWithForce)
{
    TemporaryDirectory dir;
    const RunDirectory first({dir.path(), false, {}});
    EXPECT_NE(message(dir.path(), false).find("another run"), std::string::npos);
    EXPECT_NE(message(dir.path(), true).find("another run"), std::string::npos);
}

TEST(RunDirectory, IsFreeAgainAfterTheRun)
{
    TemporaryDirectory dir;
    EXPECT_EQ(message(dir.path(), false), "");
    EXPECT_EQ(message(dir.path(), false), "");
    EXPECT_TRUE(names(dir.path()).empty());
}

TEST(RunDirectory, ThatIsAFileIsRefused)
{
    TemporaryDirectory dir;
    write_text(dir.path() / "out", "text");
    EXPECT_NE(message(dir.path() / "out", true).find("is a file"), std::string::npos);
    EXPECT_NE(message(dir.path() / "out" / "deeper", true), "");
}

TEST(RunDirectory, ThatCannotBeWrittenIsRefused)
{
    if (geteuid() == 0) {
        EXPECT_NE(message("/proc/starling", false).find("cannot be created"), std::string::npos);
        return;
    }
    TemporaryDirectory dir;
    fs::permissions(dir.path(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_NE(message(dir.path(), false).find("cannot be written"), std::string::npos);
    fs::permissions(dir.path(), fs::perms::owner_all);
}

} // namespace
} // namespace starling
