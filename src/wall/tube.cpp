#include "wall/tube.hpp"

namespace starling {

namespace {

/// Appends rings from the last one to x = `end`, about `spacing` apart, one exactly at the end;
/// none where the last one lies there already.
void append_rings(std::vector<Real>& ring_x, Real end, Real spacing)
{
    const Real begin = ring_x.back();
    if (end <= begin) return; // no rigid part at this end
    const Index n = std::max<Index>(1, std::llround((end - begin) / spacing));
    for (Index m = 1; m < n; ++m)
        ring_x.push_back(begin + (end - begin) * static_cast<Real>(m) / static_cast<Real>(n));
    ring_x.push_back(end);
}

/// The two triangles between position t of a ring and of the next one. Odd rings are turned by
/// half a step, so that
///     ring r+1:    c---d              c = position t of ring r+1 if r is even,
///                 / \ /                   position t+1 if r is odd
///     ring r:    a---b
void append_elements(std::vector<std::array<VertexIndex, 3>>& elements, VertexIndex ring,
                     VertexIndex t, VertexIndex n)
{
    const VertexIndex here = ring * n, next = here + n;
    const VertexIndex shift = ring % 2;
    const VertexIndex a = here + t, b = here + (t + 1) % n;
    const VertexIndex c = next + (t + shift) % n, d = next + (t + shift + 1) % n;
    elements.push_back({a, b, c});
    elements.push_back({b, d, c});
}

} // namespace

Tube make_tube(const TubeParameters& p, Real edge)
{
    const Real spacing = edge * std::sqrt(3.) / 2;
    Tube tube;
    tube.ring_x = {0};
    if (!p.rigid) {
        append_rings(tube.ring_x, p.rigid_inlet, spacing);
        tube.clamp_in = tube.rings() - 1;
        append_rings(tube.ring_x, p.length - p.rigid_outlet, spacing);
        tube.clamp_out = tube.rings() - 1;
    }
    append_rings(tube.ring_x, p.length, spacing);
    if (p.rigid) tube.clamp_in = tube.clamp_out = tube.rings() - 1;

    tube.ring_size = static_cast<VertexIndex>(2 * std::max<Index>(3, std::llround(pi / edge)));
    const VertexIndex n = tube.ring_size;
    for (Real x : tube.ring_x) tube.ring_radius.push_back(p.rest_radius(x));
    std::vector<std::array<VertexIndex, 3>> elements;
    for (VertexIndex r = 0; r < static_cast<VertexIndex>(tube.rings()); ++r)
        for (VertexIndex t = 0; t < n; ++t) {
            const Real theta = 2 * pi * (t + 0.5 * (r % 2)) / n;
            const Real radius = tube.ring_radius[static_cast<std::size_t>(r)];
            tube.X.push_back({tube.ring_x[static_cast<std::size_t>(r)], radius * std::cos(theta),
                              radius * std::sin(theta)});
            if (r + 1 < static_cast<VertexIndex>(tube.rings())) append_elements(elements, r, t, n);
        }
    tube.mesh = WallMesh(static_cast<VertexIndex>(tube.X.size()), std::move(elements));
    return tube;
}

} // namespace starling
