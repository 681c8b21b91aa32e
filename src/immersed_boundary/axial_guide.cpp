#include "immersed_boundary/axial_guide.hpp"

#include "core/for_each.hpp"

namespace starling {

KernelPair AxialGuide::kernels() const
{
    if (scheme_ == CouplingScheme::conserving)
        return {Kernel::cubic_bspline, Kernel::quadratic_bspline, 1.0 / 8};
    return {Kernel::cosine, Kernel::cosine, 0};
}

void AxialGuide::constrain_force(const Tube& tube, const Geometry& geometry, Array<Vec3>& f) const
{
    const Vec3* n = geometry.vertex_area().data();
    Vec3* force = f.data();
    const Real reaction = pushes_back() ? 1 : 0;
    for_range(tube.moving_begin(), tube.moving_end(), [=](Index v) {
        const Vec3 a = n[v];
        const Real slope = reaction * a.x / (a.y * a.y + a.z * a.z);
        force[v].x = (force[v].y * a.y + force[v].z * a.z) * slope;
    });
}

void AxialGuide::constrain_velocity(const Tube& tube, const Geometry& geometry,
                                    Array<Vec3>& velocity) const
{
    const Vec3* n = geometry.vertex_area().data();
    Vec3* U = velocity.data();
    const Real feed_back = follows_normal_velocity() ? 1 : 0;
    for_range(tube.moving_begin(), tube.moving_end(), [=](Index v) {
        const Vec3 a = n[v];
        const Real axial = feed_back * U[v].x * a.x / (a.y * a.y + a.z * a.z);
        U[v] = {0, U[v].y + axial * a.y, U[v].z + axial * a.z};
    });
}

} // namespace starling
