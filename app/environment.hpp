#pragma once
/// The process and its surroundings: signals, threads that wait politely, tools beside the program.
#include <string>
#include <vector>

namespace starling::app {

/// Makes idle threads sleep: spinning ones are several times slower than a single thread once
/// another job shares the machine. The OpenMP library reads OMP_WAIT_POLICY before main, so the
/// program starts itself once more; a policy the user has set is left alone.
void wait_passively(char** argv);

/// From now on the first SIGINT or SIGTERM asks for a stop; a second one ends the process.
void catch_stop_signals();
bool stop_signal_seen();

/// Replaces this process by a Python tool of the checkout or installation. Throws
/// std::runtime_error where it cannot be found or started.
[[noreturn]] void run_python_tool(const std::string& name,
                                  const std::vector<std::string>& arguments);

} // namespace starling::app
