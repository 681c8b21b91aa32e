#pragma once
/// The subcommands.
#include "command_line.hpp"

namespace starling::app {

/// Does what the command line asks; throws the library's errors.
void execute(const CommandLine& line);

} // namespace starling::app
