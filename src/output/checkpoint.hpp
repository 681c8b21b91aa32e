#pragma once
/// Checkpoints: everything a run needs to go on to the bit as if it had never stopped.
///
/// A checkpoint is a sealed HDF5 file (docs/checkpoints.md).
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
};

/// Writes a checkpoint: a temporary file beside `path`, on disk (fsync), then renamed. Throws
/// std::runtime_error where that fails, with `path` as it was; std::logic_error for a state that is
/// not finite.
void write_checkpoint(const std::filesystem::path& path, const State& state,
                      const RunMemory& memory, const std::string& case_text);

/// Whether every number of the state is finite.
bool is_finite(const State& state);

/// A checkpoint on disk, found whole.
class CheckpointFile {
public:
    /// Throws InputError, with the reason, for a file that is missing, foreign, of a newer version,
    /// truncated or damaged.
    explicit CheckpointFile(const std::filesystem::path& path);

    Index step() const { return step_; }
    Real t() const { return t_; }
    const std::string& case_text() const { return case_text_; } ///< as written by write_case
    const std::string& version() const { return version_; }     ///< of the program that wrote it

    /// Fills a state of the same grid and wall; throws InputError where they differ.
    void read(State& state) const;
    RunMemory read_memory() const;

private:
    std::filesystem::path path_;
    Index step_ = 0;
    Real t_ = 0;
    std::string case_text_, version_;
};

/// DIR/checkpoints: files step_NNNNNNNNNN.h5 and the link "latest".
class CheckpointRing {
public:
    CheckpointRing(const std::filesystem::path& run_directory, Index keep);

    /// The run goes on from this step: checkpoints beyond it are of a course that was given up.
    void go_on_from(Index step) { newest_ = step; }
    /// Writes a checkpoint, points "latest" at the newest one, and removes those of a course that
    /// was given up and all but the last ones. One older than the newest, as after a breakdown, is
    /// kept beside them.
    void write(const State& state, const RunMemory& memory, const std::string& case_text);

    /// The checkpoints of a run directory, latest first; by name, unread.
    static std::vector<std::filesystem::path> list(const std::filesystem::path& run_directory);
    static std::filesystem::path folder(const std::filesystem::path& run_directory);

private:
    std::filesystem::path directory_;
    Index keep_;
    Index newest_ = -1; ///< step of the newest checkpoint of this course
};

} // namespace starling
