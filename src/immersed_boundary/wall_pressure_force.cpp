#include "immersed_boundary/wall_pressure_force.hpp"

#include "immersed_boundary/bracket.hpp"

namespace starling {

WallPressureForce::WallPressureForce(const Grid& g, Real depth)
    : grid_(g), depth_(depth), beyond_(g)
{
}

void WallPressureForce::complete(const GhostState& ghosts, const ScalarField& P,
                                 ScalarField& F_field)
{
    if (depth_ <= 0) return;
    const View<Real> F = F_field.view(), beyond = beyond_.view();
    const Probe s{ghosts.inside.view(), P.view(), F};
    const NearNode* nodes = ghosts.near_wall.data();
    const auto count = static_cast<Index>(ghosts.near_wall.size());
    missing_.resize(ghosts.near_wall.size());
    Real* missing = missing_.data();
    for_range(0, count, [=, this](Index m) {
        const NearNode& n = nodes[m];
        if (!s.inside(n.i, n.j, n.k)) beyond(n.i, n.j, n.k) = gradient_beyond(s, n);
    });
    for_range(0, count, [=, this](Index m) { missing[m] = missing_force(s, nodes[m]); });
    for_range(0, count, [=](Index m) { F(nodes[m].i, nodes[m].j, nodes[m].k) += missing[m]; });
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

Real WallPressureForce::missing_force(const Probe& s, const NearNode& n) const
{
    if (!s.inside(n.i, n.j, n.k) || !acts_on(n)) return 0;
    const auto beyond = beyond_.view();
    Real sum = 0, found = 0;
    const auto look_at = [&](Index i, Index j, Index k) {
        if (s.inside(i, j, k) || i < 0 || i > grid_.nx() || beyond(i, j, k) == none) return;
        sum += beyond(i, j, k);
        ++found;
    };
    look_at(n.i - 1, n.j, n.k);
    look_at(n.i + 1, n.j, n.k);
    look_at(n.i, n.j - 1, n.k);
    look_at(n.i, n.j + 1, n.k);
    look_at(n.i, n.j, n.k - 1);
    look_at(n.i, n.j, n.k + 1);
    return found > 0 ? net_gradient(s, n.i, n.j, n.k) - sum / found : 0;
}

} // namespace starling
