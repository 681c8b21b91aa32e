#include "immersed_boundary/coupling.hpp"

#include "grid/boundary.hpp"

namespace starling {

namespace {

/// Planes of component c on which ghost nodes live: all for u, those without acting rings for v, w.
std::vector<char> ghost_planes(const Grid& g, const Tube& tube, Location c, RingRange acting)
{
    std::vector<char> active(static_cast<std::size_t>(g.nx() + 1), 1);
    if (c == Location::u) return active;
    const bool all = acting.begin == 0 && acting.end == tube.rings();
    for (Index i = 0; i <= g.nx(); ++i)
        active[static_cast<std::size_t>(i)] =
            !all && !(g.x(c, i) > tube.x_clamp_in() && g.x(c, i) < tube.x_clamp_out());
    return active;
}

GhostNodes make_ghosts(const Grid& g, const Tube& tube, Location c, RingRange acting)
{
    return GhostNodes(g, tube, c, ghost_planes(g, tube, c, acting));
}

/// How deep in the fluid the kernels' smearing ends, if the pressure force is to be completed.
Real smeared_depth(const Grid& g, CouplingScheme scheme, const KernelPair& kernels)
{
    return scheme == CouplingScheme::conserving ? kernels.reach() * g.spacing().x : 0;
}

} // namespace

Coupling::Coupling(const Grid& g, const Tube& tube, const Geometry& geometry, CouplingScheme scheme)
    : grid_(g), tube_(&tube), geometry_(&geometry), guide_(scheme),
      acting_(guide_.acting_rings(tube)), transfer_(g, tube, guide_.kernels(), acting_),
      pressure_force_(g, smeared_depth(g, scheme, guide_.kernels())),
      ghosts_{make_ghosts(g, tube, Location::u, acting_),
              make_ghosts(g, tube, Location::v, acting_),
              make_ghosts(g, tube, Location::w, acting_)}
{
}

// With f = -A on a straight tube F is the gradient of the smeared inside: its sum along y, up to
// the quadrature over the rings.
Array<Real> Coupling::inside_share()
{
    Array<Real> share = starling::inside_share(grid_);
    const auto at = [&](Index j, Index k) -> Real& { return share[j * grid_.nz() + k]; };
    if (acting_.begin > 0 || acting_.end < tube_->rings()) return share;
    const WallState rest(*tube_);
    Geometry geometry(tube_->mesh);
    geometry.update(rest.x);
    Array<Vec3> f(rest.x.size());
    for (Index v = 0; v < f.size(); ++v) f[v] = -1.0 * geometry.vertex_area()[v];
    transfer_.update(rest.x);
    ScalarField F(grid_);
    transfer_.spread(Location::v, f, F);
    for (Index k = 0; k < grid_.nz(); ++k) {
        Real sum = 0;
        for (Index j = 0; j < grid_.ny(); ++j) at(j, k) = sum += grid_.spacing().y * F(0, j, k);
    }
    const Index j = std::llround(-grid_.origin().y / grid_.spacing().y - 0.5);
    const Index k = std::llround(-grid_.origin().z / grid_.spacing().z - 0.5);
    const Real on_axis = at(j, k);
    for (Real& a : share) a /= on_axis;
    return share;
}

void Coupling::initialise(const WallState& wall, GhostStates& ghosts)
{
    const InterceptSearch search(tube_->mesh, wall.x, *geometry_);
    for (std::size_t c = 0; c < 3; ++c) ghosts_[c].initialise(wall.x, search, ghosts[c]);
    pressure_force_.initialise(ghosts[0]);
}

bool Coupling::weigh(const WallState& wall) { return transfer_.update(wall.x); }

// Those of v and w stand where nothing moves.
bool Coupling::search(const WallState& wall, GhostStates& ghosts)
{
    if (!tube_->deforms()) return true;
    return ghosts_[0].search(InterceptSearch(tube_->mesh, wall.x, *geometry_), ghosts[0]);
}

void Coupling::place_images(const GhostStates& ghosts)
{
    if (tube_->deforms()) ghosts_[0].prescribe(ghosts[0]);
}

void Coupling::spread(Array<Vec3>& f, VectorField& F)
{
    guide_.constrain_force(*tube_, *geometry_, f);
    for (Location c : components) transfer_.spread(c, f, F[c]);
}

void Coupling::complete_pressure_force(const GhostStates& ghosts, const ScalarField& P,
                                       VectorField& F)
{
    pressure_force_.complete(ghosts[0], ghosts_[0].place(), P, F[Location::u]);
}

PrescribedVelocity Coupling::no_slip(const VectorField& u)
{
    PrescribedVelocity prescribed;
    for (Location c : components) {
        const auto n = static_cast<std::size_t>(axis(c));
        ghosts_[n].evaluate(u[c]);
        prescribed[n] = ghosts_[n].prescribed();
    }
    return prescribed;
}

void Coupling::follow(const VectorField& u, WallState& wall)
{
    if (guide_.follows_normal_velocity())
        transfer_.interpolate(Location::u, u[Location::u], wall.velocity);
    transfer_.interpolate(Location::v, u[Location::v], wall.velocity);
    transfer_.interpolate(Location::w, u[Location::w], wall.velocity);
    guide_.constrain_velocity(*tube_, *geometry_, wall.velocity);
}

} // namespace starling
