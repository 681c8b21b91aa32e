#include "output/run_directory.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/error.hpp"

namespace starling {

namespace fs = std::filesystem;

namespace {

/// Everything that a run and `starling plot` write.
constexpr const char* result_files[] = {
    "case.toml",    "summary.json", "series.csv",     "profile.csv",
    "theory.csv",   "wall.h5",      "wall.xdmf",      "wall.xdmf.new",
    "fluid.h5",     "fluid.xdmf",   "fluid.xdmf.new", "summary.json.new",
    "profiles.png", "history.png",  "tube.png",       "flow.png"};
constexpr const char* lock_file = ".starling.lock";

[[noreturn]] void refuse(const fs::path& path, const std::string& reason)
{
    throw InputError("output directory " + path.string() + ": " + reason);
}

const char* first_result(const fs::path& path)
{
    for (const char* name : result_files)
        if (fs::exists(path / name)) return name;
    return nullptr;
}

void make(const fs::path& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    if (error) refuse(path, "cannot be created: " + error.message());
}

/// Returns the descriptor of the locked file. The kernel drops the lock when the process ends,
/// however it ends.
int lock(const fs::path& path)
{
    const int file = open((path / lock_file).c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
    if (file < 0) refuse(path, std::string("cannot be written to: ") + std::strerror(errno));
    if (flock(file, LOCK_EX | LOCK_NB) == 0) return file;
    close(file);
    refuse(path, "another run is writing to it; choose another directory or wait for that run");
}

} // namespace

void RunDirectory::check(const fs::path& path, bool force)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (error && status.type() != fs::file_type::not_found) refuse(path, error.message());
    if (!fs::exists(status)) return;
    if (!fs::is_directory(status)) refuse(path, "is a file, not a directory");
    if (access(path.c_str(), W_OK | X_OK) != 0)
        refuse(path, std::string("cannot be written to: ") + std::strerror(errno));
    if (const char* name = force ? nullptr : first_result(path))
        refuse(path, std::string("holds results of an earlier run (") + name +
                         "); choose another directory, or --force to replace them");
}

RunDirectory::RunDirectory(fs::path path, bool force) : path_(std::move(path))
{
    check(path_, force);
    make(path_);
    lock_ = lock(path_);
    for (const char* name : result_files) fs::remove(path_ / name);
}

RunDirectory::~RunDirectory()
{
    unlink((path_ / lock_file).c_str());
    close(lock_);
}

} // namespace starling
