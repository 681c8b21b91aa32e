#pragma once
/// Properties of the wall along x from a case file.
#include <filesystem>

#include "config/case.hpp"
#include "config/case_values.hpp"

namespace starling {

/// Sections [rest_radius] and [stiffness] into c.tube.rest_radius and c.material.stiffness; needs
/// c.scaling and what read_wall reads. A table's file is looked for in `folder`. Problems are
/// collected in `values`.
void read_along_x(CaseValues& values, Case& c, const std::filesystem::path& folder);

} // namespace starling
