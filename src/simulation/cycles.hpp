#pragma once
/// Follows a run from cycle to cycle of its drive.
#include "config/case.hpp"
#include "solver/cycle.hpp"

namespace starling {

/// Time at which the first cycle begins that is followed by a run at time t: at a whole number of
/// periods, once the drive's ramp is over. Infinite where the drive has no period.
Real first_cycle(const Case& c, Real t);

/// Takes samples at equal parts of each cycle and compares each cycle with the one before.
class Cycles {
public:
    /// Of a run that begins at t = 0. Nothing is followed where the drive has no period or
    /// time.cycle_samples is 0.
    explicit Cycles(const Case& c);

    /// Goes on from `memory`, or, where that is of other cycles, anew with the first one after t.
    void go_on_from(const CycleMemory& memory, Real t);

    /// Time of the next sample; infinite where there is none.
    Real next() const;
    /// Whether a sample is due at t; one due within a quarter of a step counts.
    bool due(Real t, Real dt) const;
    /// Takes note of the sample that was due, and of the wall shear stress at each vertex
    /// (rho U_c^2; may be left out). Returns whether a cycle is complete with it.
    bool add(const Sample& sample, std::span<const Vec3> shear = {});

    const CycleMemory& memory() const { return memory_; }

    /// The time in which the change should fall to the tolerance, if each cycle reduces it as the
    /// last one did; NaN where nothing can be said.
    Real time_to(Real tolerance) const;

private:
    void begin(Real t);

    const Case* case_;
    CycleMemory memory_;
};

} // namespace starling
