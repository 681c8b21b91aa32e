#pragma once
/// The pressure step: from u_hat to a divergence-free velocity.
#include "flow/ends.hpp"
#include "flow/poisson.hpp"

namespace starling {

/// Eqs. (37)-(39) in incremental form with the rotational term:
/// Lap phi = div u_hat / dt, u = u_hat - dt grad phi, P += phi - theta (dt/Re) Lap phi.
/// (The rotational term is not in the paper: without it the wall of ghost nodes leaks for hundreds
/// of steps at low Re.)
///
/// The pressures of the drive act at the time level at which diffusion acts, t + theta dt: second
/// order in time with theta = 1/2. Where they change, phi takes the change on the end faces.
/// Where the pressure at an end answers to the flow, it is that with which the flow after the step
/// meets its condition.
class Projection {
public:
    Projection(const Grid& g, const FluidParameters& p, const DriveParameters& drive);

    /// Shares other than `inside_share` of the pressures inside and outside on the end faces, and
    /// what the faces count in the flow rates, see `Ends`.
    void set_ends(Array<Real> inside_share, std::array<Array<Real>, 2> flow_weights);

    /// Makes s.u divergence-free and updates s.P, both with valid halos, and the kinetic energies.
    /// The step begins at t.
    void project(FluidState& s, Real t, Real dt);

    /// Sets s.P to the harmonic field of the end pressures at t = 0: the pressure of fluid at rest
    /// just after the drive is switched on.
    void initialise_pressure(FluidState& s);

private:
    /// Solves Lap phi = 0 with phi = values on the end faces, whose halo carries twice these.
    void solve_harmonic(ScalarField& phi);
    void shape_answers();

    Grid grid_;
    Real theta_, viscous_; ///< theta, theta/Re
    Ends ends_;
    Poisson poisson_;
    ScalarField phi_;
    Array<Real> plane_sums_; ///< of u_c^2
};

} // namespace starling
