#include "immersed_boundary/wall_pressure_force.hpp"

#include "core/pack.hpp"
#include "immersed_boundary/bracket.hpp"

namespace starling {

WallPressureForce::WallPressureForce(const Grid& g, Real depth) : grid_(g), depth_(depth) {}

void WallPressureForce::complete(const GhostState& ghosts, View<const std::int32_t> place,
                                 const ScalarField& P, ScalarField& F_field)
{
    if (depth_ <= 0) return;
    const View<Real> F = F_field.view();
    const Probe s{ghosts.inside.view(), place, P.view(), F};
    const NearNode* nodes = ghosts.near_wall.data();
    const auto count = static_cast<Index>(ghosts.near_wall.size());
    gradient_.resize(ghosts.near_wall.size());
    Real* gradient = gradient_.data();
    for_range(0, count, [=, this](Index m) {
        const NearNode& n = nodes[m];
        if (!s.inside(n.i, n.j, n.k))
            gradient[m] = gradient_beyond(s, n);
        else
            gradient[m] = acts_on(n) ? net_gradient(s, n.i, n.j, n.k) : none;
    });
    for_range(0, count, [=, this](Index m) {
        const NearNode& n = nodes[m];
        if (!s.inside(n.i, n.j, n.k) || !acts_on(n)) return;
        const Real mean = mean_beyond(s, n);
        if (mean != none) F(n.i, n.j, n.k) += gradient[m] - mean;
    });
}

bool WallPressureForce::acts_on(const NearNode& n) const { return n.i > 0 && n.i < grid_.nx(); }

// Of the ghost and not of the node inside: from inside, a faceted wall has many nearest points.
Real WallPressureForce::gradient_beyond(const Probe& s, const NearNode& ghost) const
{
    const Vec3 h = grid_.spacing(), node = grid_.position(Location::u, ghost.i, ghost.j, ghost.k);
    const Vec3 outward = outward_from_intercept(node, ghost.intercept);
    const Real distance = norm(outward);
    if (!acts_on(ghost) || distance < 1e-9 * h.x) return none;
    const Vec3 probe = ghost.intercept.point - (depth_ / distance) * outward -
                       grid_.position(Location::u, 0, 0, 0);
    const auto [i, a] = bracket(probe.x / h.x, 0, grid_.nx());
    const auto [j, b] = bracket(probe.y / h.y, 0, grid_.ny() - 1);
    const auto [k, c] = bracket(probe.z / h.z, 0, grid_.nz() - 1);
    if (i < 1 || i + 1 >= grid_.nx()) return none;
    // the opposite wall must be as far from the probe
    const Vec3 opposite = probe - (depth_ / distance) * outward;
    if (!s.inside(std::clamp<Index>(std::lround(opposite.x / h.x), 0, grid_.nx()),
                  std::lround(opposite.y / h.y), std::lround(opposite.z / h.z)))
        return none;
    for (Index row = j; row <= j + 1; ++row) {
        prefetch_stencil(&s.P(i + 2, row, k), 2);
        prefetch_stencil(&s.F(i + 2, row, k), 2);
    }
    Real sum = 0;
    for (Index l = 0; l < 8; ++l) {
        const Index di = l / 4, dj = l / 2 % 2, dk = l % 2;
        const Real weight = (di ? a : 1 - a) * (dj ? b : 1 - b) * (dk ? c : 1 - c);
        if (weight < 1e-9) continue; // or symmetry would hang on round-off
        if (!s.inside(i + di, j + dj, k + dk)) return none;
        sum += weight * net_gradient(s, i + di, j + dj, k + dk);
    }
    return sum;
}

Real WallPressureForce::mean_beyond(const Probe& s, const NearNode& n) const
{
    Real sum = 0, found = 0;
    const auto look_at = [&](Index i, Index j, Index k) {
        if (i < 0 || i > grid_.nx() || s.inside(i, j, k)) return;
        const Real beyond = gradient_[static_cast<std::size_t>(s.place(i, j, k))];
        if (beyond == none) return;
        sum += beyond;
        ++found;
    };
    look_at(n.i - 1, n.j, n.k);
    look_at(n.i + 1, n.j, n.k);
    look_at(n.i, n.j - 1, n.k);
    look_at(n.i, n.j + 1, n.k);
    look_at(n.i, n.j, n.k - 1);
    look_at(n.i, n.j, n.k + 1);
    return found > 0 ? sum / found : none;
}

} // namespace starling
