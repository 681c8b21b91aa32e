#pragma once
/// A plane of the flow through the tube's axis.
#include <array>
#include <vector>

#include "report/rings.hpp"

namespace starling::report {

/// Cell-centred values on a plane of constant y or z, x fastest.
struct FlowPlane {
    int normal = 2;                     ///< 1: y, 2: z
    std::array<std::size_t, 2> cells{}; ///< along x, and along z or y
    Vec3 origin, spacing;               ///< low corner, on the plane; as in the frame
    std::vector<Real> axial_velocity, speed, pressure;
    std::string unit_of_velocity, unit_of_pressure;
};

/// The plane on the faces nearest to the axis, as means of the layers beside it: normal to z, or to
/// y where the frame is but one layer of that. NaN outside the tube, where `wall` is given.
FlowPlane plane_through_axis(const FluidFrame& frame, const FrameArray* wall_points);

} // namespace starling::report
