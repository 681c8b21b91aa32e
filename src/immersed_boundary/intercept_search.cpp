#include "immersed_boundary/intercept_search.hpp"

namespace starling {

/// Nearest point of one element and the feature it lies on.
struct InterceptSearch::Nearest {
    enum class On { face, side, corner };
    ElementIndex element;
    Vec3 point;
    Real squared_distance;
    On on;
    int feature; ///< side or corner number
};

// Voronoi regions of the triangle a b c (side k is opposite corner k).
InterceptSearch::Nearest InterceptSearch::nearest_in(ElementIndex e, const Vec3& p) const
{
    using enum Nearest::On;
    const auto& [ia, ib, ic] = mesh_->element(e);
    const Vec3 &a = (*x_)[ia], &b = (*x_)[ib], &c = (*x_)[ic];
    const auto result = [&](const Vec3& q, Nearest::On on, int feature) {
        const Vec3 d = p - q;
        return Nearest{e, q, dot(d, d), on, feature};
    };
    const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const Real d1 = dot(ab, ap), d2 = dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return result(a, corner, 0);
    const Real d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return result(b, corner, 1);
    const Real vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return result(a + d1 / (d1 - d3) * ab, side, 2);
    const Real d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return result(c, corner, 2);
    const Real vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return result(a + d2 / (d2 - d6) * ac, side, 1);
    const Real va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6)
        return result(b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), side, 0);
    const Real inverse = 1 / (va + vb + vc);
    return result(a + vb * inverse * ab + vc * inverse * ac, face, 0);
}

Intercept InterceptSearch::walk(const Vec3& p, ElementIndex start) const
{
    Nearest here = nearest_in(start, p);
    while (here.on != Nearest::On::face) {
        Nearest best = here;
        const auto consider = [&](ElementIndex e) {
            if (e < 0) return;
            const Nearest there = nearest_in(e, p);
            if (there.squared_distance < best.squared_distance) best = there;
        };
        if (here.on == Nearest::On::side) {
            consider(mesh_->neighbour(here.element, here.feature));
        } else {
            const VertexIndex v =
                mesh_->element(here.element)[static_cast<std::size_t>(here.feature)];
            for (const Corner* c = mesh_->corners_begin(v); c != mesh_->corners_end(v); ++c)
                consider(c->element);
        }
        if (best.element == here.element) break;
        here = best;
    }
    return finish(here, p);
}

Intercept InterceptSearch::brute_force(const Vec3& p) const
{
    Nearest best = nearest_in(0, p);
    for (ElementIndex e = 1; e < mesh_->element_count(); ++e) {
        const Nearest there = nearest_in(e, p);
        if (there.squared_distance < best.squared_distance) best = there;
    }
    return finish(best, p);
}

Intercept InterceptSearch::finish(const Nearest& nearest, const Vec3& p) const
{
    return {nearest.element, nearest.point, nearest.squared_distance,
            dot(p - nearest.point, pseudo_normal(nearest)) >= 0};
}

// The sign of the distance is that of (p - BI) . N with N the face normal, the mean of the two
// normals at a side, the angle-weighted mean at a corner (Baerentzen & Aanaes 2005).
Vec3 InterceptSearch::pseudo_normal(const Nearest& nearest) const
{
    const auto unit = [this](ElementIndex e) {
        const Vec3 a = geometry_->element_area()[e];
        return (1 / norm(a)) * a;
    };
    if (nearest.on == Nearest::On::face) return geometry_->element_area()[nearest.element];
    if (nearest.on == Nearest::On::corner)
        return corner_normal(
            mesh_->element(nearest.element)[static_cast<std::size_t>(nearest.feature)]);
    const ElementIndex across = mesh_->neighbour(nearest.element, nearest.feature);
    return across < 0 ? unit(nearest.element) : unit(nearest.element) + unit(across);
}

Vec3 InterceptSearch::corner_normal(VertexIndex v) const
{
    Vec3 sum;
    for (const Corner* c = mesh_->corners_begin(v); c != mesh_->corners_end(v); ++c) {
        const auto& element = mesh_->element(c->element);
        const auto k = static_cast<std::size_t>(c->corner);
        const Vec3 side1 = (*x_)[element[(k + 1) % 3]] - (*x_)[v];
        const Vec3 side2 = (*x_)[element[(k + 2) % 3]] - (*x_)[v];
        const Vec3 area = geometry_->element_area()[c->element];
        const Real angle = std::atan2(2 * norm(area), dot(side1, side2));
        sum += (angle / norm(area)) * area;
    }
    return sum;
}

} // namespace starling
