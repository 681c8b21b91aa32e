#pragma once
/// The pressure step: from u_hat to a divergence-free velocity.
#include "flow/fluid_state.hpp"
#include "flow/poisson.hpp"

namespace starling {

/// Eqs. (37)-(39) in incremental form with the rotational term:
/// Lap phi = div u_hat / dt, u = u_hat - dt grad phi, P += phi - theta (dt/Re) Lap phi.
/// (The rotational term is not in the paper: without it the wall of ghost nodes leaks for hundreds
/// of steps at low Re.)
class Projection {
public:
    Projection(const Grid& g, const FluidParameters& p, const DriveParameters& drive);

    /// Takes shares other than `inside_share`: of the pressures inside and outside, 1 - share.
    void set_inside_share(Array<Real> share) { inside_share_ = std::move(share); }

    /// Makes s.u divergence-free and updates s.P; both with valid halos.
    void project(FluidState& s, Real dt);

    /// Sets s.P to the harmonic field of the end pressures: the pressure of fluid at rest just
    /// after the drive is switched on.
    void initialise_pressure(FluidState& s);

private:
    void fill_pressure_halo(ScalarField& P) const;

    Grid grid_;
    Real viscous_; ///< theta/Re
    DriveParameters drive_;
    Poisson poisson_;
    ScalarField phi_;
    Array<Real> inside_share_;
};

} // namespace starling
