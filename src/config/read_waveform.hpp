#pragma once
/// From the keys of a waveform to what they mean.
#include <filesystem>
#include <string>

#include "config/case_values.hpp"
#include "flow/fluid_parameters.hpp"

namespace starling {

/// Reads them from one section; nothing where the file gives none of them. A table's file is looked
/// for in `folder`. Problems are collected in `values`.
Waveform read_waveform(CaseValues& values, const std::string& section,
                       const std::filesystem::path& folder);

} // namespace starling
