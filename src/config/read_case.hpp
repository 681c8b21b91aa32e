#pragma once
/// From a case file (TOML, docs/case_file.md) to a Case.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "config/case.hpp"
#include "config/write_case.hpp"

namespace starling {

/// Reads a case file; `overrides` are "section.key=value" and win over the file, an empty value
/// removes the key. Throws InputError with all problems at once; reports those of an override
/// under the file name "--set".
Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The same from text; `name` stands for the file in messages.
Case read_case_text(std::string_view text, const std::string& name,
                    const std::vector<std::string>& overrides = {});

} // namespace starling
