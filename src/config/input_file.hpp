#pragma once
/// Files that a user writes.
#include <filesystem>
#include <string>

namespace starling {

/// The whole of a regular file of at most 1 MiB. Throws std::invalid_argument with what is wrong
/// with it: "no such file".
std::string input_text(const std::filesystem::path& file);

} // namespace starling
