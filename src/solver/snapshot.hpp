#pragma once
/// Snapshots made smaller: parts, layers, means.
#include "grid/field.hpp"
#include "solver/monitor_data.hpp"
#include "solver/snapshot_parameters.hpp"

namespace starling {

/// Puts NaN into the cells of which neither face along x lies inside; `inside` is at the nodes of
/// u.
void blank_outside(FluidSnapshot& s, const Field<std::uint8_t>& inside);

/// One layer, normal to direction 1 (y) or 2 (z), centred on the face nearest to the tube's axis:
/// the mean of the layers beside it.
FluidSnapshot axial_layer(const FluidSnapshot& s, int direction);

/// Means over blocks of n cells along each direction (fewer where there are fewer) over those that
/// are not NaN; incomplete blocks at the far ends are left out.
FluidSnapshot block_means(const FluidSnapshot& s, Index n);

/// What the parameters ask for.
FluidSnapshot reduced(FluidSnapshot s, const SnapshotParameters& p,
                      const Field<std::uint8_t>& inside);

/// The cells between two planes of constant x, at least one layer of them.
FluidSnapshot slab(const FluidSnapshot& s, Real x_begin, Real x_end);

/// The triangles with a vertex between two planes of constant x, their vertices numbered anew:
/// the same ones at all times, because vertices never leave their x.
WallSnapshot slab(const WallSnapshot& s, Real x_begin, Real x_end);

} // namespace starling
