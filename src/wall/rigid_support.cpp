#include "wall/rigid_support.hpp"

#include "core/for_each.hpp"

namespace starling {

RigidSupport::RigidSupport(const Tube& tube, bool support, Real reynolds, Real delta)
    : reynolds_(reynolds), delta_(delta)
{
    if (!support || !tube.deforms()) return;
    using enum HighPass::Beyond;
    parts_.emplace_back(tube.mesh, 0, tube.moving_begin(), not_at_all);
    parts_.emplace_back(tube.mesh, tube.moving_end(), tube.mesh.vertex_count(), not_at_all);
}

void RigidSupport::apply(const Geometry& geometry, const WallState& wall, Real dt,
                         Array<Vec3>& f) const
{
    const Vec3 *area = geometry.vertex_area().data(), *support = wall.support.data(),
               *passing = wall.passing.data();
    Vec3* force = f.data();
    const Real inertia = delta_ / (2 * dt);
    for (const HighPass& part : parts_)
        for_range(part.first(), part.last(),
                  [=](Index v) { force[v] = support[v] - inertia * norm(area[v]) * passing[v]; });
}

void RigidSupport::hold(const Geometry& geometry, WallState& wall, Real dt)
{
    const Vec3* area = geometry.vertex_area().data();
    Vec3 *f = wall.support.data(), *rate = wall.support_rate.data(), *U = wall.velocity.data(),
         *passing = wall.passing.data();
    const Real gain = 4 / std::sqrt(reynolds_ * dt), inertia = delta_ / (2 * dt);
    const Real settling = reynolds_ / (5.78 * dt); // steps until the flow has answered
    const Real learning = gain / (gain + inertia) / (1 + settling * settling / 8) / 16;
    constexpr Real memory = 1 - 1. / 64;
    for (HighPass& part : parts_) {
        for_range(part.first(), part.last(), [=](Index v) {
            const Vec3 answer = -gain * norm(area[v]) * U[v];
            f[v] += dt * rate[v] + answer;
            rate[v] = memory * rate[v] + (learning / dt) * answer;
            passing[v] = U[v];
            U[v] = {};
        });
        take_out_waves(part, area, f);
        take_out_waves(part, area, rate);
    }
}

// The waves are those of the pressure f/|A|: vertices on the edges have less area.
void RigidSupport::take_out_waves(HighPass& part, const Vec3* area, Vec3* f)
{
    const Index first = part.first(), last = part.last();
    Across* waves = part.values();
    for_range(first, last, [=](Index v) {
        const Real inverse = 1 / norm(area[v]);
        waves[v - first] = {inverse * f[v].y, inverse * f[v].z};
    });
    part.apply();
    for_range(first, last, [=](Index v) {
        const Across& p = waves[v - first];
        f[v] -= norm(area[v]) * Vec3{0, p.y, p.z};
    });
}

} // namespace starling
