#pragma once
/// Frames in formats of other programs: VTK's XML files and CSV.
#include "output/frame_file.hpp"

namespace starling {

/// The wall as VTK PolyData (.vtp): points, triangles, arrays on both, the time as `TimeValue`, and
/// the units of all as text in the field `units`. Replaces the file as a whole; throws
/// std::runtime_error where it cannot be written.
void write_vtp(const std::filesystem::path& path, const WallFrame& frame);

/// The fluid as VTK ImageData (.vti): arrays in the cells.
void write_vti(const std::filesystem::path& path, const FluidFrame& frame);

/// One row per vertex, header "name [unit]"; what belongs to elements is the mean over those around
/// the vertex.
void write_csv(const std::filesystem::path& path, const WallFrame& frame);

/// One row per cell, at its centre, x fastest.
void write_csv(const std::filesystem::path& path, const FluidFrame& frame);

} // namespace starling
