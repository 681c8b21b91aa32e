#pragma once
/// The process and its surroundings: signals, threads that wait politely, tools beside the program.
#include <string>
#include <vector>

namespace starling::app {

/// Makes idle threads sleep, but look for the next loop a thousand times first. A step has some
/// hundred short loops, and to wake a thread takes as long as many of them: on two quiet cores an
/// inflation of 290 000 cells ran 1.3 to 1.5 times as fast as with threads that sleep at once. Ones
/// that spin for long are several times slower than a single thread when another job shares the
/// machine (there, with one busy process beside: 9.9 million cell-steps/s asleep at once, 8.8 after
/// a thousand looks, 4.7 after ten thousand, 10.5 with one thread). The OpenMP library reads
/// OMP_WAIT_POLICY and GOMP_SPINCOUNT before main, so the program starts itself once more; what the
/// user has set is left alone.
void wait_briefly(char** argv);

/// From now on the first SIGINT or SIGTERM asks for a stop; a second one ends the process.
void catch_stop_signals();
bool stop_signal_seen();

/// Replaces this process by a Python tool of the checkout or installation. Throws
/// std::runtime_error where it cannot be found or started.
[[noreturn]] void run_python_tool(const std::string& name,
                                  const std::vector<std::string>& arguments);

} // namespace starling::app
