#pragma once
/// Whole-file writing that never leaves a half-written file behind.
#include <filesystem>
#include <string>

namespace starling {

/// Writes `text` to a temporary file beside `path` and renames it; throws std::runtime_error.
void replace_file(const std::filesystem::path& path, const std::string& text);

} // namespace starling
