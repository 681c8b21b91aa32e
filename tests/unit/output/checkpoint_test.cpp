#include <gtest/gtest.h>

#include <cstring>

#include "core/error.hpp"
#include "example_checkpoint.hpp"
#include "output/crc64.hpp"
#include "temporary_directory.hpp"

namespace starling {
namespace {

namespace fs = std::filesystem;

TEST(Crc64, GivesTheCheckValueOfItsVariant)
{
    Crc64 crc;
    crc.add(std::string_view("123456789"));
    EXPECT_EQ(crc.value(), 0x995DC9BBDF1939FAu);
}

TEST(Crc64, DoesNotDependOnThePieces)
{
    const std::string text = "a line of more than sixteen bytes";
    Crc64 whole;
    whole.add(text);
    for (std::size_t cut = 0; cut <= text.size(); ++cut) {
        Crc64 parts;
        parts.add(std::string_view(text).substr(0, cut));
        parts.add(std::string_view(text).substr(cut));
        EXPECT_EQ(parts.value(), whole.value()) << cut;
    }
}

using Example = test::ExampleCheckpoint;

template <class T>
bool same_bytes(const Array<T>& a, const Array<T>& b)
{
    return a.size() == b.size() &&
           std::memcmp(a.data(), b.data(), sizeof(T) * static_cast<std::size_t>(a.size())) == 0;
}

void expect_same_bits(const State& read, const State& s)
{
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_TRUE(
            same_bytes(read.fluid.u.component[c].values(), s.fluid.u.component[c].values()));
        EXPECT_TRUE(same_bytes(read.fluid.N_before.component[c].values(),
                               s.fluid.N_before.component[c].values()));
        EXPECT_TRUE(same_bytes(read.ghosts[c].inside.values(), s.ghosts[c].inside.values()));
        ASSERT_EQ(read.ghosts[c].near_wall.size(), 2u);
        const NearNode &a = read.ghosts[c].near_wall[0], &b = s.ghosts[c].near_wall[0];
        EXPECT_TRUE(a.i == b.i && a.j == b.j && a.k == b.k);
        EXPECT_EQ(a.intercept.element, b.intercept.element);
        EXPECT_EQ(a.intercept.point, b.intercept.point);
        EXPECT_EQ(a.intercept.squared_distance, b.intercept.squared_distance);
        EXPECT_EQ(a.intercept.outside, b.intercept.outside);
    }
    EXPECT_TRUE(same_bytes(read.fluid.P.values(), s.fluid.P.values()));
    EXPECT_EQ(read.fluid.ends.inside, s.fluid.ends.inside);
    EXPECT_EQ(read.fluid.ends.stored, s.fluid.ends.stored);
    for (std::size_t end = 0; end < 2; ++end)
        EXPECT_TRUE(same_bytes(read.fluid.ends.pressure[end], s.fluid.ends.pressure[end]));
    EXPECT_TRUE(same_bytes(read.wall.x, s.wall.x));
    EXPECT_TRUE(same_bytes(read.wall.velocity, s.wall.velocity));
    EXPECT_TRUE(same_bytes(read.wall.support, s.wall.support));
    EXPECT_TRUE(same_bytes(read.wall.support_rate, s.wall.support_rate));
    EXPECT_TRUE(same_bytes(read.wall.passing, s.wall.passing));
    EXPECT_EQ(read.t, s.t);
    EXPECT_EQ(read.dt, s.dt);
    EXPECT_EQ(read.fluid.dt_before, s.fluid.dt_before);
    EXPECT_EQ(read.step, s.step);
}

TEST(Checkpoint, GivesBackEveryBitOfTheState)
{
    TemporaryDirectory dir;
    const Example example;
    const CheckpointFile file(example.write(dir.path()));
    EXPECT_EQ(file.step(), 42);
    EXPECT_EQ(file.t(), 1 / 3.);
    EXPECT_EQ(file.case_text(), "[fluid]\nreynolds = 1\n");

    State read(example.grid, example.tube), sound(example.grid, example.tube);
    file.read(read);
    file.sound().read(sound);
    expect_same_bits(read, example.state);
    expect_same_bits(sound, example.sound);

    const RunMemory m = file.read_memory();
    ASSERT_EQ(m.window.size(), 3u);
    EXPECT_EQ(m.window[1].Q_in, 0.7);
    EXPECT_EQ(m.window[2].step, 41);
    EXPECT_EQ(m.last_row, 40);
    EXPECT_EQ(m.wall_frames, 2);
    EXPECT_EQ(m.next_wall, 0.5);
    EXPECT_EQ(m.wall_seconds, 12.5);
    EXPECT_EQ(m.phase_seconds, (std::vector<Real>{3, 4.5}));
    EXPECT_EQ(m.step_factor, 0.5);
    EXPECT_EQ(m.cycles.period, 0.1);
    EXPECT_EQ(m.cycles.per_cycle, 3);
    EXPECT_EQ(m.cycles.next, 14);
    EXPECT_EQ(m.cycles.cycles, 4);
    EXPECT_EQ(m.cycles.change, 0.01);
    EXPECT_TRUE(std::isnan(m.cycles.change_before));
    ASSERT_EQ(m.cycles.last.size(), 3u);
    EXPECT_EQ(m.cycles.last[2].P_out, 0.9);
    ASSERT_EQ(m.cycles.shear_last.stress.size(), 2u);
    EXPECT_EQ(m.cycles.shear_last.stress[0].z, 2);
    EXPECT_EQ(m.cycles.shear_last.magnitude, (std::vector<Real>{3, 0.5}));
    EXPECT_TRUE(m.cycles.shear_current.empty());
    ASSERT_EQ(m.cycles.current.size(), 1u);
    EXPECT_EQ(m.cycles.current[0].step, 42);
    const RunMemory before = file.sound().read_memory();
    ASSERT_EQ(before.window.size(), 1u);
    EXPECT_EQ(before.window[0].Q_in, 0.6);
    EXPECT_EQ(before.last_row, 30);
    EXPECT_EQ(before.wall_frames, 1);
}

// A sound state that is the present one needs no file, and one that is not needs its own.
TEST(Checkpoint, NamesItsSoundPoint)
{
    TemporaryDirectory dir;
    const Example example;
    const fs::path path = example.write(dir.path()), beside = dir.path() / "sound_0000000042.h5";
    EXPECT_EQ(path.filename(), "step_0000000042.h5");
    EXPECT_EQ(CheckpointFile(path).sound().step(), 40);
    fs::rename(beside, dir.path() / "away");
    EXPECT_THROW(CheckpointFile(path).sound(), InputError);
    fs::copy(path, beside); // of another step
    EXPECT_THROW(CheckpointFile(path).sound(), InputError);
    write_checkpoint(dir.path(),
                     {{example.state, example.memory}, {example.state, example.memory}, ""});
    EXPECT_EQ(CheckpointFile(path).sound().step(), 42);
    EXPECT_FALSE(fs::exists(beside));
}

/// What is said of a file; empty if it is found whole.
std::string complaint(const fs::path& path)
{
    try {
        const CheckpointFile file(path);
    } catch (const InputError& e) {
        return e.what();
    }
    return "";
}

TEST(Checkpoint, CutOffAnywhereIsRefused)
{
    TemporaryDirectory dir;
    const std::string whole = read_text(Example().write(dir.path()));
    const fs::path cut = dir.path() / "cut.h5";
    for (std::size_t size = 0; size < whole.size(); size += 1 + size / 7) {
        write_text(cut, whole.substr(0, size));
        EXPECT_NE(complaint(cut), "") << size;
    }
    write_text(cut, whole.substr(0, whole.size() - 1));
    EXPECT_NE(complaint(cut).find("truncated"), std::string::npos) << complaint(cut);
}

TEST(Checkpoint, WithOneWrongByteIsRefused)
{
    TemporaryDirectory dir;
    const std::string whole = read_text(Example().write(dir.path()));
    const fs::path wrong = dir.path() / "wrong.h5";
    for (std::size_t place = 512; place < whole.size(); place += 97) {
        std::string text = whole;
        text[place] = static_cast<char>(text[place] ^ 4);
        write_text(wrong, text);
        EXPECT_NE(complaint(wrong).find("checksum"), std::string::npos) << place;
    }
}

TEST(Checkpoint, OfAnotherKindOrVersionIsNamedAsSuch)
{
    TemporaryDirectory dir;
    std::string text = read_text(Example().write(dir.path()));
    const fs::path other = dir.path() / "other.h5";
    const std::size_t place = text.find("format_version 5");
    for (const char* version : {"2", "7"}) {
        text.replace(place + 15, 1, version);
        write_text(other, text);
        EXPECT_NE(complaint(other).find("has version " + std::string(version)), std::string::npos)
            << complaint(other);
    }
    write_text(other, "\x89HDF\r\n\x1a\n and so on");
    EXPECT_NE(complaint(other).find("no checkpoint of Starling"), std::string::npos);
    write_text(other, "");
    EXPECT_NE(complaint(other).find("no checkpoint of Starling"), std::string::npos);
    EXPECT_NE(complaint(dir.path() / "none.h5").find("no such"), std::string::npos);
    EXPECT_NE(complaint(dir.path()).find("no such"), std::string::npos);
}

TEST(Checkpoint, OfAnotherGridIsRefused)
{
    TemporaryDirectory dir;
    const Example example;
    const CheckpointFile file(example.write(dir.path()));
    const Grid finer({5, 3, 2}, {0, -1, -1}, {4, 2, 2});
    State state(finer, example.tube);
    EXPECT_THROW(file.read(state), InputError);
}

TEST(Checkpoint, IsNotWrittenOfAStateThatIsNotFinite)
{
    TemporaryDirectory dir;
    for (State Example::*of : {&Example::state, &Example::sound}) {
        Example example;
        (example.*of).fluid.P.values()[3] = std::nan("");
        EXPECT_THROW(example.write(dir.path()), std::logic_error);
        EXPECT_FALSE(fs::exists(dir.path() / "step_0000000042.h5"));
    }
}

TEST(Checkpoint, ThatCannotBeWrittenLeavesTheOldOne)
{
    TemporaryDirectory dir;
    const Example example;
    const fs::path path = example.write(dir.path());
    const std::string before = read_text(path);
    fs::create_directory(path.string() + ".new"); // in the way of the temporary file
    EXPECT_THROW(example.write(dir.path()), std::runtime_error);
    EXPECT_EQ(read_text(path), before);
}

TEST(CheckpointRing, KeepsTheLastOnesAndPointsAtTheLatest)
{
    TemporaryDirectory dir;
    Example example;
    CheckpointRing ring(dir.path(), 2);
    for (Index step : {5, 10, 15}) {
        example.state.step = step;
        ring.write(example.record(""));
    }
    const auto all = CheckpointRing::list(dir.path());
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(CheckpointFile(all[0]).step(), 15);
    EXPECT_EQ(CheckpointFile(all[1]).step(), 10);
    EXPECT_EQ(CheckpointFile(CheckpointRing::folder(dir.path()) / "latest").step(), 15);

    ring.go_on_from(10);
    example.state.step = 12;
    ring.write(example.record(""));
    EXPECT_EQ(CheckpointFile(CheckpointRing::list(dir.path())[0]).step(), 12);
    EXPECT_EQ(CheckpointFile(CheckpointRing::list(dir.path())[1]).step(), 10);
}

TEST(CheckpointRing, KeepsSoundPointsAsLongAsTheirCheckpoints)
{
    TemporaryDirectory dir;
    Example example;
    CheckpointRing ring(dir.path(), 2);
    const fs::path folder = CheckpointRing::folder(dir.path());
    fs::create_directory(folder);
    write_text(folder / "sound_0000000044.h5", "left over by a kill");
    ASSERT_EQ(CheckpointRing::orphans(dir.path()).size(), 1u);
    for (Index step : {42, 45, 50}) {
        example.state.step = step;
        ring.write(example.record(""));
    }
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename());
    std::ranges::sort(names);
    EXPECT_EQ(names,
              (std::vector<std::string>{"latest", "sound_0000000045.h5", "sound_0000000050.h5",
                                        "step_0000000045.h5", "step_0000000050.h5"}));
}

TEST(CheckpointRing, KeepsTheNewerOnesBesideAnOlder)
{
    TemporaryDirectory dir;
    Example example;
    CheckpointRing ring(dir.path(), 2);
    for (Index step : {5, 10, 15, 3}) {
        example.state.step = step;
        ring.write(example.record(""));
    }
    std::vector<Index> steps;
    for (const fs::path& path : CheckpointRing::list(dir.path()))
        steps.push_back(CheckpointFile(path).step());
    EXPECT_EQ(steps, (std::vector<Index>{15, 10, 3}));
    EXPECT_EQ(CheckpointFile(CheckpointRing::folder(dir.path()) / "latest").step(), 15);
}

TEST(CheckpointRing, OfNoneWritesNothing)
{
    TemporaryDirectory dir;
    const Example example;
    CheckpointRing(dir.path(), 0).write(example.record(""));
    EXPECT_TRUE(fs::is_empty(dir.path()));
}

} // namespace
} // namespace starling
