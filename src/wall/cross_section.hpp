#pragma once
/// Cuts of the wall with planes of constant x.
#include "core/array.hpp"
#include "wall/tube.hpp"

namespace starling {

/// A point in the plane of a cross-section.
struct Point2 {
    Real y, z;
};

/// The polygon in which a plane of constant x cuts the wall. Because vertices never leave their x,
/// the plane meets only the elements between two rings, and segment m, from point m to point
/// m + 1, lies in element first_element + m.
class CrossSection {
public:
    explicit CrossSection(const Tube& tube);

    /// Cuts the wall at positions x with the plane `plane_x` (clamped to the tube's ends).
    void cut(const Array<Vec3>& x, Real plane_x);

    const std::vector<Point2>& points() const { return points_; }
    ElementIndex first_element() const { return first_element_; }
    /// Enclosed area, positive for a wall whose normals point outwards.
    Real area() const;
    /// z where the polygon crosses the line of constant y, ascending; inside lies between
    /// neighbours 0-1, 2-3, ... None if one is not finite: such a wall has no inside. Valid until
    /// the next call.
    const std::vector<Real>& crossings(Real y);

private:
    const Tube* tube_;
    std::vector<Point2> points_;
    std::vector<Real> crossings_;
    ElementIndex first_element_ = 0;
};

} // namespace starling
