#pragma once
/// What `starling info` and `starling export` do, as text.
#include <filesystem>
#include <string>

namespace starling::app {

/// What is to be said about a directory or a file, and whether all of it is whole.
struct Info {
    std::string text;
    bool whole = true;
};

/// `starling info`; throws InputError where there is nothing that it knows.
Info describe_path(const std::filesystem::path& path);

/// What `starling export` is asked for.
struct ExportRequest {
    std::filesystem::path from; ///< directory of a run, or a frame
    std::filesystem::path to;
    std::string what; ///< "wall", "fluid" or empty: by the name of `to`
    std::string time; ///< in the units of the results; empty: the last
    bool force = false;
};

/// Writes the file and says which time it is of; throws InputError, having written nothing.
std::string export_frame(const ExportRequest& request);

} // namespace starling::app
