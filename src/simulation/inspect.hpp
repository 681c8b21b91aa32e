#pragma once
/// What is in a run directory or one of its files, and whether it is whole. Reads only; works on
/// what a kill has left and on damaged files.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/frame_file.hpp"
#include "output/series.hpp"

namespace starling {

/// A file that is not as it should be.
struct Finding {
    std::filesystem::path path;
    std::string problem;
};

/// A checkpoint.
struct CheckpointContents {
    std::filesystem::path path;
    Index step = 0;
    Real t = 0;                              ///< in the units of the case
    Index wall_frames = 0, fluid_frames = 0; ///< that belong to it
    std::string unit_of_t, version, title;
    std::string problem;  ///< empty: whole
    std::string obstacle; ///< why other files do not let a run go on from it; empty: they do
};

/// A run directory.
struct RunContents {
    std::string title;
    bool running = false;  ///< a run is writing to it now
    std::string ended;     ///< reason in summary.json; empty where the run has not ended
    std::string later_end; ///< for --set: with it a run that has ended would go further
    std::optional<SeriesContents> series;
    std::vector<ListedFrame> wall, fluid;
    std::vector<CheckpointContents> checkpoints;  ///< latest first
    std::vector<std::filesystem::path> leftovers; ///< what a kill has left unfinished
    std::vector<Finding> findings;                ///< empty: all files are whole
    bool case_is_damaged = false;                 ///< that of case.toml is among them
};

/// Throws InputError where the directory holds nothing of a run.
RunContents inspect_run(const std::filesystem::path& directory);

/// Looks at the file of a checkpoint; never throws for what is wrong with it.
CheckpointContents inspect_checkpoint(const std::filesystem::path& path);

} // namespace starling
