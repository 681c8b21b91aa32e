#pragma once
/// The directory that a run writes to: one run at a time, results never overwritten unasked.
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

namespace starling {

/// First line of a case.toml that a run has written; without it the file is the user's own.
inline constexpr const char* written_case_mark = "# Written by starling run";

/// What a run is to do with its directory.
struct RunDirectoryOptions {
    std::filesystem::path path;
    bool force = false;              ///< remove the results of an earlier run
    std::filesystem::path case_file; ///< the user's case file, never to be removed; may be empty
    bool go_on = false;              ///< keep everything: the earlier run is resumed
};

/// The directory of a run was moved, removed or replaced while the run was writing to it.
class DirectoryLost : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Holds the directory of a run for as long as it lives.
class RunDirectory {
public:
    /// Creates the directory where needed and locks it against other runs. With `force`, files of
    /// an earlier run are removed (of links the link), and nothing else. Throws InputError, having
    /// changed nothing, where it holds results (without `force`), a directory or the user's case
    /// file under the name of a result, is in use by another run or cannot be written.
    explicit RunDirectory(const RunDirectoryOptions& options);
    ~RunDirectory();
    RunDirectory(const RunDirectory&) = delete;
    RunDirectory& operator=(const RunDirectory&) = delete;

    /// The refusals of the constructor that need no writing, for a look before a long set-up.
    static void check(const RunDirectoryOptions& options);
    /// Whether a run is writing to the directory now.
    static bool in_use(const std::filesystem::path& path);

    /// Throws DirectoryLost where the lock at `path` is no longer this one: to write on would mix
    /// two runs, or make parts of a directory anew.
    void check_held() const;
    /// Where the locked directory is now; empty where it was removed.
    std::optional<std::filesystem::path> where() const;

    /// Removes the files that a run writes when it ends or breaks down.
    void remove_end() const;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path file(const char* name) const { return path_ / name; }

private:
    std::filesystem::path path_;
    int lock_ = -1; ///< descriptor of the lock file
};

} // namespace starling
