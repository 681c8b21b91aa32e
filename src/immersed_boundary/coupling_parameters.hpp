#pragma once
/// What a case says about the coupling between fluid and wall.
#include "core/types.hpp"

namespace starling {

/// How wall forces reach the fluid and the fluid's velocity reaches the wall.
enum class CouplingScheme {
    printed,    ///< Eq. (35) as printed: cosine kernel, f_y and f_z only
    reaction,   ///< + the normal reaction of the axial guide as f_x
    conserving, ///< composite B-splines, reaction and its adjoint in the wall motion
};

/// Whether the rigid parts hold the fluid by forces, as the deforming part does, and not by ghost
/// nodes of v and w.
constexpr bool supports_rigid_parts(CouplingScheme s) { return s == CouplingScheme::conserving; }

struct CouplingParameters {
    CouplingScheme scheme = CouplingScheme::conserving;
};

} // namespace starling
