#pragma once
/// What the wall remembers from one step to the next; part of a checkpoint.
#include "core/array.hpp"
#include "core/for_each.hpp"
#include "wall/tube.hpp"

namespace starling {

/// Positions and velocities of the vertices.
struct WallState {
    Array<Vec3> x;            ///< position (R_0)
    Array<Vec3> velocity;     ///< wall velocity of the last step (U_c), zero in rigid parts
    Array<Vec3> support;      ///< force that holds a rigid vertex in place (rho U_c^2 R_0^2)
    Array<Vec3> support_rate; ///< change of that force that is expected (rho U_c^3 R_0)
    Array<Vec3> passing;      ///< velocity of the fluid that passed a rigid vertex last (U_c)

    explicit WallState(const Tube& tube)
        : x(static_cast<Index>(tube.X.size())), velocity(x.size()), support(x.size()),
          support_rate(x.size()), passing(x.size())
    {
        std::copy(tube.X.begin(), tube.X.end(), x.begin());
    }
    /// x += dt velocity for the vertices that may move. (29)
    void move(const Tube& tube, Real dt)
    {
        Vec3* position = x.data();
        const Vec3* U = velocity.data();
        for_range(tube.moving_begin(), tube.moving_end(),
                  [=](Index v) { position[v] += dt * U[v]; });
    }
};

} // namespace starling
