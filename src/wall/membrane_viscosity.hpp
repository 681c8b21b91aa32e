#pragma once
/// Kelvin-Voigt viscosity in the plane of the wall.
#include <variant>

#include "wall/element_forces.hpp"

namespace starling {

/// A purely elastic wall.
struct NoMembraneViscosity {
    void add(const Array<Vec3>&, const Array<Vec3>&, Array<Vec3>&) const {}
    Real dissipation(const Array<Vec3>&, const Array<Vec3>&) const { return 0; }
};

/// The Cauchy tension 2 mu_s (D + nu_s/(1 - nu_s) tr(D) I), D the rate of strain in the deformed
/// surface: Hooke's law with rates for strains, so that mu_s/G_s is the retardation time of every
/// small strain. In the undeformed plane
///     S = J mu_s (G^-1 dG/dt G^-1 + nu_s/(1 - nu_s) tr(G^-1 dG/dt) G^-1),   J = sqrt(det G).
class ViscousMembrane {
public:
    /// mu_s in rho U_c R_0^2. `tube` must outlive the object.
    ViscousMembrane(const Tube& tube, Real mu_s, Real nu_s);

    void add(const Array<Vec3>& x, const Array<Vec3>& U, Array<Vec3>& f);
    Real dissipation(const Array<Vec3>& x, const Array<Vec3>& U) const;

private:
    ElementForces elements_;
    Real mu_s_, chi_; ///< chi = nu_s/(1 - nu_s)
};

/// One of the two: NoMembraneViscosity for mu_s = 0 or a rigid tube.
class MembraneViscosity {
public:
    /// mu_s in rho U_c R_0^2, nu_s the surface Poisson ratio of the law at small strain. `tube`
    /// must outlive the object.
    MembraneViscosity(const Tube& tube, Real mu_s, Real nu_s);

    /// f += viscous force on each vertex (rho U_c^2 R_0^2) at positions x and velocities U, which
    /// are zero in the rigid parts. None under rigid motion.
    void add(const Array<Vec3>& x, const Array<Vec3>& U, Array<Vec3>& f);
    /// What it takes, minus the power of those forces (rho U_c^3 R_0^2); at least zero.
    Real dissipation(const Array<Vec3>& x, const Array<Vec3>& U) const;

private:
    std::variant<NoMembraneViscosity, ViscousMembrane> model_;
};

} // namespace starling
