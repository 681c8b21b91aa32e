#pragma once
/// `starling bench`.
#include "command_line.hpp"

namespace starling::app {

/// Measures, prints the table and writes the JSON; throws InputError, having measured nothing,
/// where the line asks for what cannot be done.
void bench_command(const CommandLine& line);

} // namespace starling::app
