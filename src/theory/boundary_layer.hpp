#pragma once
/// Steady axisymmetric flow through a slender tube of given radius, marched along it without an
/// assumed profile: the boundary-layer equations. Derivation: docs/theory.md.
#include <vector>

#include "theory/block_tridiagonal.hpp"

namespace starling {

/// The profile w(s) of the axial velocity u = Q/(pi R^2) w, s = r^2/R^2, and the flow F within s.
class MarchedProfile {
public:
    /// Poiseuille's. `viscosity` is 4 pi/(Re Q).
    explicit MarchedProfile(Real viscosity);

    /// Goes on by h, over which the radius grows by `log_growth` = d(ln R); returns by how much
    /// -dp/dx is larger than Poiseuille's in this section, times R^4 (pi/Q)^2. NaN where the
    /// equations could not be solved. Where the flow has turned back it carries no momentum along
    /// x (FLARE).
    Real advance(Real h, Real log_growth);

    const std::vector<Real>& w() const { return w_; }
    /// Nodes in s, closest at the wall.
    const std::vector<Real>& s() const { return s_; }
    bool turns_back() const;

private:
    /// Weights of the differences from node to node on either side of a node.
    struct Weights {
        Real slope_down = 0, slope_up = 0; ///< in w_s; both 0 on the axis, where F does not change
        Real curve_down = 0, curve_up = 0; ///< in (s w_s)_s
    };
    struct System;

    Weights weights(std::size_t j) const;
    void add_momentum(std::size_t j, Real h, Real log_growth, System& system) const;
    void add_flow(System& system) const;
    Real newton_step(Real h, Real log_growth);

    Real viscosity_, excess_ = 0;
    std::vector<Real> s_, w_, F_, old_w_, old_F_;
    std::vector<Weights> weights_;
};

/// What inertia adds to the pressure at nodes x of a tube of radius R that begins with Poiseuille
/// flow, over (Q/pi)^2; to first order in the slope 1 - 1/R^4. Behind the last node the tube goes
/// on as a cylinder of the length `outlet`; the last number is for its end. Empty where the march
/// failed.
std::vector<Real> inertial_pressure(const std::vector<Real>& x, const std::vector<Real>& R,
                                    Real outlet, Real viscosity);

} // namespace starling
