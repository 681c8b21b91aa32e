#pragma once
/// Whether a computation is sound; where it is not: what broke down, where, by which term, and what
/// helps.
#include <string>
#include <vector>

#include "config/case.hpp"
#include "core/error.hpp"
#include "simulation/time_step.hpp"
#include "solver/monitor.hpp"

namespace starling {

/// Looks at the state of a simulation. Holds references to what it is made of, which must outlive
/// it. Every check throws a NumericalError.
class Soundness {
public:
    Soundness(const Case& c, const Grid& g, const Tube& tube, const State& state,
              const std::vector<TimeStepLimit>& limits);

    /// To be called after each step, at next to no cost: finite numbers, and a wall that has not
    /// moved by more than a spacing.
    void check_step() const;
    /// The speed, measured in the state, beside its limit.
    void check_flow(const SpeedCheck& speed) const;
    /// No element is folded onto its neighbour.
    void check_folds() const;
    /// Opposite walls have neither met nor passed through each other.
    void check_gaps() const;
    /// Why the ghost nodes could not follow the wall.
    [[noreturn]] void report_lost_wall() const;
    [[noreturn]] void report_not_finite(const std::string& what) const;

    /// Largest move of a vertex in the last step, in grid spacings.
    Real largest_move() const { return farthest_move().spacings; }

private:
    struct Move {
        Real spacings = 0;
        VertexIndex vertex = 0;
    };
    Move farthest_move() const;
    void check_move(const Move& most, Real longest) const;
    void check_side_of_box() const;
    bool tangled() const;
    VertexIndex narrowest_vertex(Index ring) const;
    ElementIndex folded_element() const;

    /// A place in words, in the units of the case, with its angle around the tube.
    std::string at_point(const Vec3& p) const;
    std::string at_vertex(VertexIndex v) const;
    struct Face {
        Location component = Location::u;
        Index i = 0, j = 0, k = 0;
    };
    std::string at_face(const Face& f) const;
    Vec3 position(const Face& f) const { return grid_.position(f.component, f.i, f.j, f.k); }
    /// The face where the values are largest or not finite.
    Face worst_face(const VectorField& values) const;
    /// The limit that the step comes nearest to, or exceeds most.
    std::string limiting_term() const;
    std::string shorter_step() const;
    [[noreturn]] void fail(const std::string& what_and_where, const std::string& remedy,
                           const Breakdown& breakdown) const;

    const Case& case_;
    const Grid& grid_;
    const Tube& tube_;
    const State& state_;
    const std::vector<TimeStepLimit>& limits_;
};

} // namespace starling
