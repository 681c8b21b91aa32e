#pragma once
/// Checkpoints: everything a run needs to go on to the bit as if it had never stopped.
///
/// A checkpoint is a sealed HDF5 file (docs/checkpoints.md). Where the last sound state, to which a
/// run goes back after a breakdown, is of an earlier step, it stands in a second one beside it.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/sealed_file.hpp"
#include "solver/cycle.hpp"
#include "solver/state.hpp"

namespace starling {

inline constexpr Seal checkpoint_seal = {"checkpoint", 5, "docs/checkpoints.md"};

/// What a run remembers beside the state of the computation.
struct RunMemory {
    std::vector<Sample> window;              ///< samples that the steady criterion looks back on
    CycleMemory cycles;                      ///< of the drive
    Index last_row = -1;                     ///< step of the last row of series.csv
    Index wall_frames = 0, fluid_frames = 0; ///< frames on disk
    Index wall_step = -1, fluid_step = -1;   ///< steps of the last of them
    Real next_wall = 0, next_fluid = 0;      ///< times of the next frames
    double wall_seconds = 0;                 ///< real time so far
    Real step_factor = 1;                    ///< of the automatic step, after a blow-up
    std::vector<Real> phase_seconds;         ///< time in the phases of the step so far
};

/// A run after one of its steps.
struct RunPoint {
    const State& state;
    const RunMemory& memory;
};

/// What a run can go on from.
struct RunRecord {
    RunPoint now, sound; ///< the latter: to which the run goes back after a breakdown
    const std::string& case_text;
};

/// Writes a checkpoint to `folder`, step_NNNNNNNNNN.h5, after sound_NNNNNNNNNN.h5 with the sound
/// point where that is of another step. Each is a temporary file, on disk (fsync), then renamed.
/// Returns its path. Throws std::runtime_error where that fails, with an older step_NNNNNNNNNN.h5
/// as it was; std::logic_error for a state that is not finite.
std::filesystem::path write_checkpoint(const std::filesystem::path& folder,
                                       const RunRecord& record);

/// Whether every number of the state is finite.
bool is_finite(const State& state);

/// A checkpoint on disk, found whole.
class CheckpointFile {
public:
    /// Throws InputError, with the reason, for a file that is missing, foreign, of a newer version,
    /// truncated or damaged.
    explicit CheckpointFile(const std::filesystem::path& path);

    const std::filesystem::path& path() const { return path_; }
    Index step() const { return step_; }
    Real t() const { return t_; }
    const std::string& case_text() const { return case_text_; } ///< as written by write_case
    const std::string& version() const { return version_; }     ///< of the program that wrote it

    /// Fills a state of the same grid and wall; throws InputError where they differ.
    void read(State& state) const;
    RunMemory read_memory() const;

    /// The last sound point up to there: this file or the one beside it, which it names. Throws
    /// InputError where that is missing or damaged.
    CheckpointFile sound() const;

private:
    std::filesystem::path path_;
    Index step_ = 0, sound_step_ = 0;
    Real t_ = 0;
    std::string case_text_, version_;
};

/// DIR/checkpoints: files step_NNNNNNNNNN.h5, sound_NNNNNNNNNN.h5 beside some, the link "latest".
class CheckpointRing {
public:
    CheckpointRing(const std::filesystem::path& run_directory, Index keep);

    /// The run goes on from this step: checkpoints beyond it are of a course that was given up.
    void go_on_from(Index step) { newest_ = step; }
    /// Writes a checkpoint, points "latest" at the newest one, and removes those of a course that
    /// was given up and all but the last ones. One older than the newest, as after a breakdown, is
    /// kept beside them.
    void write(const RunRecord& record);

    /// The checkpoints of a run directory, latest first; by name, unread.
    static std::vector<std::filesystem::path> list(const std::filesystem::path& run_directory);
    /// Files of sound points without their checkpoint, as a kill may leave them.
    static std::vector<std::filesystem::path> orphans(const std::filesystem::path& run_directory);
    static std::filesystem::path folder(const std::filesystem::path& run_directory);

private:
    std::filesystem::path directory_;
    Index keep_;
    Index newest_ = -1; ///< step of the newest checkpoint of this course
};

} // namespace starling
