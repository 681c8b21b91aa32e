#pragma once
/// The pressure step: from u_hat to a divergence-free velocity.
#include "flow/fluid_state.hpp"
#include "flow/poisson.hpp"

namespace starling {

/// Eqs. (37)-(39) in incremental form with the rotational term:
/// Lap phi = div u_hat / dt, u = u_hat - dt grad phi, P += phi - theta (dt/Re) Lap phi.
/// (The rotational term is not in the paper: without it the wall of ghost nodes leaks for hundreds
/// of steps at low Re.)
///
/// The pressures of the drive act at the time level at which diffusion acts, t + theta dt: second
/// order in time with theta = 1/2. Where they change, phi takes the change on the end faces.
class Projection {
public:
    Projection(const Grid& g, const FluidParameters& p, const DriveParameters& drive);

    /// Takes shares other than `inside_share`: of the pressures inside and outside, 1 - share.
    void set_inside_share(Array<Real> share) { inside_share_ = std::move(share); }

    /// Makes s.u divergence-free and updates s.P; both with valid halos. The step begins at t.
    void project(FluidState& s, Real t, Real dt);

    /// Sets s.P to the harmonic field of the end pressures at t = 0: the pressure of fluid at rest
    /// just after the drive is switched on.
    void initialise_pressure(FluidState& s);

private:
    /// Sets s.end_pressure and end_change_; returns whether anything changes.
    bool change_end_pressure(FluidState& s, const EndPressures& to);
    /// The share of the change in -dt grad phi, which the solver, with phi = 0 there, leaves out.
    void push_on_end_faces(ScalarField& u, Real dt) const;
    /// Turns a halo that is odd about the end faces into one that takes `values` there.
    void add_end_values(ScalarField& field, const std::array<Array<Real>, 2>& values) const;

    Grid grid_;
    Real theta_, viscous_; ///< theta, theta/Re
    DriveParameters drive_;
    Poisson poisson_;
    ScalarField phi_;
    Array<Real> inside_share_;
    std::array<Array<Real>, 2> end_change_; ///< of the pressure on the end faces in this step
};

} // namespace starling
