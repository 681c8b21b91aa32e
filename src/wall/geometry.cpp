#include "wall/geometry.hpp"

#include "core/for_each.hpp"

namespace starling {

Geometry::Geometry(const WallMesh& mesh)
    : mesh_(&mesh), element_area_(mesh.element_count()), vertex_area_(mesh.vertex_count())
{
}

void Geometry::update(const Array<Vec3>& x)
{
    const WallMesh& mesh = *mesh_;
    Vec3* areas = element_area_.data();
    for_range(0, mesh.element_count(), [&mesh, &x, areas](Index e) {
        const auto& [a, b, c] = mesh.element(static_cast<ElementIndex>(e));
        areas[e] = 0.5 * cross(x[b] - x[a], x[c] - x[a]);
    });
    Vec3* at_vertex = vertex_area_.data();
    for_range(0, mesh.vertex_count(), [&mesh, areas, at_vertex](Index v) {
        Vec3 sum;
        const auto vertex = static_cast<VertexIndex>(v);
        for (const Corner* c = mesh.corners_begin(vertex); c != mesh.corners_end(vertex); ++c)
            sum += areas[c->element];
        at_vertex[v] = (1. / 3) * sum;
    });
}

// Gauss: 3 V = sum of x . area vector over elements and lids. With the origin of x moved to the
// first ring's plane its lid drops out; the last lid adds (distance) * (polygon area).
Real enclosed_volume(const Tube& tube, const Array<Vec3>& x)
{
    const Vec3 origin{tube.ring_x.front(), 0, 0};
    Real six_volume = 0;
    for (const auto& [a, b, c] : tube.mesh.elements())
        six_volume += dot(x[a] - origin, cross(x[b] - origin, x[c] - origin));
    const Real lid = ring_area(tube, x, tube.rings() - 1);
    return six_volume / 6 + lid * (tube.ring_x.back() - tube.ring_x.front()) / 3;
}

// Gauss across x: 2 V = sum of (y A_y + z A_z) over elements, with y and z at their centroids. The
// elements between two rings follow one another.
std::vector<Real> volume_up_to_rings(const Tube& tube, const Array<Vec3>& x)
{
    std::vector<Real> volume{0};
    const auto between_rings = 2 * static_cast<std::size_t>(tube.ring_size);
    Real twelve_volume = 0;
    for (std::size_t e = 0; e < tube.mesh.elements().size(); ++e) {
        const auto& [a, b, c] = tube.mesh.elements()[e];
        const Vec3 sum = x[a] + x[b] + x[c], normal = cross(x[b] - x[a], x[c] - x[a]);
        twelve_volume += sum.y * normal.y + sum.z * normal.z;
        if ((e + 1) % between_rings == 0) volume.push_back(twelve_volume / 12);
    }
    return volume;
}

Real ring_area(const Tube& tube, const Array<Vec3>& x, Index ring)
{
    const VertexIndex first = tube.first(ring), n = tube.ring_size;
    Real twice = 0;
    for (VertexIndex t = 0; t < n; ++t) {
        const Vec3 &a = x[first + t], &b = x[first + (t + 1) % n];
        twice += a.y * b.z - a.z * b.y;
    }
    return twice / 2;
}

} // namespace starling
