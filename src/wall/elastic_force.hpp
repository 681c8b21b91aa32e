#pragma once
/// In-plane elastic forces of the wall: constant-strain triangles.
#include "wall/element_forces.hpp"
#include "wall/materials.hpp"

namespace starling {

/// Forces of all elements that touch a vertex that may move, summed at the vertices.
class ElasticForce {
public:
    /// `stiffness` is a factor on the law's tensions and energy, per element at its middle.
    ElasticForce(const Tube& tube, const Material& material, const AlongX& stiffness = {});

    /// f = elastic force on each vertex (a force, not a density), from the first Piola-Kirchhoff
    /// stress, Eq. (15). Zero on vertices without an element that can deform.
    void compute(const Array<Vec3>& x, Array<Vec3>& f);

    /// The same from the strain energy, Eq. (16): an independent check. Throws
    /// std::invalid_argument for a law without energy (Hooke).
    void compute_from_energy(const Array<Vec3>& x, Array<Vec3>& f);

    /// Total strain energy; NaN for a law without energy.
    Real energy(const Array<Vec3>& x) const;

    /// Principal stretches of an element, the larger first.
    std::array<Real, 2> stretches(const Array<Vec3>& x, ElementIndex e) const;

    const Material& material() const { return material_; }
    /// The factor of an element on the tensions of the law.
    Real stiffness(ElementIndex e) const { return stiffness_[e]; }

private:
    Material material_;
    ElementForces elements_;
    Array<Real> stiffness_; ///< of each element
};

} // namespace starling
