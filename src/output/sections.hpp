#pragma once
/// sections.csv: the cross-sections of the tube at the end of a run.
#include <filesystem>
#include <vector>

#include "config/scaling.hpp"
#include "solver/monitor_data.hpp"

namespace starling {

/// Writes the points section by section; throws std::runtime_error where that fails.
void write_sections(const std::filesystem::path& path, const std::vector<SectionPoint>& points,
                    const Scaling& scaling);

} // namespace starling
