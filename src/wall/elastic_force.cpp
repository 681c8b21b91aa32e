#include "wall/elastic_force.hpp"

#include <limits>
#include <stdexcept>

#include "core/for_each.hpp"

namespace starling {

namespace {

/// Symmetric 2 x 2 tensor in the undeformed plane.
struct Symmetric2 {
    Real s11, s12, s22;
};

/// Second Piola-Kirchhoff stress from the principal tensions: P = J tau A^-T = A S with
/// S = sum_i (J tau_i / lambda_i^2) N_i N_i. An isotropic S has the form a I + b G, which needs no
/// eigenvectors and no case for equal stretches.
template <class Law>
struct StressFromTensions {
    Law law;

    Symmetric2 operator()(const SurfaceDeformation& d) const
    {
        const auto [g1, g2] = d.squared_stretches();
        const Real lambda1 = std::sqrt(g1), lambda2 = std::sqrt(g2);
        const Tensions tau = law.tensions(lambda1, lambda2);
        const Real s1 = tau.tau1 * lambda2 / lambda1, s2 = tau.tau2 * lambda1 / lambda2;
        const Real b = g1 > g2 ? (s1 - s2) / (g1 - g2) : 0;
        const Real a = s1 - b * g1;
        return {a + b * d.G11, b * d.G12, a + b * d.G22};
    }
};

/// Second Piola-Kirchhoff stress 2 dW/dG with dI1/dG = I and dI2/dG = adj(G).
template <class Law>
struct StressFromEnergy {
    Law law;

    Symmetric2 operator()(const SurfaceDeformation& d) const
    {
        const Real I1 = d.G11 + d.G22 - 2, I2 = d.G11 * d.G22 - d.G12 * d.G12 - 1;
        const EnergyGradient W = law.energy_gradient(I1, I2);
        return {2 * (W.dI1 + W.dI2 * d.G22), -2 * W.dI2 * d.G12, 2 * (W.dI1 + W.dI2 * d.G11)};
    }
};

ReferenceElement make_reference(const Vec3& edge_b, const Vec3& edge_c)
{
    // orthonormal axes in the plane: e_1 along edge_b
    const Real b = norm(edge_b);
    const Vec3 e1 = (1 / b) * edge_b;
    const Real c1 = dot(edge_c, e1), c2 = norm(edge_c - c1 * e1);
    return {1 / b, -c1 / (b * c2), 0, 1 / c2, b * c2 / 2};
}

} // namespace

ElasticForce::ElasticForce(const Tube& tube, const Material& material)
    : mesh_(&tube.mesh), material_(material),
      begin_(static_cast<ElementIndex>(2 * tube.first(tube.clamp_in))),
      end_(static_cast<ElementIndex>(2 * tube.first(tube.clamp_out))),
      corner_force_(tube.mesh.element_count())
{
    for (const auto& [a, b, c] : tube.mesh.elements()) {
        const auto X = [&](VertexIndex v) { return tube.X[static_cast<std::size_t>(v)]; };
        reference_.push_back(make_reference(X(b) - X(a), X(c) - X(a)));
    }
}

SurfaceDeformation ElasticForce::deformation(const Array<Vec3>& x, ElementIndex e) const
{
    const auto& [a, b, c] = mesh_->element(e);
    return {reference_[static_cast<std::size_t>(e)], x[b] - x[a], x[c] - x[a]};
}

template <class SecondPiolaKirchhoff>
void ElasticForce::element_forces(const Array<Vec3>& x, SecondPiolaKirchhoff stress)
{
    std::array<Vec3, 3>* force = corner_force_.data();
    for_range(begin_, end_, [this, &x, force, stress](Index n) {
        const auto e = static_cast<ElementIndex>(n);
        const SurfaceDeformation d = deformation(x, e);
        const Symmetric2 S = stress(d);
        const ReferenceElement& r = reference_[static_cast<std::size_t>(e)];
        // columns of P = A S, times the area
        const Vec3 P1 = r.area * (S.s11 * d.a1 + S.s12 * d.a2);
        const Vec3 P2 = r.area * (S.s12 * d.a1 + S.s22 * d.a2);
        // f_i = -P . grad H_i: the fluid feels -dW/dx (15)
        const Vec3 f_b = -(r.m11 * P1 + r.m12 * P2), f_c = -(r.m21 * P1 + r.m22 * P2);
        force[n] = {-(f_b + f_c), f_b, f_c};
    });
}

void ElasticForce::gather(Array<Vec3>& f) const
{
    const WallMesh& mesh = *mesh_;
    const std::array<Vec3, 3>* force = corner_force_.data();
    Vec3* at_vertex = f.data();
    for_range(0, mesh.vertex_count(), [&mesh, force, at_vertex](Index n) {
        Vec3 sum;
        const auto v = static_cast<VertexIndex>(n);
        for (const Corner* c = mesh.corners_begin(v); c != mesh.corners_end(v); ++c)
            sum += force[c->element][static_cast<std::size_t>(c->corner)]; // (17)
        at_vertex[n] = sum;
    });
}

void ElasticForce::compute(const Array<Vec3>& x, Array<Vec3>& f)
{
    std::visit([&]<class Law>(const Law& law) { element_forces(x, StressFromTensions<Law>{law}); },
               material_);
    gather(f);
}

void ElasticForce::compute_from_energy(const Array<Vec3>& x, Array<Vec3>& f)
{
    std::visit(
        [&]<class Law>(const Law& law) {
            if constexpr (Law::has_energy)
                element_forces(x, StressFromEnergy<Law>{law});
            else
                throw std::invalid_argument("this law has no strain energy");
        },
        material_);
    gather(f);
}

Real ElasticForce::energy(const Array<Vec3>& x) const
{
    return std::visit(
        [&]<class Law>(const Law& law) {
            if constexpr (Law::has_energy) {
                Real sum = 0;
                for (ElementIndex e = begin_; e < end_; ++e) {
                    const SurfaceDeformation d = deformation(x, e);
                    const Real I1 = d.G11 + d.G22 - 2, I2 = d.G11 * d.G22 - d.G12 * d.G12 - 1;
                    sum += reference_[static_cast<std::size_t>(e)].area * law.energy(I1, I2);
                }
                return sum;
            } else
                return std::numeric_limits<Real>::quiet_NaN();
        },
        material_);
}

std::array<Real, 2> ElasticForce::stretches(const Array<Vec3>& x, ElementIndex e) const
{
    const auto [g1, g2] = deformation(x, e).squared_stretches();
    return {std::sqrt(g1), std::sqrt(g2)};
}

} // namespace starling
