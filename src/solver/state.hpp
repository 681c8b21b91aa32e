#pragma once
/// Everything a computation remembers from one step to the next: exactly what a checkpoint holds.
#include "flow/fluid_state.hpp"
#include "immersed_boundary/coupling.hpp"
#include "wall/wall_state.hpp"

namespace starling {

struct State {
    FluidState fluid;
    WallState wall;
    GhostStates ghosts;
    Real t = 0;     ///< time (R_0/U_c)
    Index step = 0; ///< steps done
    Real dt = 0;    ///< step to take next

    State(const Grid& g, const Tube& tube)
        : fluid(g), wall(tube), ghosts{GhostState(g), GhostState(g), GhostState(g)}
    {
    }
};

} // namespace starling
