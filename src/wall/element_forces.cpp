#include "wall/element_forces.hpp"

namespace starling {

namespace {

ReferenceElement make_reference(const Vec3& edge_b, const Vec3& edge_c)
{
    // orthonormal axes in the plane: e_1 along edge_b
    const Real b = norm(edge_b);
    const Vec3 e1 = (1 / b) * edge_b;
    const Real c1 = dot(edge_c, e1), c2 = norm(edge_c - c1 * e1);
    return {1 / b, -c1 / (b * c2), 1 / c2, b * c2 / 2};
}

} // namespace

ElementForces::ElementForces(const Tube& tube)
    : mesh_(&tube.mesh), begin_(static_cast<ElementIndex>(2 * tube.first(tube.clamp_in))),
      end_(static_cast<ElementIndex>(2 * tube.first(tube.clamp_out))),
      corner_force_(tube.mesh.element_count())
{
    for (const auto& [a, b, c] : tube.mesh.elements()) {
        const auto X = [&](VertexIndex v) { return tube.X[static_cast<std::size_t>(v)]; };
        reference_.push_back(make_reference(X(b) - X(a), X(c) - X(a)));
    }
}

void ElementForces::gather(Array<Vec3>& f) const
{
    Vec3* at_vertex = f.data();
    for_range(0, mesh_->vertex_count(),
              [this, at_vertex](Index v) { at_vertex[v] = sum_at(static_cast<VertexIndex>(v)); });
}

void ElementForces::add(Array<Vec3>& f) const
{
    Vec3* at_vertex = f.data();
    for_range(0, mesh_->vertex_count(),
              [this, at_vertex](Index v) { at_vertex[v] += sum_at(static_cast<VertexIndex>(v)); });
}

} // namespace starling
