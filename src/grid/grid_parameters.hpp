#pragma once
/// What a case says about the Eulerian grid.
#include <optional>

#include "core/types.hpp"

namespace starling {

/// Box and resolution; lengths in units of R_0. The tube's length fixes the box along x.
struct GridParameters {
    Real width_y = 4.7; ///< box width between the no-slip walls
    Real width_z = 4.7; ///< box period
    Real spacing = 0.1; ///< wanted Delta; counts across the tube become products of 2, 3 and 5
    std::optional<std::array<Index, 3>> cells; ///< exact counts instead (nx, ny, nz)
    Real tube_offset_y = 0;                    ///< tube axis relative to the box centre
    Real tube_offset_z = 0;
};

} // namespace starling
