#pragma once
/// The directory that a run writes to: one run at a time, results never overwritten unasked.
#include <filesystem>

namespace starling {

/// Holds the directory of a run for as long as it lives.
class RunDirectory {
public:
    /// Creates the directory where needed and locks it against other runs. With `force`, files of
    /// an earlier run are removed, and nothing else. Throws InputError, having changed nothing,
    /// where it holds results (without `force`), is in use by another run or cannot be written.
    RunDirectory(std::filesystem::path path, bool force);
    ~RunDirectory();
    RunDirectory(const RunDirectory&) = delete;
    RunDirectory& operator=(const RunDirectory&) = delete;

    /// The refusals of the constructor that need no writing, for a look before a long set-up.
    static void check(const std::filesystem::path& path, bool force);

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path file(const char* name) const { return path_ / name; }

private:
    std::filesystem::path path_;
    int lock_ = -1; ///< descriptor of the lock file
};

} // namespace starling
