#include "wall/bending_force.hpp"

#include "core/for_each.hpp"

namespace starling {

HelfrichBending::HelfrichBending(const Tube& tube, Real E_b)
    : tube_(&tube), E_b_(E_b), range_(bending_range(tube)), fit_(tube.mesh, range_),
      laplacian_(tube.mesh, {tube.moving_begin(), tube.moving_end()}, range_),
      c_0_(tube.mesh.vertex_count()), bend_(tube.mesh.vertex_count()),
      laplacian_bend_(tube.mesh.vertex_count())
{
    const WallState undeformed(tube);
    Geometry geometry(tube.mesh);
    geometry.update(undeformed.x);
    fit_.update(undeformed.x, geometry);
    for (VertexIndex v = range_.first; v < range_.last; ++v) c_0_[v] = 2 * fit_.at_vertex()[v].mean;
}

void HelfrichBending::update(const Array<Vec3>& x, const Geometry& geometry)
{
    fit_.update(x, geometry);
    const Curvatures* curvature = fit_.at_vertex().data();
    const Real* c_0 = c_0_.data();
    Real* bend = bend_.data();
    for_range(range_.first, range_.last,
              [=](Index v) { bend[v] = 2 * curvature[v].mean - c_0[v]; });
}

void HelfrichBending::add(const Array<Vec3>& x, const Geometry& geometry, Array<Vec3>& f)
{
    update(x, geometry);
    laplacian_.apply(x, geometry, bend_, laplacian_bend_);
    const Curvatures* curvature = fit_.at_vertex().data();
    const Real *c_0 = c_0_.data(), *bend = bend_.data(), *laplacian = laplacian_bend_.data();
    const Vec3* area = geometry.vertex_area().data();
    const Real E_b = E_b_;
    Vec3* force = f.data();
    for_range(tube_->moving_begin(), tube_->moving_end(), [=](Index v) {
        const auto& [kappa, kappa_g] = curvature[v];
        const Real density =
            bend[v] * (2 * kappa * kappa - 2 * kappa_g + c_0[v] * kappa) + laplacian[v];
        force[v] += E_b * density * area[v];
    });
}

Real HelfrichBending::energy(const Array<Vec3>& x, const Geometry& geometry)
{
    update(x, geometry);
    Real sum = 0;
    for (VertexIndex v = range_.first; v < range_.last; ++v) {
        Real area = 0;
        const WallMesh& mesh = tube_->mesh;
        for (const Corner* c = mesh.corners_begin(v); c != mesh.corners_end(v); ++c)
            area += norm(geometry.element_area()[c->element]) / 3;
        sum += bend_[v] * bend_[v] * area;
    }
    return E_b_ / 2 * sum;
}

Bending::Bending(const Tube& tube, Real E_b)
{
    if (E_b != 0 && tube.moving_begin() != tube.moving_end())
        model_.emplace<HelfrichBending>(tube, E_b);
}

void Bending::add(const Array<Vec3>& x, const Geometry& geometry, Array<Vec3>& f)
{
    std::visit([&](auto& model) { model.add(x, geometry, f); }, model_);
}

Real Bending::energy(const Array<Vec3>& x, const Geometry& geometry)
{
    return std::visit([&](auto& model) { return model.energy(x, geometry); }, model_);
}

} // namespace starling
