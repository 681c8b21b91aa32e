#pragma once
/// The buckled inextensible ring under uniform pressure: tube law of a long tube, from the circle
/// until opposite walls meet. Derivation: docs/theory.md.
#include <vector>

#include "core/types.hpp"

namespace starling {

/// An equilibrium with n lobes. Lengths in R_0 (perimeter 2 pi), arc length from the tip of a lobe.
struct ElasticRing {
    int lobes = 2;
    Real pressure = 3;   ///< external minus internal, in E_b/R_0^3
    Real area_ratio = 1; ///< A/(pi R_0^2)
    Real tip_curvature = 1;
    Real waist_curvature = 1;
    Real tip_distance = 1;   ///< of the lobes' tips from the centre
    Real waist_distance = 1; ///< of the waists from the centre
    Real gap = 2;        ///< across the narrowest place of a lobe, 0 at contact; n = 2: the waist
    Real tension = -2.5; ///< the constant c of kappa'' + kappa^3/2 - c kappa = pressure
};

/// A point of the outline; the first lobe points along y.
struct OutlinePoint {
    Real y, z;
};

/// The equilibria with n >= 2 lobes by falling area, `count` >= 2 of them: from the circle at its
/// buckling pressure n^2 - 1 to the first contact of opposite walls. Throws NumericalError if the
/// branch cannot be followed.
std::vector<ElasticRing> tube_law(int lobes, int count = 41);

/// Where opposite walls first meet in a point: for n = 2 at the centre, at the pressure 5.247; for
/// n >= 3 the two sides of a lobe, nearer to the centre than the tip.
ElasticRing ring_at_contact(int lobes);

/// The equilibria of these areas, A/A_0 between contact and 1. Throws as `tube_law`.
std::vector<ElasticRing> rings_at_areas(int lobes, const std::vector<Real>& area_ratios);

/// The equilibrium of one area.
inline ElasticRing ring_at_area(int lobes, Real area_ratio)
{
    return rings_at_areas(lobes, {area_ratio}).front();
}

/// The whole outline, closed, at `count` equal distances along it.
std::vector<OutlinePoint> outline(const ElasticRing& ring, int count);

} // namespace starling
