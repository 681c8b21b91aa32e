#pragma once
/// The files of one run: which are written when, and how a run goes on with them.
#include <limits>
#include <optional>

#include "output/checkpoint.hpp"
#include "output/field_file.hpp"
#include "output/run_directory.hpp"
#include "output/series.hpp"
#include "output/summary.hpp"
#include "simulation/attempts.hpp"
#include "simulation/cycles.hpp"
#include "simulation/simulation.hpp"
#include "simulation/time_step.hpp"
#include "theory/theory_report.hpp"

namespace starling {

/// The times at which frames are due: 0 and the multiples of `every`.
class Schedule {
public:
    explicit Schedule(std::optional<Real> every) : every_(every) {}
    /// Time of the next frame; infinite where only the first and last states are wanted.
    Real next() const { return every_ ? next_ : std::numeric_limits<Real>::infinity(); }
    /// Whether a frame is due at t; one due within a quarter of a step counts.
    bool due(Real t, Real dt);
    /// Goes on at t; `next` is kept where it is a multiple of `every`.
    void go_on(Real t, Real next);

private:
    std::optional<Real> every_;
    Real next_ = 0;
};

class RunFiles {
public:
    /// The files of a new run, or with `go_on` those of the run that `memory` is of.
    /// Case and cycles must outlive it.
    RunFiles(const Case& c, const RunDirectoryOptions& directory, const Cycles& cycles);

    void begin();
    /// All that a run which ends at `step` writes after its last checkpoint, with `memory`, is
    /// there.
    bool complete(const RunMemory& memory, Index step) const;
    /// Throws InputError where the files do not reach up to the moment of `memory`, or where the
    /// frames there have another grid than those of this case would have.
    void check_go_on(const RunMemory& memory, const Case& before) const;
    /// Damage to files before the moment of `memory` with which the run can go on, a line for each.
    std::vector<std::string> damage(const RunMemory& memory) const;
    /// Drops what was written after the moment of `memory`, at t and `step`, and goes on there.
    void go_on_from(const RunMemory& memory, Real t, Index step);
    /// Notes in `memory` how far the files are.
    void note(RunMemory& memory) const;

    void theory(const TheoryReport& report);
    /// Where this or one of the next two fails for want of room it may be called again.
    void sample(const Sample& s);
    /// Wall and fluid frames that are due now.
    void fields(const Simulation& simulation);
    Index last_row() const { return last_row_; } ///< step of the last row of series.csv
    /// See starling::mean_leak_over_Q, of the rows up to a step.
    Real mean_leak(Index last_step) const
    {
        return mean_leak_over_Q(directory_.file("series.csv"), last_step);
    }
    /// Time of the next frame.
    Real next_frame() const { return std::min(wall_due_.next(), fluid_due_.next()); }
    void first_wall(const Simulation& simulation);
    /// Throws DirectoryLost where the directory is no longer this run's.
    void check_held() const { directory_.check_held(); }
    /// Writes a checkpoint to where the directory is now; returns its place, empty where it is
    /// gone.
    std::optional<std::filesystem::path> rescue(const Simulation& simulation,
                                                const RunMemory& memory) const;
    /// A checkpoint of the present state, with `good` of the last one found sound.
    /// Before that, rows and frames that belong to it are waited for until they are on disk.
    void checkpoint(const Simulation& simulation, const RunMemory& memory, const RunMemory& good);
    /// The same where the run has gone back: checkpoints beyond are of a course that is given up,
    /// and removed. To be written before rows and frames of that course are dropped.
    void checkpoint_of_return(const Simulation& simulation, const RunMemory& memory,
                              const RunMemory& good);
    /// Whether `file` is the latest checkpoint of this run.
    bool is_newest(const CheckpointFile& file) const;
    /// What is around a breakdown, in the last sound state and in the broken one.
    void breakdown(const Neighbourhood& sound, const Neighbourhood& broken);
    /// What is written once a run has ended, beside the summary.
    void finish(const Simulation& simulation, Attempts& attempt);
    void summary(const Summary& s);
    /// Waits until rows, frames and the files of the end are on the disk itself.
    void sync();

private:
    void write_own_case() const;
    bool lists_frame(const std::string& of, Index number) const;
    FieldFileOptions field_options(Index keep) const;
    void wall(const Simulation& simulation);
    void fluid(const Simulation& simulation);

    const Case& case_;
    const Cycles& cycles_;
    RunDirectory directory_;
    CheckpointRing checkpoints_;
    std::optional<SeriesWriter> series_;
    Schedule wall_due_, fluid_due_;
    std::optional<WallFile> wall_;
    std::optional<FluidFile> fluid_;
    bool wall_is_due_ = false, fluid_is_due_ = false;        ///< now, and not yet written
    Index last_row_ = -1, wall_step_ = -1, fluid_step_ = -1; ///< steps of the last row and frames
};

} // namespace starling
