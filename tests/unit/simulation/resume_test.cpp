#include <gtest/gtest.h>

#include <cstring>

#include "config/write_case.hpp"
#include "core/error.hpp"
#include "core/for_each.hpp"
#include "output/checkpoint.hpp"
#include "simulation/resume.hpp"
#include "simulation/run.hpp"
#include "unit/output/temporary_directory.hpp"

namespace starling {
namespace {

namespace fs = std::filesystem;

Case coarse_tube()
{
    Case c;
    c.tube.length = 4;
    c.tube.rigid_inlet = c.tube.rigid_outlet = 0.8;
    c.grid.spacing = 0.33;
    c.grid.width_y = c.grid.width_z = 4.5;
    c.drive.pressure_inlet = 2 * c.baseline_pressure_drop();
    c.stop.steps = 100;
    return c;
}

/// A number that differs if any bit of a state does (but not of what is no part of it).
std::string bits(const State& s)
{
    std::string all;
    const auto add = [&](const auto& a) {
        all.append(reinterpret_cast<const char*>(a.data()),
                   sizeof(*a.data()) * static_cast<std::size_t>(a.size()));
    };
    for (std::size_t c = 0; c < 3; ++c) {
        add(s.fluid.u.component[c].values());
        add(s.fluid.N_before.component[c].values());
        add(s.ghosts[c].inside.values());
        for (const NearNode& n : s.ghosts[c].near_wall)
            all += std::to_string(n.i) + " " + std::to_string(n.j) + " " + std::to_string(n.k) +
                   " " + std::to_string(n.intercept.element) + ",";
    }
    add(s.fluid.P.values());
    add(s.wall.x);
    add(s.wall.velocity);
    const std::array<Real, 3> times = {s.t, s.dt, s.fluid.dt_before};
    all.append(reinterpret_cast<const char*>(times.data()), sizeof(times));
    return all;
}

/// An inflating membrane, or a wall that resists bending and is pressed together.
Case coarse_case(bool pressed)
{
    Case c = coarse_tube();
    if (!pressed) return c;
    c.material.bending = 0.02;
    c.drive.pressure_external = 3 * c.baseline_pressure_drop();
    return c;
}

class Resume : public testing::TestWithParam<std::pair<int, bool>> {
protected:
    Resume() { omp_set_num_threads(2); }
    ~Resume() override { omp_set_num_threads(threads_); }
    Resume(const Resume&) = delete;
    Resume& operator=(const Resume&) = delete;

private:
    int threads_ = max_threads();
};

TEST_P(Resume, ContinuesToTheBitFromAnyStep)
{
    constexpr Index last = 45;
    TemporaryDirectory dir;
    const auto [threads, pressed] = GetParam();
    const Case c = coarse_case(pressed);
    Simulation whole(c);
    for (Index n = 0; n < last; ++n) {
        if (n % 9 == 4 || n == 0)
            write_checkpoint(dir.path(),
                             {{whole.state(), {}}, {whole.good_state(), {}}, write_case(c)});
        whole.step();
    }
    omp_set_num_threads(threads);
    for (const auto& entry : fs::directory_iterator(dir.path())) {
        if (entry.path().filename().string().starts_with("sound")) continue;
        const CheckpointFile file(entry.path());
        Simulation part(c);
        part.restore([&](State& s) { file.read(s); }, [&](State& s) { file.sound().read(s); }, 1);
        while (part.steps() < last) part.step();
        EXPECT_TRUE(bits(part.state()) == bits(whole.state())) << "from step " << file.step();
    }
}

INSTANTIATE_TEST_SUITE_P(ThreadsAndWalls, Resume,
                         testing::Values(std::pair{1, false}, std::pair{2, false},
                                         std::pair{1, true}));

class Quiet : public RunObserver {
public:
    void retrying(const Retry& retry) override { retries.push_back(retry); }
    void warn(const std::string& what) override { warnings += what + '\n'; }
    std::vector<Retry> retries;
    std::string warnings;
};

/// A run of a case into a directory of its own.
Summary run_to(const Case& c, const fs::path& directory, RunObserver& observer)
{
    return run(c, {directory, false, {}}, observer);
}

TEST(ResumedCase, MayStopElsewhereButNotBeAnother)
{
    TemporaryDirectory dir;
    Case c = coarse_tube();
    c.stop.steps = 2;
    Quiet quiet;
    run_to(c, dir.path() / "out", quiet);
    const fs::path out = dir.path() / "out";
    const CheckpointFile file = latest_checkpoint(out);
    EXPECT_EQ(file.step(), 2);
    using enum Changes;
    EXPECT_EQ(
        resumed_case(out, file, {"stop.steps=9", "output.wall=false"}, stop_and_output).stop.steps,
        9);
    std::string message;
    try {
        resumed_case(out, file, {"wall.eps=0.5", "stop.steps=9"}, stop_and_output);
    } catch (const InputError& e) {
        message = e.what();
    }
    EXPECT_NE(message.find("wall.eps: was 0.02, is 0.5"), std::string::npos) << message;
    EXPECT_EQ(message.find("stop"), std::string::npos) << message;
    EXPECT_EQ(resumed_case(out, file, {"wall.eps=0.5"}, any).material.eps, 0.5);
}

TEST(ResumedRun, WithNothingToDoIsRefusedAndChangesNothing)
{
    TemporaryDirectory dir;
    Case c = coarse_tube();
    c.stop.steps = 2;
    Quiet quiet;
    const fs::path out = dir.path() / "out";
    run_to(c, out, quiet);
    const std::string before = read_text(out / "series.csv") + read_text(out / "case.toml");
    EXPECT_THROW(resume(c, latest_checkpoint(out), out, quiet), InputError);
    EXPECT_EQ(read_text(out / "series.csv") + read_text(out / "case.toml"), before);
}

/// Takes down the steps of a run.
class Steps : public Quiet {
public:
    void started(const RunStart& start) override { t_ = start.simulation.time(); }
    void stepped(const Progress& p) override
    {
        dt.push_back(p.t - t_);
        t_ = p.t;
    }
    std::vector<Real> dt;

private:
    Real t_ = 0;
};

TEST(ResumedRun, TakesAChangedStepAtOnce)
{
    TemporaryDirectory dir;
    Case c = coarse_tube();
    c.time.step = 0.004;
    c.stop.steps = 11;
    Steps steps;
    const fs::path out = dir.path() / "out";
    run_to(c, out, steps);
    for (const auto& step : {std::optional<Real>(0.003), std::optional<Real>()}) {
        c.time.step = step;
        *c.stop.steps += 1;
        resume(c, latest_checkpoint(out), out, steps);
        EXPECT_NEAR(steps.dt.back(), step.value_or(Simulation(c).dt()), 1e-12);
    }
}

TEST(ResumedRun, KeepsTheFactorOnTheStepUnlessTheStepIsAnother)
{
    TemporaryDirectory dir;
    Case c = coarse_tube();
    c.stop.steps = 3;
    Quiet quiet;
    const fs::path out = dir.path() / "out";
    run_to(c, out, quiet);
    Simulation halved(c);
    RunMemory memory = latest_checkpoint(out).read_memory();
    memory.step_factor = 0.5;
    memory.last_row = 0;
    CheckpointRing(out, 3).write(
        {{halved.state(), memory}, {halved.state(), memory}, write_case(c)});
    const CheckpointFile half(CheckpointRing::list(out).back());
    const std::string wanted = "50 % of the automatic";
    c.material.eps *= 1.01;
    EXPECT_NE(resume(c, half, out, quiet).warnings.back().find(wanted), std::string::npos);
    c.time.safety = 0.9;
    *c.stop.steps += 1;
    for (const std::string& warning : resume(c, latest_checkpoint(out), out, quiet).warnings)
        EXPECT_EQ(warning.find(wanted), std::string::npos) << warning;
}

// Killed before the next checkpoint is due.
TEST(ResumedRun, LeavesNoCheckpointOfTheCourseThatWasGivenUp)
{
    class Killed : public Quiet {
        void started(const RunStart& /*start*/) override { throw std::runtime_error("killed"); }
    } killed;
    for (const Index keep : {0, 3}) {
        TemporaryDirectory dir;
        Case c = coarse_tube();
        c.stop.steps = 28;
        c.checkpoint.steps = 7;
        Quiet quiet;
        const fs::path out = dir.path() / "out";
        run_to(c, out, quiet);
        const std::string whole = read_text(out / "series.csv");
        const CheckpointFile early(out / "checkpoints" / "step_0000000014.h5");
        c.checkpoint.keep = keep;
        EXPECT_THROW(resume(c, early, out, killed), std::runtime_error);
        EXPECT_EQ(latest_checkpoint(out).step(), 14);
        resume(c, latest_checkpoint(out), out, quiet);
        EXPECT_EQ(read_text(out / "series.csv"), whole);
    }
}

TEST(LatestCheckpoint, OffersTheOneBeforeADamagedOne)
{
    TemporaryDirectory dir;
    Case c = coarse_tube();
    c.stop.steps = 4;
    c.checkpoint.steps = 2;
    Quiet quiet;
    run_to(c, dir.path() / "out", quiet);
    const auto all = CheckpointRing::list(dir.path() / "out");
    ASSERT_EQ(all.size(), 2u);
    fs::resize_file(all[0], fs::file_size(all[0]) - 10);
    std::string message;
    try {
        latest_checkpoint(dir.path() / "out");
    } catch (const InputError& e) {
        message = e.what();
    }
    EXPECT_NE(message.find("truncated"), std::string::npos) << message;
    EXPECT_NE(message.find("--from " + all[1].string()), std::string::npos) << message;
}

/// Short edges without the filter: the wall trembles at twice the automatic step.
Case trembling_tube()
{
    Case c = coarse_tube();
    c.time.safety = 2;
    c.tube.mesh_filter = 0;
    c.tube.edge_over_spacing = 0.3;
    c.stop.steps = 120;
    return c;
}

TEST(Retry, GoesOnWithHalfTheStepWithoutAGapOrADoubleRow)
{
    TemporaryDirectory dir;
    const Case c = trembling_tube();
    Quiet quiet;
    const Summary summary = run_to(c, dir.path() / "out", quiet);
    ASSERT_FALSE(quiet.retries.empty());
    EXPECT_EQ(quiet.retries[0].step_factor, 0.5);
    EXPECT_NE(summary.warnings.back().find("broke down"), std::string::npos);
    std::ifstream series(dir.path() / "out" / "series.csv");
    std::string line;
    std::getline(series, line);
    Index expected = 0;
    for (; std::getline(series, line); expected += c.output.sample_every)
        EXPECT_EQ(line.substr(line.find(',') + 1, std::to_string(expected).size() + 1),
                  std::to_string(expected) + ",");
    EXPECT_EQ(expected, 130);
}

/// Stops and goes on at each of the steps; what was tried again on the way.
std::vector<Retry> run_in_parts(Case c, const fs::path& out, const std::vector<Index>& stops)
{
    Quiet quiet;
    const Index last = *c.stop.steps;
    c.stop.steps = stops.front();
    run_to(c, out, quiet);
    for (std::size_t n = 1; n <= stops.size(); ++n) {
        c.stop.steps = n < stops.size() ? stops[n] : last;
        resume(c, latest_checkpoint(out), out, quiet);
    }
    return quiet.retries;
}

// The wall breaks down twice, and goes back to states before the moments at which the run stopped.
TEST(Retry, IsTheSameToTheBitAfterResuming)
{
    TemporaryDirectory dir;
    Case c = trembling_tube();
    c.output.wall_every = 0.2;
    Quiet quiet;
    const fs::path whole = dir.path() / "whole", parts = dir.path() / "parts";
    run_to(c, whole, quiet);
    ASSERT_FALSE(quiet.retries.empty());
    const auto retries = run_in_parts(c, parts, {7, 47, 52, 63, 101});
    ASSERT_EQ(retries.size(), quiet.retries.size());
    for (std::size_t n = 0; n < retries.size(); ++n) {
        EXPECT_EQ(retries[n].step, quiet.retries[n].step);
        EXPECT_EQ(retries[n].reason, quiet.retries[n].reason);
    }
    for (const char* name : {"series.csv", "profile.csv", "sections.csv", "wall.xdmf"})
        EXPECT_EQ(read_text(whole / name), read_text(parts / name)) << name;
}

// Killed after it has gone back, before the next checkpoint would be due.
TEST(Retry, LeavesACheckpointToGoOnFrom)
{
    class Killed : public Quiet {
        void retrying(const Retry& /*retry*/) override { throw std::runtime_error("killed"); }
    } killed;
    TemporaryDirectory dir;
    Case c = trembling_tube();
    c.checkpoint.steps = 9; // newer than the sound state
    const fs::path whole = dir.path() / "whole", out = dir.path() / "out";
    EXPECT_THROW(run_to(c, out, killed), std::runtime_error);
    const CheckpointFile latest = latest_checkpoint(out);
    EXPECT_EQ(latest.read_memory().step_factor, 0.5);
    Quiet quiet;
    resume(c, latest, out, quiet);
    run_to(c, whole, quiet);
    EXPECT_EQ(read_text(whole / "series.csv"), read_text(out / "series.csv"));
}

TEST(CheckpointIsTimely, SomewhatEarlierAtASoundState)
{
    EXPECT_FALSE(checkpoint_is_timely(530, 600, true));
    EXPECT_TRUE(checkpoint_is_timely(541, 600, true));
    EXPECT_FALSE(checkpoint_is_timely(599, 600, false));
    EXPECT_TRUE(checkpoint_is_timely(600, 600, false));
}

TEST(Retry, IsNotMadeWhereWallsMeet)
{
    TemporaryDirectory dir;
    Case c = coarse_tube();
    c.tube = {.length = 2 * pi, .rigid_inlet = 0.6, .rigid_outlet = 0.6};
    c.material.eps = 0.005;
    c.material.bending = 0.01;
    c.perturbation = {.amplitude = 0.2, .mode = 2};
    c.grid = {};
    c.grid.spacing = 0.25;
    c.drive.pressure_inlet = 0;
    c.drive.pressure_outlet = -6 * c.baseline_pressure_drop();
    c.stop.steps = 600;
    Quiet quiet;
    EXPECT_THROW(run_to(c, dir.path() / "out", quiet), NumericalError);
    EXPECT_TRUE(quiet.retries.empty());
    EXPECT_GE(latest_checkpoint(dir.path() / "out").step(), 50); // the last sound state
}

TEST(Retry, IsNotMadeWithAFixedStep)
{
    TemporaryDirectory dir;
    Case c = coarse_tube();
    c.time.step = 3;
    Quiet quiet;
    EXPECT_THROW(run_to(c, dir.path() / "out", quiet), NumericalError);
    EXPECT_TRUE(quiet.retries.empty());
    EXPECT_EQ(latest_checkpoint(dir.path() / "out").step(), 0); // the last sound state
}

// A file stands where the folder of the checkpoints would be.
TEST(Breakdown, IsToldAlsoWhereItsCheckpointCannotBeWritten)
{
    TemporaryDirectory dir;
    const fs::path out = dir.path() / "out";
    fs::create_directory(out);
    std::ofstream(out / "checkpoints") << "in the way";
    Case c = coarse_tube();
    c.time.step = 3;
    Quiet quiet;
    EXPECT_THROW(run_to(c, out, quiet), NumericalError);
    EXPECT_NE(quiet.warnings.find("checkpoints"), std::string::npos) << quiet.warnings;
    for (const char* name : {"summary.json", "profile.csv", "sections.csv", "breakdown_wall.h5"})
        EXPECT_TRUE(fs::exists(out / name)) << name;
}

/// Puts something in the way of a file once the run has begun.
class Saboteur : public Quiet {
public:
    explicit Saboteur(fs::path file) : obstacle(file.string() + ".new") {}
    void stepped(const Progress& /*progress*/) override
    {
        fs::create_directories(obstacle / "in the way");
    }
    const fs::path obstacle;
};

TEST(EndedRun, WritesAllButWhatFailsAndIsCompletedLater)
{
    Case c = coarse_tube();
    c.stop.steps = 3;
    for (const char* name :
         {"profile.csv", "sections.csv", "frames/wall_000001.h5", "frames/fluid_000000.h5",
          "summary.json", "checkpoints/step_0000000003.h5"}) {
        TemporaryDirectory dir;
        const fs::path out = dir.path() / "out";
        fs::create_directories(out / "checkpoints");
        fs::create_directories(out / "frames");
        Saboteur saboteur(out / name);
        std::string message;
        try {
            run_to(c, out, saboteur);
        } catch (const std::runtime_error& e) {
            message = e.what();
        }
        for (const char* words : {name, "free space"})
            EXPECT_NE(message.find(words), std::string::npos) << message;
        for (const char* other : {"summary.json", "profile.csv", "sections.csv"})
            EXPECT_TRUE(other == std::string(name) || fs::exists(out / other)) << other;
        fs::remove_all(saboteur.obstacle);
        if (CheckpointRing::list(out).empty()) continue;
        EXPECT_NE(message.find("starling resume " + out.string()), std::string::npos) << message;
        Quiet quiet;
        resume(c, latest_checkpoint(out), out, quiet);
        EXPECT_TRUE(fs::exists(out / name)) << name;
        EXPECT_THROW(resume(c, latest_checkpoint(out), out, quiet), InputError); // nothing to do
    }
}

} // namespace
} // namespace starling
