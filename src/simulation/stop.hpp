#pragma once
/// When a run ends, and why.
#include <optional>
#include <string>
#include <vector>

#include "simulation/cycles.hpp"
#include "simulation/steady.hpp"

namespace starling {

/// How far a run has come.
struct Moment {
    Index steps;
    Real t, dt;
    double wall_seconds;  ///< since the run began or was resumed
    Index first_step = 0; ///< at which it was
};

/// The stop criteria of a case; whichever is met first ends the run.
class StopCriteria {
public:
    explicit StopCriteria(const Case& c);

    /// Takes note of a sample, for the steady criterion.
    void add(const Sample& sample);
    /// Looks at the cycles, for the periodic criterion.
    void look_at(const Cycles& cycles);
    /// Samples to keep in a checkpoint.
    std::vector<Sample> memory() const;
    /// Looks at the criteria after a step.
    void check(const Moment& now);
    /// Ends the run at the user's wish.
    void interrupt();

    /// Why the run ends: "steady", "periodic", "end time", "steps", "wall clock" or "interrupted";
    /// empty as long as it goes on.
    const std::optional<std::string>& reason() const { return reason_; }
    /// The steady or the periodic criterion has been met.
    bool converged() const { return periodic_ || (steady_ && steady_->met()); }
    /// Estimate from the criteria and, for the steady and the periodic one, from the decay seen so
    /// far; NaN where nothing can be said.
    double seconds_left(const Moment& now) const;

private:
    /// Time left until the steady criterion is met if its measure goes on to fall as it did, and
    /// as is expected of the case.
    Real time_to_steady() const;

    struct Point {
        Real t, measure;
    };

    StopParameters stop_;
    std::optional<SteadyCriterion> steady_;
    Real window_, relaxation_;
    bool periodic_ = false;
    Real periodic_at_;         ///< time at which the periodic criterion may be met; NaN: unknown
    std::vector<Point> decay_; ///< finite measures of the steady criterion so far
    std::optional<std::string> reason_;
};

} // namespace starling
