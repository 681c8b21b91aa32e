#pragma once
/// A run from a case to a directory of results: the loop, stop criteria and output schedule.
#include <filesystem>

#include "output/checkpoint.hpp"
#include "output/summary.hpp"
#include "simulation/cycles.hpp"
#include "simulation/simulation.hpp"

namespace starling {

struct RunOptions {
    std::filesystem::path directory;
    bool force = false;              ///< replace results of an earlier run
    std::filesystem::path case_file; ///< where the case comes from; never replaced; may be empty
};

/// What is known before the first step.
struct RunStart {
    const Case& description;
    const Simulation& simulation;
};

/// What is known after a step.
struct Progress {
    Index step;
    Real t, dt;
    const TimeStepLimit& limiting; ///< what sets dt
    const Sample& last;            ///< latest sample
    double wall_seconds;
    double steps_per_second;
    double seconds_left;       ///< estimate; NaN while there is none
    const CycleMemory& cycles; ///< of the drive
};

/// A breakdown after which a run goes on.
struct Retry {
    std::string reason; ///< what broke down
    Index step;         ///< from which the run goes on
    Real t;
    Real step_factor; ///< of the automatic step from now on
};

/// Hears of a run as it goes; the library itself prints nothing.
class RunObserver {
public:
    virtual ~RunObserver() = default;
    virtual void started(const RunStart& /*start*/) {}
    virtual void stepped(const Progress& /*progress*/) {}
    virtual void retrying(const Retry& /*retry*/) {}
    /// Something that the user should know now and that does not end the run.
    virtual void warn(const std::string& /*what*/) {}
    /// Asked after every step; a run told to stop writes everything and ends as "interrupted".
    virtual bool stop_requested() { return false; }
};

/// Runs a case and writes DIR/case.toml, series.csv, profile.csv, theory.csv, summary.json and the
/// wall and fluid fields (docs/results.md). Throws InputError, with nothing written, where the case
/// or the directory does not do; NumericalError where the computation breaks down, with the series
/// up to there and the last sound state written; std::runtime_error where a file cannot be written.
Summary run(const Case& c, const RunOptions& options, RunObserver& observer);

/// Goes on with the run in `directory` from a checkpoint of it, to the bit as if it had never
/// stopped: rows and frames after the checkpoint are dropped and written anew. `c` is the case to
/// go on with (resumed_case). Throws as `run` does.
Summary resume(const Case& c, const CheckpointFile& checkpoint,
               const std::filesystem::path& directory, RunObserver& observer);

/// Whether to write a checkpoint `seconds` after the last one: once `every` seconds have gone, or
/// somewhat earlier where the present state has just been found sound, so that the file holds it
/// once and not a sound state beside it.
bool checkpoint_is_timely(double seconds, double every, bool found_sound);

/// A value, as for --set, of the stop criterion that ended a run, with which it would go further;
/// empty where `reason` is none that would end it again.
std::string later_end(const Case& c, const std::string& reason, Index steps);

/// Whether the one-dimensional model describes the case: steady inflation at low Re, or a rigid
/// tube.
bool has_theory(const Case& c);

} // namespace starling
