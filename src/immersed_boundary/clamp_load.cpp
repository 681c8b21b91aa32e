#include "immersed_boundary/clamp_load.hpp"

namespace starling {

ClampLoad::ClampLoad(const Tube& tube, Real reach) : tube_(&tube)
{
    const RingRange moving = tube.moving_rings();
    inlet_ = {{moving.begin, moving.begin}, {moving.begin, moving.begin}};
    outlet_ = {{moving.end, moving.end}, {moving.end, moving.end}};
    if (reach <= 0 || moving.begin == moving.end) return;
    const auto first_ring_after = [&](Real x) {
        const auto ring = std::upper_bound(tube.ring_x.begin(), tube.ring_x.end(), x);
        return static_cast<Index>(ring - tube.ring_x.begin());
    };
    const Real in = tube.x_clamp_in(), out = tube.x_clamp_out();
    inlet_.rigid.begin = first_ring_after(in - reach);
    inlet_.moving.end = std::min(first_ring_after(in + reach), moving.end);
    outlet_.rigid.end = first_ring_after(out + reach);
    outlet_.moving.begin = std::max(first_ring_after(out - reach), moving.begin);
}

void ClampLoad::apply(const Geometry& geometry, Array<Vec3>& f) const
{
    apply(inlet_, geometry, f);
    apply(outlet_, geometry, f);
}

void ClampLoad::apply(const Side& side, const Geometry& geometry, Array<Vec3>& f) const
{
    const Vec3* area = geometry.vertex_area().data();
    Real force = 0, square = 0; // along the area vectors, across x
    for (VertexIndex v = tube_->first(side.moving.begin); v < tube_->first(side.moving.end); ++v) {
        const Vec3 a = area[v];
        force -= f[v].y * a.y + f[v].z * a.z;
        square += a.y * a.y + a.z * a.z;
    }
    const Real pressure = square > 0 ? force / square : 0;
    for (VertexIndex v = tube_->first(side.rigid.begin); v < tube_->first(side.rigid.end); ++v)
        f[v] = -pressure * area[v];
}

} // namespace starling
