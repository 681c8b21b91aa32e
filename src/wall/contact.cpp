#include "wall/contact.hpp"

#include "core/for_each.hpp"

namespace starling {

void Contact::add(const Array<Vec3>& x, const Geometry& geometry, Array<Vec3>& f) const
{
    const Real pressure = parameters_.pressure, range = parameters_.range;
    if (pressure == 0) return;
    const VertexIndex n = tube_->ring_size;
    const Vec3 *position = x.data(), *area = geometry.vertex_area().data();
    Vec3* force = f.data();
    for_range(tube_->moving_begin(), tube_->moving_end(), [=](Index v) {
        const auto corner = static_cast<VertexIndex>(v % n);
        const Real overlap = 1 - lumen_width(position + (v - corner), n, corner) / range;
        if (overlap > 0) force[v] += pressure * overlap * overlap * area[v];
    });
}

} // namespace starling
