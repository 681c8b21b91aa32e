#include "wall/smoothing.hpp"

#include "core/for_each.hpp"

namespace starling {

SurfaceSmoothing::Diffusion::Diffusion(const Tube& tube)
    : range(bending_range(tube)), fit(tube.mesh, range),
      laplacian(tube.mesh, {tube.moving_begin(), tube.moving_end()}, range),
      undeformed(tube.mesh.vertex_count()), kappa(tube.mesh.vertex_count()),
      laplacian_kappa(tube.mesh.vertex_count())
{
    const WallState start(tube);
    Geometry geometry(tube.mesh);
    geometry.update(start.x);
    fit.update(start.x, geometry);
    for (VertexIndex v = range.first; v < range.last; ++v) undeformed[v] = fit.at_vertex()[v].mean;
}

void SurfaceSmoothing::Diffusion::update(const Array<Vec3>& x, const Geometry& geometry)
{
    fit.update(x, geometry);
    const Curvatures* fitted = fit.at_vertex().data();
    const Real* before = undeformed.data();
    Real* change = kappa.data();
    for_range(range.first, range.last, [=](Index v) { change[v] = fitted[v].mean - before[v]; });
    laplacian.apply(x, geometry, kappa, laplacian_kappa);
}

SurfaceSmoothing::SurfaceSmoothing(const Tube& tube, Real alpha) : tube_(&tube), alpha_(alpha)
{
    if (alpha != 0 && tube.moving_begin() != tube.moving_end()) diffusion_.emplace(tube);
}

void SurfaceSmoothing::add_velocity(const Geometry& geometry, WallState& wall)
{
    if (!diffusion_) return;
    diffusion_->update(wall.x, geometry);
    const Real* laplacian = diffusion_->laplacian_kappa.data();
    const Vec3* area = geometry.vertex_area().data();
    const Real alpha = alpha_;
    Vec3* U = wall.velocity.data();
    for_range(tube_->moving_begin(), tube_->moving_end(), [=](Index v) {
        const Vec3 a = area[v];
        // n . U = alpha Lap_s kappa with U across x
        const Real scale = alpha * laplacian[v] * norm(a) / (a.y * a.y + a.z * a.z);
        U[v] += scale * Vec3{0, a.y, a.z};
    });
}

} // namespace starling
