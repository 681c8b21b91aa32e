#include "wall/membrane_viscosity.hpp"

namespace starling {

namespace {

/// G^-1 times dG/dt, and det G.
struct StrainRate {
    Real m11, m12, m21, m22, det;

    StrainRate(const SurfaceDeformation& d, const SurfaceDeformation& rate)
        : det(d.G11 * d.G22 - d.G12 * d.G12)
    {
        const Real g11 = 2 * dot(d.a1, rate.a1), g22 = 2 * dot(d.a2, rate.a2);
        const Real g12 = dot(d.a1, rate.a2) + dot(rate.a1, d.a2);
        m11 = (d.G22 * g11 - d.G12 * g12) / det;
        m12 = (d.G22 * g12 - d.G12 * g22) / det;
        m21 = (d.G11 * g12 - d.G12 * g11) / det;
        m22 = (d.G11 * g22 - d.G12 * g12) / det;
    }
    Real trace() const { return m11 + m22; }
    Real trace_of_square() const { return m11 * m11 + 2 * m12 * m21 + m22 * m22; }
};

} // namespace

ViscousMembrane::ViscousMembrane(const Tube& tube, Real mu_s, Real nu_s)
    : elements_(tube), mu_s_(mu_s), chi_(nu_s / (1 - nu_s))
{
}

void ViscousMembrane::add(const Array<Vec3>& x, const Array<Vec3>& U, Array<Vec3>& f)
{
    const Real mu_s = mu_s_, chi = chi_;
    elements_.compute(x, [this, &U, mu_s, chi](ElementIndex e, const SurfaceDeformation& d) {
        const StrainRate M(d, elements_.deformation(U, e));
        const Real k = mu_s / std::sqrt(M.det), area = chi * M.trace(); // k adj(G) = J mu_s G^-1
        return Symmetric2{k * ((M.m11 + area) * d.G22 - M.m12 * d.G12),
                          k * (M.m12 * d.G11 - (M.m11 + area) * d.G12),
                          k * ((M.m22 + area) * d.G11 - M.m21 * d.G12)};
    });
    elements_.add(f);
}

// S : dG/dt/2 = J mu_s (tr M^2 + chi (tr M)^2)/2 with M = G^-1 dG/dt
Real ViscousMembrane::dissipation(const Array<Vec3>& x, const Array<Vec3>& U) const
{
    Real sum = 0;
    for (ElementIndex e = elements_.begin(); e < elements_.end(); ++e) {
        const StrainRate M(elements_.deformation(x, e), elements_.deformation(U, e));
        sum += elements_.undeformed_area(e) * std::sqrt(M.det) *
               (M.trace_of_square() + chi_ * M.trace() * M.trace());
    }
    return mu_s_ / 2 * sum;
}

MembraneViscosity::MembraneViscosity(const Tube& tube, Real mu_s, Real nu_s)
{
    if (mu_s != 0 && tube.deforms()) model_.emplace<ViscousMembrane>(tube, mu_s, nu_s);
}

void MembraneViscosity::add(const Array<Vec3>& x, const Array<Vec3>& U, Array<Vec3>& f)
{
    std::visit([&](auto& model) { model.add(x, U, f); }, model_);
}

Real MembraneViscosity::dissipation(const Array<Vec3>& x, const Array<Vec3>& U) const
{
    return std::visit([&](const auto& model) { return model.dissipation(x, U); }, model_);
}

} // namespace starling
