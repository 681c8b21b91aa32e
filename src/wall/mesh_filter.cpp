#include "wall/mesh_filter.hpp"

#include "core/for_each.hpp"

namespace starling {

MeshFilter::MeshFilter(const Tube& tube, Real rate)
    : tube_(&tube), rate_(rate),
      high_pass_(tube.mesh, tube.moving_begin(), tube.moving_end(), HighPass::Beyond::as_zero)
{
}

void MeshFilter::add_velocity(WallState& wall, Real dt)
{
    const Index first = high_pass_.first(), last = high_pass_.last();
    const Vec3 *x = wall.x.data(), *X = tube_->X.data();
    Across* d = high_pass_.values();
    for_range(first, last, [=](Index v) { d[v - first] = {x[v].y - X[v].y, x[v].z - X[v].z}; });
    high_pass_.apply();
    const Real rate = std::min(rate_, 1 / dt);
    Vec3* U = wall.velocity.data();
    for_range(first, last, [=](Index v) {
        U[v] -= Vec3{0, rate * d[v - first].y, rate * d[v - first].z};
    });
}

} // namespace starling
