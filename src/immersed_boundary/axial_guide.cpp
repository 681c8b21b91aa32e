#include "immersed_boundary/axial_guide.hpp"

#include "core/for_each.hpp"

namespace starling {

namespace {

/// n_x/|n_perp|^2 of the area vectors; zero on the end rings, which have mirror images beyond the
/// end faces.
class Slope {
public:
    Slope(const Tube& tube, const Geometry& geometry)
        : area_(geometry.vertex_area().data()), begin_(tube.first(1)),
          end_(tube.first(tube.rings() - 1))
    {
    }
    Real operator()(Index v) const
    {
        const Vec3 a = area_[v];
        return v < begin_ || v >= end_ ? 0 : a.x / (a.y * a.y + a.z * a.z);
    }

private:
    const Vec3* area_;
    Index begin_, end_;
};

} // namespace

KernelPair AxialGuide::kernels() const
{
    if (scheme_ == CouplingScheme::conserving) return composite_bsplines;
    return {Kernel::cosine, Kernel::cosine, 0};
}

RingRange AxialGuide::acting_rings(const Tube& tube) const
{
    if (supports_rigid_parts(scheme_) && tube.deforms()) return {0, tube.rings()};
    return tube.moving_rings();
}

void AxialGuide::constrain_force(const Tube& tube, const Geometry& geometry, Array<Vec3>& f) const
{
    const Vec3* n = geometry.vertex_area().data();
    Vec3* force = f.data();
    const Real reaction = pushes_back() ? 1 : 0;
    const RingRange acting = acting_rings(tube);
    const Slope slope(tube, geometry);
    for_range(tube.first(acting.begin), tube.first(acting.end), [=](Index v) {
        const Vec3 a = n[v];
        force[v].x = reaction * slope(v) * (force[v].y * a.y + force[v].z * a.z);
    });
}

void AxialGuide::constrain_velocity(const Tube& tube, const Geometry& geometry,
                                    Array<Vec3>& velocity) const
{
    const Vec3* n = geometry.vertex_area().data();
    Vec3* U = velocity.data();
    const Real feed_back = follows_normal_velocity() ? 1 : 0;
    const RingRange acting = acting_rings(tube);
    const Slope slope(tube, geometry);
    for_range(tube.first(acting.begin), tube.first(acting.end), [=](Index v) {
        const Vec3 a = n[v];
        const Real axial = feed_back * slope(v) * U[v].x;
        U[v] = {0, U[v].y + axial * a.y, U[v].z + axial * a.z};
    });
}

} // namespace starling
