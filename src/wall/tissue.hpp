#pragma once
/// The tissue around the vessel: springs and dampers to the rest position.
#include <variant>

#include "wall/wall_state.hpp"

namespace starling {

/// Nothing around the vessel but fluid.
struct NoTissue {
    void add(const Array<Vec3>&, const Array<Vec3>&, Array<Vec3>&) const {}
    Real energy(const Array<Vec3>&) const { return 0; }
    Real dissipation(const Array<Vec3>&) const { return 0; }
};

/// The force f = -A_0 (k (x - X) + c U) on each vertex that may move: X its undeformed position,
/// A_0 its undeformed area (a third of that of its elements).
class ElasticTissue {
public:
    /// `tube` must outlive the object.
    ElasticTissue(const Tube& tube, const TissueParameters& parameters);

    void add(const Array<Vec3>& x, const Array<Vec3>& U, Array<Vec3>& f) const;
    Real energy(const Array<Vec3>& x) const;
    Real dissipation(const Array<Vec3>& U) const;

private:
    const Tube* tube_;
    TissueParameters parameters_;
    Array<Real> area_; ///< A_0 of the vertices that may move, from the first of them on
};

/// One of the two: NoTissue where stiffness and damping are zero or the tube is rigid.
class Tissue {
public:
    /// `tube` must outlive the object.
    Tissue(const Tube& tube, const TissueParameters& parameters);

    /// f += force of the tissue on each vertex (rho U_c^2 R_0^2) at positions x and velocities U.
    void add(const Array<Vec3>& x, const Array<Vec3>& U, Array<Vec3>& f) const;
    /// Energy stored in the springs, sum of k A_0 |x - X|^2/2 (rho U_c^2 R_0^3).
    Real energy(const Array<Vec3>& x) const;
    /// Power that the dampers take, sum of c A_0 |U|^2 (rho U_c^3 R_0^2).
    Real dissipation(const Array<Vec3>& U) const;

private:
    std::variant<NoTissue, ElasticTissue> model_;
};

} // namespace starling
