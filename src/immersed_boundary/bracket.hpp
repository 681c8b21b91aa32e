#pragma once
/// Where a point lies between the nodes of a row: the start of every trilinear interpolation.
#include <algorithm>
#include <utility>

#include "core/types.hpp"

namespace starling {

/// Index of the node below coordinate s (in spacings) and the fraction towards the next; the two
/// nodes are kept within [low, high], beyond which the fraction extrapolates.
inline std::pair<Index, Real> bracket(Real s, Index low, Index high)
{
    const Index n = std::clamp<Index>(static_cast<Index>(std::floor(s)), low, high - 1);
    return {n, s - static_cast<Real>(n)};
}

} // namespace starling
