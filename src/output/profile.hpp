#pragma once
/// profile.csv: the tube along x at the end of a run.
#include <vector>

#include "output/table.hpp"
#include "solver/monitor_data.hpp"

namespace starling {

/// The columns of profile.csv in their order.
std::span<const Column<ProfileRow>> profile_columns();

/// Writes the whole of profile.csv; throws std::runtime_error where that fails.
void write_profile(const std::filesystem::path& path, const std::vector<ProfileRow>& rows,
                   const Scaling& scaling);

} // namespace starling
