#pragma once
/// A complete description of one computation, in the paper's dimensionless units.
#include <optional>
#include <string>
#include <vector>

#include "config/scaling.hpp"
#include "core/types.hpp"
#include "flow/fluid_parameters.hpp"
#include "grid/grid_parameters.hpp"
#include "immersed_boundary/coupling_parameters.hpp"
#include "solver/snapshot_parameters.hpp"
#include "wall/wall_parameters.hpp"

namespace starling {

/// Time step: fixed, or automatic from the named limits.
struct TimeParameters {
    std::optional<Real> step; ///< fixed dt; empty means "auto"
    Real safety = 1;          ///< factor on the automatic step, in (0, 2]
    Index cycle_samples = 50; ///< of a cycle of the drive; 0: cycles are not followed
};

/// When to stop; whichever comes first. At least one is set.
struct StopParameters {
    std::optional<Real> end_time;
    std::optional<Index> steps;
    std::optional<Real> steady_tolerance;   ///< relative change that counts as steady
    std::optional<Real> periodic_tolerance; ///< change from cycle to cycle that counts as none
    std::optional<Real> wall_clock;         ///< seconds
};

/// What is written and how often.
struct OutputParameters {
    Index sample_every = 10;         ///< steps between rows of series.csv
    std::optional<Real> wall_every;  ///< time between wall frames; empty: first and last only
    std::optional<Real> fluid_every; ///< time between fluid frames; empty: last only
    bool wall = true;
    bool fluid = true;
    bool double_precision = false; ///< 64-bit fields instead of 32-bit
    SnapshotParameters fluid_part; ///< what fluid frames keep
};

/// Checkpoints to go on from (docs/checkpoints.md).
struct CheckpointParameters {
    Real every = 600;           ///< seconds of real time between two
    std::optional<Index> steps; ///< steps between two
    Index keep = 3;             ///< how many of the last are kept; 0: none is written
};

/// Everything a run needs. `scaling` converts results to the units the user wrote.
struct Case {
    std::string title;
    GridParameters grid;
    FluidParameters fluid;
    DriveParameters drive;
    TubeParameters tube;
    MaterialParameters material;
    PerturbationParameters perturbation;
    CouplingParameters coupling;
    TimeParameters time;
    StopParameters stop;
    OutputParameters output;
    CheckpointParameters checkpoint;
    Scaling scaling;

    /// Baseline pressure drop 4 L*/Re that drives U_c* = 1 through the undeformed tube (sec. 2.9).
    Real baseline_pressure_drop() const { return 4 * tube.length / fluid.reynolds; }
    /// Delta P / Delta P_0.
    Real pressure_ratio() const
    {
        return (drive.pressure_inlet - drive.pressure_outlet) / baseline_pressure_drop();
    }
};

} // namespace starling
