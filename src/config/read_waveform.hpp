#pragma once
/// From the sections *_waveform to what they mean.
#include <filesystem>
#include <string>

#include "config/case_values.hpp"
#include "flow/fluid_parameters.hpp"

namespace starling {

/// Reads one section; nothing where the file does not have it. A table's file is looked for in
/// `folder`. Problems are collected in `values`.
Waveform read_waveform(CaseValues& values, const std::string& section,
                       const std::filesystem::path& folder);

} // namespace starling
