#pragma once
/// Whole-file writing that never leaves a half-written file behind.
#include <filesystem>
#include <span>
#include <string>

namespace starling {

/// Writes `text` to a temporary file beside `path` and renames it; throws std::runtime_error.
void replace_file(const std::filesystem::path& path, const std::string& text);

/// Writes a file as a whole in place, to the disk itself (fsync) if `sync`; throws
/// std::runtime_error with the reason, and removes what was written so far.
void write_bytes(const std::filesystem::path& path, std::span<const char> bytes, bool sync);

/// Waits until a file or the names in a folder are on the disk itself (fsync); throws
/// std::runtime_error.
void sync_to_disk(const std::filesystem::path& path);

} // namespace starling
