#include "wall/tissue.hpp"

#include "core/for_each.hpp"
#include "wall/geometry.hpp"

namespace starling {

ElasticTissue::ElasticTissue(const Tube& tube, const TissueParameters& parameters)
    : tube_(&tube), parameters_(parameters), area_(tube.moving_end() - tube.moving_begin())
{
    Geometry undeformed(tube.mesh);
    undeformed.update(WallState(tube).x);
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v)
        for (const Corner* c = tube.mesh.corners_begin(v); c != tube.mesh.corners_end(v); ++c)
            area_[v - tube.moving_begin()] += norm(undeformed.element_area()[c->element]) / 3;
}

void ElasticTissue::add(const Array<Vec3>& x, const Array<Vec3>& U, Array<Vec3>& f) const
{
    const Index first = tube_->moving_begin();
    const Real k = parameters_.stiffness, c = parameters_.damping;
    const Real* area = area_.data();
    const Vec3 *position = x.data(), *rest = tube_->X.data(), *velocity = U.data();
    Vec3* force = f.data();
    for_range(first, tube_->moving_end(), [=](Index v) {
        force[v] -= area[v - first] * (k * (position[v] - rest[v]) + c * velocity[v]);
    });
}

Real ElasticTissue::energy(const Array<Vec3>& x) const
{
    Real sum = 0;
    for (VertexIndex v = tube_->moving_begin(); v < tube_->moving_end(); ++v) {
        const Vec3 d = x[v] - tube_->X[static_cast<std::size_t>(v)];
        sum += area_[v - tube_->moving_begin()] * dot(d, d);
    }
    return parameters_.stiffness / 2 * sum;
}

Real ElasticTissue::dissipation(const Array<Vec3>& U) const
{
    Real sum = 0;
    for (VertexIndex v = tube_->moving_begin(); v < tube_->moving_end(); ++v)
        sum += area_[v - tube_->moving_begin()] * dot(U[v], U[v]);
    return parameters_.damping * sum;
}

Tissue::Tissue(const Tube& tube, const TissueParameters& parameters)
{
    if (!parameters.none() && tube.deforms()) model_.emplace<ElasticTissue>(tube, parameters);
}

void Tissue::add(const Array<Vec3>& x, const Array<Vec3>& U, Array<Vec3>& f) const
{
    std::visit([&](const auto& model) { model.add(x, U, f); }, model_);
}

Real Tissue::energy(const Array<Vec3>& x) const
{
    return std::visit([&](const auto& model) { return model.energy(x); }, model_);
}

Real Tissue::dissipation(const Array<Vec3>& U) const
{
    return std::visit([&](const auto& model) { return model.dissipation(U); }, model_);
}

} // namespace starling
