#pragma once
/// One run in memory: Case -> grid, wall and operators; steps; what can be asked of it. No files.
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "config/case.hpp"
#include "simulation/time_step.hpp"
#include "solver/monitor_data.hpp"

namespace starling {

struct State;
struct WallModel;

/// What the wall of a case resists with, on a grid of spacing `delta`.
WallModel wall_model(const Case& c, Real delta);

/// Seconds spent in one phase of the step.
struct PhaseTime {
    std::string name;
    double seconds;
};

/// A part of the wall and the fluid.
struct Neighbourhood {
    WallSnapshot wall; ///< positions, velocity, elastic force
    FluidSnapshot fluid;
};

class Simulation {
public:
    /// Builds everything; throws InputError where the geometry does not fit the grid.
    explicit Simulation(const Case& c);
    ~Simulation();
    Simulation(Simulation&&) noexcept;

    /// One time step of at most dt(), shortened so that equal steps end exactly at the time
    /// `until` (> time()). Throws NumericalError on a non-finite value or a wall that is lost;
    /// std::logic_error with more threads than the simulation was built with.
    void step(Real until = std::numeric_limits<Real>::infinity());

    /// Returns to the last state that was found sound, at most about 50 steps back, and to its
    /// limits of the step.
    void back_to_good();
    /// Multiplies the automatic step by `factor` from now on, beside the safety of the case.
    void set_step_factor(Real factor);

    /// Chooses the step anew, for the case as it is now: of a state that another case has led to.
    void choose_step();

    /// What a checkpoint holds: the present state and the last one found sound.
    const State& state() const;
    const State& good_state() const;
    /// Lets `read` and `read_good` fill the two from a checkpoint of the same case; sets the step
    /// factor.
    void restore(const std::function<void(State&)>& read,
                 const std::function<void(State&)>& read_good, Real step_factor);

    Real time() const;
    Index steps() const;
    Index good_step() const;               ///< steps of the last state found sound
    Real dt() const;                       ///< longest step the next call of step() takes
    const TimeStepLimit& limiting() const; ///< the bound that sets dt
    Real spacing() const;                  ///< of the grid, the mean over the directions
    Index cells() const;
    Index vertices() const;
    VertexIndex ring_size() const; ///< vertices of a ring
    Index elements() const;

    /// Monitored numbers of the present state; also drives the steadiness test.
    Sample sample();
    std::vector<ProfileRow> profile() const;
    std::vector<SectionPoint> sections() const;
    /// Of the fluid inside on the wall, in its plane, at each vertex (rho U_c^2).
    std::vector<Vec3> wall_shear_stress() const;
    WallSnapshot wall_snapshot() const;
    FluidSnapshot fluid_snapshot() const; ///< the part that the case wants
    /// Wall and fluid about a place where the computation broke down, which need not be finite:
    /// a slab of the tube.
    Neighbourhood neighbourhood(const Vec3& place) const;
    std::vector<PhaseTime> phase_times() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace starling
