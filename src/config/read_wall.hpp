#pragma once
/// The tube and its material from a case file.
#include "config/case.hpp"
#include "config/case_values.hpp"

namespace starling {

/// Sections [vessel] and [wall] into c.tube and c.material; needs c.scaling and c.fluid.reynolds.
void read_wall(CaseValues& values, Case& c);

} // namespace starling
