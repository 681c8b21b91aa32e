#pragma once
/// Second variation of the energy of a uniform tube under pressure, per circumferential wave
/// number.
///
/// The tube has the radius R and is stretched by (1, R); its points move across the axis only, by
/// w(x) cos(n theta) outward and v(x) sin(n theta) around. Derivation: docs/theory.md.
#include "wall/materials.hpp"

namespace starling {

/// Coefficients of the quadratic form
///   w_xx w''^2 + w_x w'^2 + w w^2 + 2 wv w v + v_x v'^2 + v v^2,
/// which is twice the energy of a mode per undeformed length, over pi. The tube is stable against
/// the wave number n while the form is positive.
struct ModeStiffness {
    Real w_xx, w_x, w, wv, v_x, v;
};

/// The form at radius R > 0 of a membrane with Helfrich bending of modulus E_b (c_0 = 1), under the
/// uniform transmural pressure `pressure_at` that keeps this radius. Exact for any R; for Hooke's
/// law, which has no energy, it stands for the virtual work, which is symmetric here too.
ModeStiffness mode_stiffness(const Material& law, Real E_b, Real R, int n);

/// Transmural pressure (internal minus external) that keeps the uniform radius R without axial
/// strain: tau2(1, R)/R - (E_b/2)(1/R^3 - 1/R).
Real pressure_at(const Material& law, Real E_b, Real R);

/// Inverse of `pressure_at` on the branch through R = 1. NaN where that branch ends before the
/// pressure is reached or R would leave (0.2, 5).
Real radius_at(const Material& law, Real E_b, Real pressure);

} // namespace starling
