#pragma once
/// The small deviation from the circular tube with which a run may start.
#include "core/array.hpp"
#include "wall/tube.hpp"

namespace starling {

/// Moves the vertices between the clamps, at distance s (0 to 1) from the first to the second,
/// radially by
///   - amplitude cos(n theta) sin(pi s) for mode n, theta the angle from the y axis to the z axis;
///   - without a mode, random waves: the sum over n = 2..12 and m = 1..4 of
///     a_nm cos(n theta + phi_nm) sin(m pi s), a_nm and phi_nm drawn from the seed and scaled to
///     the root mean square `amplitude`.
/// The same shape on every mesh.
void perturb(const Tube& tube, const PerturbationParameters& p, Array<Vec3>& x);

} // namespace starling
