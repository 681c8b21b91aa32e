#pragma once
/// A run from a case to a directory of results: the loop, stop criteria and output schedule.
#include <filesystem>

#include "output/summary.hpp"
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
    double seconds_left; ///< estimate; NaN while there is none
};

/// Hears of a run as it goes; the library itself prints nothing.
class RunObserver {
public:
    virtual ~RunObserver() = default;
    virtual void started(const RunStart& /*start*/) {}
    virtual void stepped(const Progress& /*progress*/) {}
    /// Asked after every step; a run told to stop writes everything and ends as "interrupted".
    virtual bool stop_requested() { return false; }
};

/// Runs a case and writes DIR/case.toml, series.csv, profile.csv, theory.csv, summary.json and the
/// wall and fluid fields (docs/results.md). Throws InputError, with nothing written, where the case
/// or the directory does not do; NumericalError where the computation breaks down, with the series
/// up to there and the last sound state written; std::runtime_error where a file cannot be written.
Summary run(const Case& c, const RunOptions& options, RunObserver& observer);

/// Whether the one-dimensional model describes the case: steady inflation at low Re, or a rigid
/// tube.
bool has_theory(const Case& c);

} // namespace starling
