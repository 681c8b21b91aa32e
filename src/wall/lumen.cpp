#include "wall/lumen.hpp"

namespace starling {

namespace {

constexpr Real facing = 0.95;      ///< cosine of the angle to which opposite walls face each other
constexpr Real least_lobes = 0.01; ///< amplitude from which a section counts as lobed

/// Twice the signed area of the triangle a, b, c in the plane of the section.
Real turn(const Vec3& a, const Vec3& b, const Vec3& c)
{
    return (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y);
}

/// Where a ray first meets a side, and whether that faces it.
struct Hit {
    Real distance = no_gap;
    bool faces = false;
};

/// From a corner of a polygon along d in its plane.
struct Ray {
    Vec3 from, d;

    /// Positive on the left of the ray's line.
    Real side(const Vec3& q) const { return d.y * (q.z - from.z) - d.z * (q.y - from.y); }

    /// Whether all of `count` corners lie on one side of the line.
    bool passes(const Vec3* corner, VertexIndex count) const
    {
        const Ray ray = *this;
        Real right = 0;
#pragma omp simd reduction(+ : right)
        for (VertexIndex m = 0; m < count; ++m) right += ray.side(corner[m]) < 0 ? 1.0 : 0.0;
        return right == 0 || right == count;
    }

    /// Replaces the hit by that on the side b c if it comes first.
    void meet(const Vec3& b, const Vec3& c, Hit& nearest) const
    {
        const Real s = side(b), t = side(c);
        if ((s < 0) == (t < 0)) return;
        const Real distance = dot(b + s / (s - t) * (c - b) - from, d);
        if (distance > 0 && distance < nearest.distance)
            nearest = {distance, d.y * (c.z - b.z) - d.z * (c.y - b.y) > facing * norm(c - b)};
    }
};

} // namespace

Real lumen_width(const Vec3* p, VertexIndex n, VertexIndex a)
{
    // corners run counter-clockwise in (y, z): the inside is on the left
    const Vec3 along = p[(a + 1) % n] - p[(a + n - 1) % n];
    const Ray ray{p[a], (1 / norm(along)) * Vec3{0, -along.z, along.y}};
    const auto corner = [=](VertexIndex m) { return p + (a + m < n ? a + m : a + m - n); };
    Hit nearest;
    constexpr VertexIndex block = 16;
    for (VertexIndex m = 1; m + 1 < n; m += block) { // the sides that do not end in a
        const VertexIndex last = std::min(m + block, n - 1);
        const bool in_a_row = a + m >= n || a + last < n;
        if (in_a_row && ray.passes(corner(m), last + 1 - m)) continue;
        for (VertexIndex q = m; q < last; ++q) ray.meet(*corner(q), *corner(q + 1), nearest);
    }
    return nearest.faces ? nearest.distance : no_gap;
}

Real smallest_gap(const Tube& tube, const Array<Vec3>& x, Index ring)
{
    Real gap = no_gap;
    for (VertexIndex a = 0; a < tube.ring_size; ++a)
        gap = std::min(gap, lumen_width(&x[tube.first(ring)], tube.ring_size, a));
    return gap;
}

Real smallest_gap(const Tube& tube, const Array<Vec3>& x)
{
    Real gap = no_gap;
#pragma omp parallel for schedule(static) reduction(min : gap)
    for (Index ring = 0; ring < tube.rings(); ++ring)
        gap = std::min(gap, smallest_gap(tube, x, ring));
    return gap;
}

bool crosses_itself(const Tube& tube, const Array<Vec3>& x, Index ring)
{
    const VertexIndex n = tube.ring_size;
    const Vec3* p = &x[tube.first(ring)];
    for (VertexIndex a = 0; a + 2 < n; ++a) {
        const Vec3 &begin = p[a], &end = p[a + 1];
        // side n - 1 is a neighbour of side 0
        const VertexIndex last = a == 0 ? n - 2 : n - 1;
        bool left = turn(begin, end, p[a + 2]) > 0;
        for (VertexIndex b = a + 2; b <= last; ++b) {
            const Vec3 &c = p[b], &d = p[b + 1 < n ? b + 1 : 0];
            const bool next_left = turn(begin, end, d) > 0;
            if (left != next_left && (turn(c, d, begin) > 0) != (turn(c, d, end) > 0)) return true;
            left = next_left;
        }
    }
    return false;
}

RadiusModes radius_modes(const Tube& tube, const Array<Vec3>& x, Index ring)
{
    RadiusModes modes;
    const VertexIndex size = tube.ring_size;
    for (std::size_t n = 0; n < RadiusModes::count; ++n) {
        Real c = 0, s = 0;
        for (VertexIndex v = tube.first(ring); v < tube.first(ring + 1); ++v) {
            const Vec3& X = tube.X[static_cast<std::size_t>(v)];
            const Real theta = static_cast<Real>(n) * std::atan2(X.z, X.y);
            const Real r = std::hypot(x[v].y, x[v].z);
            c += r * std::cos(theta);
            s += r * std::sin(theta);
        }
        const auto two_n = static_cast<VertexIndex>(2 * n);
        const Real half = n == 0 || two_n == size ? 1 : 2; // the mean, or an unresolved phase
        modes.amplitude[n] = two_n > size ? 0 : half * std::hypot(c, s) / size;
    }
    return modes;
}

Index RadiusModes::lobes() const
{
    const auto most = std::max_element(amplitude.begin() + 2, amplitude.end());
    return *most < least_lobes * amplitude[0] ? 0 : most - amplitude.begin();
}

} // namespace starling
