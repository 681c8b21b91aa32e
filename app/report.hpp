#pragma once
/// What the commands print, as text.
#include <filesystem>
#include <string>

#include "simulation/estimate.hpp"
#include "simulation/run.hpp"

namespace starling::app {

/// The end of a run: results beside theory, time per phase, where the files are.
std::string summary_text(const Summary& summary, const Case& c,
                         const std::filesystem::path& directory);

/// `starling check`.
std::string check_text(const Case& c, const RunEstimate& estimate);

/// `starling cases`.
std::string case_list_text();

/// `starling cases NAME`; throws InputError with the nearest name where there is no such case.
std::string shipped_case_text(const std::string& name);

} // namespace starling::app
