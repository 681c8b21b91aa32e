#pragma once
/// What a run has to say of its own results.
#include <string>
#include <vector>

#include "config/case.hpp"
#include "output/summary.hpp"

namespace starling {

/// A sentence for each thing to worry about in the results of a run; `step_factor` is what was left
/// of the automatic step.
std::vector<std::string> run_warnings(const Case& c, const Summary& s, Real step_factor);

} // namespace starling
