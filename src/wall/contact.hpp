#pragma once
/// A short-range repulsion that keeps opposite walls from passing through each other.
#include "wall/geometry.hpp"
#include "wall/lumen.hpp"

namespace starling {

/// Strength of the repulsion and the gap below which it acts.
struct ContactParameters {
    Real pressure = 0; ///< on walls that touch (rho U_c^2); 0: no repulsion
    Real range = 0;    ///< (R_0)
};

/// Where the lumen is narrower than the range, the pressure p (1 - width/range)^2 pushes the wall
/// outwards. It acts on both walls alike; walls that meet from outside do not feel it.
class Contact {
public:
    /// `tube` must outlive the object.
    Contact(const Tube& tube, const ContactParameters& parameters)
        : tube_(&tube), parameters_(parameters)
    {
    }
    /// f += repulsion on each moving vertex; `geometry` is that of x.
    void add(const Array<Vec3>& x, const Geometry& geometry, Array<Vec3>& f) const;

private:
    const Tube* tube_;
    ContactParameters parameters_;
};

} // namespace starling
