#pragma once
/// Problems whose steps are timed: fluid alone, or fluid and wall.
#include <array>
#include <memory>
#include <string>

#include "core/timer.hpp"
#include "core/types.hpp"

namespace starling::bench {

/// A grid and about how many vertices its wall has; 0: fluid alone.
struct Problem {
    std::array<Index, 3> cells{};
    Index vertices = 0;

    Index cell_count() const { return cells[0] * cells[1] * cells[2]; }
};

/// "256x96x96"; throws InputError for anything but three numbers that make a grid for a tube.
std::array<Index, 3> parse_grid(const std::string& text);
/// "none", "17k" or "17000"; throws InputError.
Index parse_wall(const std::string& text);
std::string grid_text(const std::array<Index, 3>& cells);
/// "none", "17k" or "450".
std::string wall_text(Index vertices);

/// Fields, operators and work space of a problem, ready to step.
class SteppedProblem {
public:
    virtual ~SteppedProblem() = default;

    /// Throws NumericalError where the computation breaks down.
    virtual void step() = 0;
    /// Whether all that has been computed is finite.
    virtual bool sound() const = 0;
    virtual const PhaseTimer& timer() const = 0;
    virtual Index vertices() const = 0;
};

/// What building it has allocated.
struct Footprint {
    Index bytes = 0;
    double bytes_per_vertex = 0; ///< 0 for fluid alone
    double bytes_per_cell = 0;   ///< of the rest
};

struct BuiltProblem {
    std::unique_ptr<SteppedProblem> steps;
    Footprint footprint;
};

/// Builds a problem for as many threads as OpenMP may use now. Fluid alone: jets between the end
/// faces of the box, without a wall. With a wall: inflation of a tube that resists bending, coupled
/// as runs are, without their copies of the state. The bytes per vertex are what a second wall with
/// a quarter of the vertices needs less, per vertex.
BuiltProblem build(const Problem& p);

/// About how many bytes `build` needs at its peak.
double expected_bytes(const Problem& p);

} // namespace starling::bench
