#pragma once
/// When a run counts as steady.
#include <deque>

#include "config/case.hpp"
#include "solver/monitor_data.hpp"

namespace starling {

/// Time in which a deviation from the steady state falls by a factor e. Rigid tube: Re/j_0^2, the
/// slowest mode of start-up flow (j_0 = 2.405). Compliant tube: that or, if it is longer, the decay
/// of the slowest wave along the tube; for Hooke's law with nu_s = 1/2 and little inertia that is
/// (4/pi^2) eps L^2.
Real relaxation_time(const Case& c);

/// Time over which the criterion looks back. Compliant tube: a quarter of the relaxation time, or
/// half a period of the slowest wave where it oscillates; rigid tube: Re.
Real steady_window(const Case& c);

/// Watches samples over a sliding window of time. Steady means, with tolerance tol:
/// |dV/dt| <= tol Q, and over the window Q_mid and the balance Q_in - Q_out - dV/dt varied by at
/// most tol Q, and R_max by at most tol max(|R_max - 1|, 0.01). A slow wall alone is not enough:
/// the flow balance settles later.
class SteadyCriterion {
public:
    SteadyCriterion(Real tolerance, Real window) : tolerance_(tolerance), window_(window) {}

    void add(const Sample& sample);
    /// The worst of the terms over its bound: steady at 1 or less; infinite until the samples span
    /// the window.
    Real measure() const;
    bool met() const { return measure() <= 1; }

    /// What it looks back on, for a checkpoint; a new criterion to which these are added is this
    /// one.
    const std::deque<Sample>& samples() const { return samples_; }

private:
    Real tolerance_, window_;
    std::deque<Sample> samples_; ///< those within the window and the last one before it
};

} // namespace starling
