#pragma once
/// What a run would be and cost, without running it (`starling check`).
#include <array>
#include <vector>

#include "simulation/simulation.hpp"

namespace starling {

/// Counts are exact for the grid and about right for the wall. Solver units.
struct RunEstimate {
    std::array<Index, 3> cells_xyz{};
    Vec3 spacing;
    Index cells = 0;
    Index vertices = 0, elements = 0;
    Index memory_bytes = 0;
    Real wave_speed = 0;               ///< at rest, with E/(1 - nu^2); NaN for a rigid tube
    std::vector<TimeStepLimit> limits; ///< the case's safety factor included
    TimeStepLimit binding;             ///< the smallest of them, or the fixed step
    Real dt = 0;
    Real relaxation_time = 0;
    Real duration = 0; ///< of the run, up to the first stop criterion
    Real steps = 0;
    Real seconds = 0;      ///< at `assumed_cell_steps_per_second`
    bool at_least = false; ///< duration, steps and seconds are lower bounds
    std::vector<std::string> warnings;
};

inline constexpr Real assumed_cell_steps_per_second = 10e6;

/// Time in which a case is expected to become steady to `tolerance`: the deviation falls as
/// exp(-t/T), T = relaxation_time(c); over a window of T/4 it changes by 0.22 exp(-t/T), which
/// reaches the tolerance at T ln(0.22/tolerance): 7.7 T for 1e-4.
Real expected_time_to_steady(const Case& c, Real tolerance);

/// Whether somewhere the pressure inside a compliant tube is lower than outside.
bool may_collapse(const Case& c);

RunEstimate estimate_run(const Case& c);

/// Throws InputError where the case needs more memory than the given number of bytes.
void check_memory(const Case& c, Index available);

} // namespace starling
