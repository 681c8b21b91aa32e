#include "output/run_directory.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "core/error.hpp"
#include "output/file_name.hpp"
#include "output/shell_word.hpp"

namespace starling {

namespace fs = std::filesystem;

namespace {

/// Everything that a run, `starling plot` and `starling report` write; each may leave a NAME.new
/// after a kill.
constexpr const char* result_files[] = {"case.toml",
                                        "summary.json",
                                        "series.csv",
                                        "profile.csv",
                                        "sections.csv",
                                        "theory.csv",
                                        "wall.h5",
                                        "wall.xdmf",
                                        "fluid.h5",
                                        "fluid.xdmf",
                                        "tube.png",
                                        "profiles.png",
                                        "history.png",
                                        "flow.png",
                                        "waves.png",
                                        "breakdown.png",
                                        "report.html",
                                        "breakdown_wall.h5",
                                        "breakdown_wall.xdmf",
                                        "breakdown_fluid.h5",
                                        "breakdown_fluid.xdmf"};
constexpr const char* files_of_the_end[] = {
    "summary.json",        "profile.csv",        "sections.csv",         "breakdown_wall.h5",
    "breakdown_wall.xdmf", "breakdown_fluid.h5", "breakdown_fluid.xdmf", "breakdown.png"};
/// Folders of a run, what stands before the number in the names of its files in them, of how many
/// digits that is, and another name.
struct ResultFolder {
    const char* name;
    std::vector<std::string> prefixes;
    std::size_t digits;
    std::string link = "";
};
const std::vector<std::string> breakdown_prefixes = {"breakdown_wall_", "breakdown_fluid_"};
const ResultFolder result_folders[] = {
    {"frames", {"wall_", "fluid_", breakdown_prefixes[0], breakdown_prefixes[1]}, 6},
    {"checkpoints", {"step_", "sound_"}, 10, "latest"}};
constexpr const char* lock_file = ".starling.lock";

[[noreturn]] void refuse(const fs::path& path, const std::string& reason)
{
    throw InputError("output directory " + path.string() + ": " + reason);
}

std::string leftover(const char* name) { return std::string(name) + ".new"; }

bool is_there(const fs::path& path) { return fs::exists(fs::symlink_status(path)); }

bool belongs_to(const ResultFolder& folder, const std::string& name)
{
    if (!folder.link.empty() && (name == folder.link || name == folder.link + ".new")) return true;
    return std::ranges::any_of(folder.prefixes, [&](const std::string& prefix) {
        return is_numbered_or_unfinished(name, prefix, folder.digits, ".h5");
    });
}

/// The run's own files in one of its folders.
std::vector<fs::path> files_in(const fs::path& path, const ResultFolder& folder)
{
    std::vector<fs::path> ours;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(path / folder.name, none))
        if (belongs_to(folder, entry.path().filename())) ours.push_back(entry.path());
    return ours;
}

std::string first_result(const fs::path& path)
{
    for (const char* name : result_files)
        if (is_there(path / name)) return name;
    for (const ResultFolder& folder : result_folders)
        if (!files_in(path, folder).empty()) return folder.name;
    return "";
}

bool written_by_a_run(const fs::path& case_file)
{
    std::ifstream stream(case_file);
    std::string line;
    return std::getline(stream, line) && line.starts_with(written_case_mark);
}

/// Refuses to remove what no run has written.
void check_removal(const fs::path& path, const fs::path& name, const fs::path& case_file)
{
    const fs::path file = path / name;
    const fs::file_status status = fs::symlink_status(file);
    if (!fs::exists(status)) return;
    if (!fs::is_regular_file(status) && !fs::is_symlink(status))
        refuse(path, name.string() + " in it is no file of a run; move it away");
    std::error_code none;
    if (!case_file.empty() && fs::equivalent(file, case_file, none))
        refuse(path, name.string() + " in it is the case file itself, which the run would replace; "
                                     "copy it to another place and run that");
    if (name == "case.toml" && !written_by_a_run(file))
        refuse(path, "case.toml in it was not written by a run and would be lost; move it away");
}

void make(const fs::path& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    if (error) refuse(path, "cannot be created: " + error.message());
}

/// The file at `path` is still the open one: a run that ends removes its lock file.
bool is_at(int file, const fs::path& path)
{
    struct stat opened = {}, found = {};
    return fstat(file, &opened) == 0 && stat(path.c_str(), &found) == 0 &&
           opened.st_dev == found.st_dev && opened.st_ino == found.st_ino;
}

/// Returns the descriptor of the locked file. The kernel drops the lock when the process ends,
/// however it ends.
int lock(const fs::path& path)
{
    const fs::path name = path / lock_file;
    while (true) {
        const int file = open(name.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
        if (file < 0) refuse(path, std::string("cannot be written to: ") + std::strerror(errno));
        const bool locked = flock(file, LOCK_EX | LOCK_NB) == 0;
        if (locked && is_at(file, name)) return file;
        close(file);
        if (!locked)
            refuse(path, "another run is writing to it; choose another directory or wait for that "
                         "run");
    }
}

void unlock(const fs::path& path, int file)
{
    const fs::path name = path / lock_file;
    if (is_at(file, name)) unlink(name.c_str()); // else it is another run's
    close(file);
}

} // namespace

void RunDirectory::check(const RunDirectoryOptions& options)
{
    const fs::path& path = options.path;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (error && status.type() != fs::file_type::not_found) refuse(path, error.message());
    if (!fs::exists(status)) return;
    if (!fs::is_directory(status)) refuse(path, "is a file, not a directory");
    if (access(path.c_str(), W_OK | X_OK) != 0)
        refuse(path, std::string("cannot be written to: ") + std::strerror(errno));
    if (options.go_on) return;
    const std::string found = first_result(path);
    if (!options.force && !found.empty())
        refuse(path, "holds results of an earlier run (" + found +
                         "); choose another directory, --force to replace them, or go on with it: "
                         "starling resume " +
                         shell_word(path));
    for (const char* name : result_files) {
        check_removal(path, name, options.case_file);
        check_removal(path, leftover(name), options.case_file);
    }
    for (const ResultFolder& folder : result_folders)
        for (const fs::path& file : files_in(path, folder))
            check_removal(path, fs::path(folder.name) / file.filename(), options.case_file);
}

bool RunDirectory::in_use(const fs::path& path)
{
    const int file = open((path / lock_file).c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return false;
    const bool locked = flock(file, LOCK_SH | LOCK_NB) != 0;
    close(file);
    return locked;
}

namespace {

void remove_results(const fs::path& path)
{
    for (const char* name : result_files) {
        fs::remove(path / name);
        fs::remove(path / leftover(name));
    }
    for (const ResultFolder& folder : result_folders) {
        const auto ours = files_in(path, folder);
        for (const fs::path& file : ours) fs::remove(file);
        std::error_code none;
        if (!ours.empty() && fs::is_empty(path / folder.name, none)) fs::remove(path / folder.name);
    }
}

} // namespace

RunDirectory::RunDirectory(const RunDirectoryOptions& options) : path_(options.path)
{
    check(options);
    if (!options.go_on) make(path_);
    lock_ = lock(path_);
    try {
        check(options); // another run may have begun and ended meanwhile
        if (!options.go_on) remove_results(path_);
    } catch (...) {
        unlock(path_, lock_);
        throw;
    }
}

std::optional<fs::path> RunDirectory::where() const
{
    if (is_at(lock_, path_ / lock_file)) return path_;
    std::error_code none;
    const fs::path now = fs::read_symlink("/proc/self/fd/" + std::to_string(lock_), none);
    if (now.filename() == lock_file && is_at(lock_, now)) return now.parent_path();
    return std::nullopt;
}

void RunDirectory::check_held() const
{
    if (is_at(lock_, path_ / lock_file)) return;
    const auto now = where();
    throw DirectoryLost("output directory " + path_.string() + ": was " +
                        (now ? "moved to " + now->string() : std::string("removed")) +
                        " while the run was writing to it");
}

void RunDirectory::remove_end() const
{
    for (const char* name : files_of_the_end) fs::remove(path_ / name);
    for (const fs::path& file : files_in(path_, {"frames", breakdown_prefixes, 6}))
        fs::remove(file);
}

RunDirectory::~RunDirectory() { unlock(where().value_or(path_), lock_); }

} // namespace starling
