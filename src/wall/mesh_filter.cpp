#include "wall/mesh_filter.hpp"

#include "core/for_each.hpp"

namespace starling {

MeshFilter::MeshFilter(const Tube& tube, Real rate)
    : tube_(&tube), rate_(rate),
      high_pass_(tube.mesh, tube.moving_begin(), tube.moving_end(), HighPass::Beyond::as_zero),
      back_((tube.moving_end() - tube.moving_begin()) / tube.ring_size)
{
}

// c of formula (J') in docs/numerics.md. In waves around the ring, area and displacement go
// together; what the means over the ring move is no fold and is left alone.
void MeshFilter::find_volume_back(const Geometry& geometry)
{
    const Vec3* A = geometry.vertex_area().data() + high_pass_.first();
    const Vec3* X = tube_->X.data() + high_pass_.first();
    const Across* waves = high_pass_.values();
    const Index size = tube_->ring_size;
    const Real* radius = tube_->ring_radius.data() + tube_->moving_rings().begin;
    Real* back = back_.data();
    for_planes(0, back_.size(), [=](Index ring) {
        Real volume = 0, squares = 0, area_outward = 0, waves_outward = 0;
        for (Index n = ring * size; n < (ring + 1) * size; ++n) {
            volume += A[n].y * waves[n].y + A[n].z * waves[n].z;
            squares += A[n].y * A[n].y + A[n].z * A[n].z;
            area_outward += A[n].y * X[n].y + A[n].z * X[n].z;
            waves_outward += waves[n].y * X[n].y + waves[n].z * X[n].z;
        }
        const Real outward = static_cast<Real>(size) * radius[ring] * radius[ring];
        back[ring] = (volume - area_outward * waves_outward / outward) / squares;
    });
}

void MeshFilter::add_velocity(const Geometry& geometry, WallState& wall, Real dt)
{
    const Index first = high_pass_.first(), last = high_pass_.last();
    const Vec3 *x = wall.x.data(), *X = tube_->X.data(), *A = geometry.vertex_area().data();
    Across* d = high_pass_.values();
    for_range(first, last, [=](Index v) { d[v - first] = {x[v].y - X[v].y, x[v].z - X[v].z}; });
    high_pass_.apply();
    find_volume_back(geometry);
    const Real rate = std::min(rate_, 1 / dt);
    const Real* c = back_.data();
    const Index size = tube_->ring_size;
    Vec3* U = wall.velocity.data();
    for_range(first, last, [=](Index v) {
        const Across& waves = d[v - first];
        const Real back = c[(v - first) / size];
        U[v] -= rate * Vec3{0, waves.y - back * A[v].y, waves.z - back * A[v].z};
    });
}

} // namespace starling
