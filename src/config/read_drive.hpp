#pragma once
/// From the sections that say what drives the flow to what they mean.
#include <filesystem>

#include "config/case.hpp"
#include "config/case_values.hpp"

namespace starling {

/// Fills c.drive; needs the scaling, Re and the length of the tube. Files that the case names are
/// looked for in `folder`. Problems are collected in `values`.
void read_drive(CaseValues& values, Case& c, const std::filesystem::path& folder);

} // namespace starling
