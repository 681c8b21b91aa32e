#pragma once
/// The discrete equations of the one-dimensional tube on one mesh, and Newton's method for them.
///
/// Linear elements in x with the trapezoidal rule: second order on a mesh that is a smooth map of
/// a uniform one. Pressures are in units of G_s. Derivation: docs/theory.md.
#include <vector>

#include "theory/block_tridiagonal.hpp"
#include "wall/materials.hpp"

namespace starling {

/// R and the viscous pressure P at the nodes of the deforming part; `gradient` is -dP/dx in the
/// rigid ends, g = 8 Q/(pi Re), so that -dP/dx = g (1 + 4/3 sin^2 beta)/R^4 everywhere, with
/// tan beta = R'.
struct MembraneState {
    std::vector<Real> R, P;
    Real gradient = 0;
};

/// Pressures at the two ends of the whole tube and outside it.
struct MembraneLoad {
    Real P_inlet = 0, P_outlet = 0, P_external = 0;
    std::vector<Real> more = {}; ///< added to the pressure inside at the nodes; empty: nothing
};

/// A membrane tube of modulus G_s = 1, clamped at R = 1 at both ends of its mesh.
class ClampedMembrane {
public:
    /// `x` increases from clamp to clamp; `law` has G_s = 1; `inertia` times
    /// 1 - 1/R^4 and the square of the gradient is the pressure that inertia adds: to first order
    /// in the slope it is the dynamic pressure (Q/pi)^2 over that square, (Re/8)^2 in units of G_s;
    /// `support` is the stiffness of the tissue around per undeformed area, in G_s/R_0^2.
    /// `stiffness` is a factor on the law's tensions along x.
    ClampedMembrane(std::vector<Real> x, Real rigid_inlet, Real rigid_outlet, Material law,
                    Real inertia, Real support, const AlongX& stiffness = {});

    MembraneState undeformed() const;

    /// Newton's method from `state`; true if it converged to round-off. On false, `state` is
    /// spoilt.
    bool solve(const MembraneLoad& load, MembraneState& state) const;

    const std::vector<Real>& x() const { return x_; }

    /// Pressure on the axis at the nodes: P with what slope and inertia add to it. At the clamps,
    /// where the slope jumps, that of the rigid side.
    std::vector<Real> axis_pressure(const MembraneState& state) const;

private:
    struct System;

    System assemble(const MembraneLoad& load, const MembraneState& state) const;
    template <class Law>
    void add_ring_balance(const Law& law, const MembraneLoad& load, const MembraneState& state,
                          System& system) const;
    void add_pressure_drop(const MembraneLoad& load, const MembraneState& state,
                           System& system) const;
    Real newton_step(const MembraneLoad& load, MembraneState& state) const;

    std::vector<Real> x_;
    Real rigid_inlet_, rigid_outlet_;
    Material law_;
    Real inertia_, support_;
    std::vector<Real> stiffness_; ///< in the middle of each element
};

} // namespace starling
