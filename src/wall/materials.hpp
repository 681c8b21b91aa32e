#pragma once
/// The four elastic laws of the wall as functors of the principal stretches, for use in hot loops.
///
/// A law is chosen once, by visiting `Material` outside the loop; inside there is no branch on it.
/// Tensions are principal Cauchy tensions (force per deformed length) in rho U_c^2 R_0; energies
/// are per undeformed area. Invariants: I1 = lambda1^2 + lambda2^2 - 2, I2 = (lambda1 lambda2)^2
/// -1.
#include <variant>

#include "core/types.hpp"
#include "wall/wall_parameters.hpp"

namespace starling {

/// Principal Cauchy tensions along the directions of lambda1 and lambda2. The number type T is
/// Real, or one that also carries derivatives (theory/dual.hpp).
template <class T>
struct BasicTensions {
    T tau1 = 0, tau2 = 0;
};
using Tensions = BasicTensions<Real>;

/// Derivatives of the strain energy per undeformed area with respect to the invariants.
struct EnergyGradient {
    Real dI1 = 0, dI2 = 0;
};

/// Hooke's law between Cauchy tension and Green strain, Eq. (13); it has no energy unless
/// nu_s = 1/3, so only the tensions are offered.
struct Hooke {
    static constexpr bool has_energy = false;
    Real G_s = 1, nu_s = 0.5;

    template <class T>
    BasicTensions<T> tensions(T lambda1, T lambda2) const
    {
        const Real k = G_s / (1 - nu_s);
        const T e1 = lambda1 * lambda1 - 1, e2 = lambda2 * lambda2 - 1;
        return {k * (e1 + nu_s * e2), k * (e2 + nu_s * e1)};
    }
};

/// Neo-Hookean membrane, Eqs. (7) and (11): volume-incompressible, strain softening.
struct NeoHookean {
    static constexpr bool has_energy = true;
    Real G_s = 1;

    template <class T>
    BasicTensions<T> tensions(T lambda1, T lambda2) const
    {
        const T J_s = lambda1 * lambda2, k = G_s / J_s, c = 1 / (J_s * J_s);
        return {k * (lambda1 * lambda1 - c), k * (lambda2 * lambda2 - c)};
    }
    /// Eq. (7) less its constant 3 G_s/2, so that the unstrained wall has no energy.
    Real energy(Real I1, Real I2) const { return G_s / 2 * (I1 - 1 + 1 / (I2 + 1)); }
    EnergyGradient energy_gradient(Real /*I1*/, Real I2) const
    {
        return {G_s / 2, -G_s / (2 * (I2 + 1) * (I2 + 1))};
    }
};

/// Mooney-Rivlin membrane, Eqs. (6) and (10); psi = 1 is the neo-Hookean law.
struct MooneyRivlin {
    static constexpr bool has_energy = true;
    Real G_s = 1, psi = 0.5;

    template <class T>
    BasicTensions<T> tensions(T lambda1, T lambda2) const
    {
        const T J_s = lambda1 * lambda2, k = G_s / J_s, c = 1 / (J_s * J_s);
        const T a1 = lambda1 * lambda1, a2 = lambda2 * lambda2;
        return {k * (a1 - c) * (psi + a2 * (1 - psi)), k * (a2 - c) * (psi + a1 * (1 - psi))};
    }
    /// Eq. (6) less its constant 3 G_s/2, so that the unstrained wall has no energy.
    Real energy(Real I1, Real I2) const
    {
        const Real c = 1 / (I2 + 1);
        return G_s / 2 * (psi * (I1 + 2 + c) + (1 - psi) * ((I1 + 2) * c + I2 + 1) - 3);
    }
    EnergyGradient energy_gradient(Real I1, Real I2) const
    {
        const Real c = 1 / (I2 + 1);
        return {G_s / 2 * (psi + (1 - psi) * c),
                G_s / 2 * (-psi * c * c + (1 - psi) * (1 - (I1 + 2) * c * c))};
    }
};

/// Law of Skalak et al., Eqs. (8) and (12): strain hardening, C G_s resists change of area.
struct Skalak {
    static constexpr bool has_energy = true;
    Real G_s = 1, C = 1;

    template <class T>
    BasicTensions<T> tensions(T lambda1, T lambda2) const
    {
        const T J_s = lambda1 * lambda2, k = G_s / J_s;
        const T a1 = lambda1 * lambda1, a2 = lambda2 * lambda2;
        const T area = C * J_s * J_s * (J_s * J_s - 1);
        return {k * (a1 * (a1 - 1) + area), k * (a2 * (a2 - 1) + area)};
    }
    Real energy(Real I1, Real I2) const
    {
        return G_s / 4 * (I1 * I1 + 2 * I1 - 2 * I2 + C * I2 * I2);
    }
    EnergyGradient energy_gradient(Real I1, Real I2) const
    {
        return {G_s / 2 * (I1 + 1), G_s / 2 * (C * I2 - 1)};
    }
};

using Material = std::variant<Hooke, NeoHookean, MooneyRivlin, Skalak>;

/// The law that `parameters` names, with G_s = 1/(Re eps), the paper's scaling (sec. 2.9).
Material make_material(const MaterialParameters& parameters, Real reynolds);

/// Surface shear modulus G_s = 1/(Re eps) in rho U_c^2 R_0, the same for every law.
inline Real shear_modulus(const MaterialParameters& parameters, Real reynolds)
{
    return 1 / (reynolds * parameters.eps);
}

/// Bending modulus E_b = B/(Re eps) in rho U_c^2 R_0^3.
inline Real bending_modulus(const MaterialParameters& parameters, Real reynolds)
{
    return parameters.bending * shear_modulus(parameters, reynolds);
}

} // namespace starling
