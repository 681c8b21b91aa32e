#pragma once
/// Linear buckling of the tube under external pressure: the ring, and the paper's tube (membrane
/// whose points keep their x, Helfrich bending) between two rigid ends. Derivation: docs/theory.md.
#include <vector>

#include "wall/materials.hpp"

namespace starling {

/// Pressure difference (external minus internal) at which a ring of radius R buckles into n >= 2
/// lobes: (n^2 - 1) E_b/R^3.
Real ring_buckling_pressure(int n, Real E_b, Real R = 1);

/// How the wall meets the rigid ends; w = v = 0 in both.
enum class TubeEnds {
    pinned, ///< free to tilt: w ~ sin(m pi x/length)
    clamped ///< w' = 0: w ~ sin(m pi x/length) sin(pi x/length)
};

/// The deforming part of a tube of radius 1.
struct BucklingTube {
    Material law;
    Real E_b = 0;
    Real length = 1;
    TubeEnds ends = TubeEnds::pinned;
};

/// Buckling pressure (external minus internal, uniform) into n lobes and one half-wave along the
/// pinned tube, linearised about the undeformed wall:
///   [E_b (n^2 - 1 + q^2)^2 + H G_s q^2/(G_s q^2 + H n^2)]/(n^2 - 1),  q = pi/length,
/// H = d tau2/d lambda2. Leaves out the prestress: too high by some nu_s q^2/(n^2 - 1).
Real buckling_pressure_undeformed(const BucklingTube& tube, int n);

/// Transmural pressures (internal minus external) at the two ends of the deforming part; linear in
/// between.
struct TransmuralPressure {
    Real inlet = 0, outlet = 0;
};

/// The factor by which `load` must be multiplied to buckle the tube into n lobes, linearised about
/// the wall compressed by that load (ring by ring; its slopes are neglected). Galerkin's method
/// with `terms` functions along x for each displacement. NaN if nothing buckles before a ring of
/// the compressed tube leaves 0.2 < R < 5 or finds no equilibrium.
Real buckling_factor(const BucklingTube& tube, int n, const TransmuralPressure& load,
                     int terms = 16);

/// Buckling pressure (external minus internal) under uniform pressure; NaN as above.
Real buckling_pressure(const BucklingTube& tube, int n, int terms = 16);

} // namespace starling
