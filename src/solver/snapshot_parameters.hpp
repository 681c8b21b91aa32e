#pragma once
/// How much of the fluid a snapshot keeps.
#include "core/types.hpp"

namespace starling {

/// Which cells: all, those inside the tube, or one layer through the tube's axis.
enum class FluidRegion { box, tube, plane_y, plane_z };

struct SnapshotParameters {
    FluidRegion region = FluidRegion::box;
    Index stride = 1; ///< edge, in cells, of the blocks of which means are kept
};

} // namespace starling
