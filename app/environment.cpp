#include "environment.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <strings.h>
#include <unistd.h>

namespace starling::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* own_program = "/proc/self/exe";
constexpr const char* python = "/usr/bin/python3"; ///< the one that Debian's packages serve

volatile std::sig_atomic_t stop_seen = 0;

void take_note(int /*signal*/) { stop_seen = 1; }

fs::path find_tool(const std::string& name)
{
    std::error_code error;
    const fs::path here = fs::read_symlink(own_program, error).parent_path();
    for (const fs::path& directory :
         {here / "../share/starling", fs::path(STARLING_SOURCE_DIR) / "tools",
          here / "../../tools"})
        if (fs::exists(directory / name)) return fs::weakly_canonical(directory / name);
    throw std::runtime_error("cannot find " + name + " beside the program or in " +
                             STARLING_SOURCE_DIR + "/tools");
}

} // namespace

void wait_briefly(char** argv)
{
    const char* policy = std::getenv("OMP_WAIT_POLICY");
    if (policy != nullptr && strcasecmp(policy, "passive") != 0) return;
    if (policy != nullptr && std::getenv("GOMP_SPINCOUNT") != nullptr) return;
    setenv("OMP_WAIT_POLICY", "passive", 1);
    setenv("GOMP_SPINCOUNT", "1000", 0);
    execv(own_program, argv); // returns only where it fails; then threads spin, no more
}

void catch_stop_signals()
{
    struct sigaction action = {};
    action.sa_handler = take_note;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool stop_signal_seen() { return stop_seen != 0; }

void run_python_tool(const std::string& name, const std::vector<std::string>& arguments)
{
    std::vector<std::string> words = {python, find_tool(name).string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    execv(python, argv.data());
    throw std::runtime_error(std::string("cannot start ") + python + ": " + std::strerror(errno));
}

} // namespace starling::app
