#include "wall/elastic_force.hpp"

#include <limits>
#include <stdexcept>
namespace starling {

namespace {

/// Second Piola-Kirchhoff stress from the principal tensions: P = J tau A^-T = A S with
/// S = sum_i (J tau_i / lambda_i^2) N_i N_i. An isotropic S has the form a I + b G, which needs no
/// eigenvectors and no case for equal stretches.
template <class Law>
struct StressFromTensions {
    Law law;
    const Real* stiffness;

    Symmetric2 operator()(ElementIndex e, const SurfaceDeformation& d) const
    {
        const auto [g1, g2] = d.squared_stretches();
        const Real lambda1 = std::sqrt(g1), lambda2 = std::sqrt(g2);
        const Tensions tau = law.tensions(lambda1, lambda2);
        const Real k = stiffness[e];
        const Real s1 = k * (tau.tau1 * lambda2 / lambda1);
        const Real s2 = k * (tau.tau2 * lambda1 / lambda2);
        const Real b = g1 > g2 ? (s1 - s2) / (g1 - g2) : 0;
        const Real a = s1 - b * g1;
        return {a + b * d.G11, b * d.G12, a + b * d.G22};
    }
};

/// Second Piola-Kirchhoff stress 2 dW/dG with dI1/dG = I and dI2/dG = adj(G).
template <class Law>
struct StressFromEnergy {
    Law law;
    const Real* stiffness;

    Symmetric2 operator()(ElementIndex e, const SurfaceDeformation& d) const
    {
        const Real I1 = d.G11 + d.G22 - 2, I2 = d.G11 * d.G22 - d.G12 * d.G12 - 1;
        const EnergyGradient W = law.energy_gradient(I1, I2);
        const Real k = 2 * stiffness[e];
        return {k * (W.dI1 + W.dI2 * d.G22), -k * W.dI2 * d.G12, k * (W.dI1 + W.dI2 * d.G11)};
    }
};

} // namespace

ElasticForce::ElasticForce(const Tube& tube, const Material& material, const AlongX& stiffness)
    : material_(material), elements_(tube), stiffness_(tube.mesh.element_count())
{
    for (ElementIndex e = 0; e < tube.mesh.element_count(); ++e) {
        Real x = 0;
        for (VertexIndex v : tube.mesh.element(e)) x += tube.X[static_cast<std::size_t>(v)].x / 3;
        stiffness_[e] = stiffness(x);
    }
}

void ElasticForce::compute(const Array<Vec3>& x, Array<Vec3>& f)
{
    std::visit(
        [&]<class Law>(const Law& law) {
            elements_.compute(x, StressFromTensions<Law>{law, stiffness_.data()});
        },
        material_);
    elements_.gather(f);
}

void ElasticForce::compute_from_energy(const Array<Vec3>& x, Array<Vec3>& f)
{
    std::visit(
        [&]<class Law>(const Law& law) {
            if constexpr (Law::has_energy)
                elements_.compute(x, StressFromEnergy<Law>{law, stiffness_.data()});
            else
                throw std::invalid_argument("this law has no strain energy");
        },
        material_);
    elements_.gather(f);
}

Real ElasticForce::energy(const Array<Vec3>& x) const
{
    return std::visit(
        [&]<class Law>(const Law& law) {
            if constexpr (Law::has_energy) {
                Real sum = 0;
                for (ElementIndex e = elements_.begin(); e < elements_.end(); ++e) {
                    const SurfaceDeformation d = elements_.deformation(x, e);
                    const Real I1 = d.G11 + d.G22 - 2, I2 = d.G11 * d.G22 - d.G12 * d.G12 - 1;
                    sum += stiffness_[e] * elements_.undeformed_area(e) * law.energy(I1, I2);
                }
                return sum;
            } else
                return std::numeric_limits<Real>::quiet_NaN();
        },
        material_);
}

std::array<Real, 2> ElasticForce::stretches(const Array<Vec3>& x, ElementIndex e) const
{
    const auto [g1, g2] = elements_.deformation(x, e).squared_stretches();
    return {std::sqrt(g1), std::sqrt(g2)};
}

} // namespace starling
