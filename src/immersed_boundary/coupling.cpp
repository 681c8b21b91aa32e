#include "immersed_boundary/coupling.hpp"

namespace starling {

namespace {

/// Planes of component c on which ghost nodes live: all for u, those in the rigid parts for v, w.
std::vector<char> ghost_planes(const Grid& g, const Tube& tube, Location c)
{
    std::vector<char> active(static_cast<std::size_t>(g.nx() + 1), 1);
    if (c == Location::u) return active;
    for (Index i = 0; i <= g.nx(); ++i)
        active[static_cast<std::size_t>(i)] =
            !(g.x(c, i) > tube.x_clamp_in() && g.x(c, i) < tube.x_clamp_out());
    return active;
}

GhostNodes make_ghosts(const Grid& g, const Tube& tube, Location c)
{
    return GhostNodes(g, tube, c, ghost_planes(g, tube, c));
}

/// Reach of the guide's kernels along x, if the load goes on beyond the clamps.
Real load_reach(const Grid& g, const AxialGuide& guide)
{
    return guide.completes_the_load() ? guide.kernels().reach() * g.spacing().x : 0;
}

} // namespace

Coupling::Coupling(const Grid& g, const Tube& tube, const Geometry& geometry, CouplingScheme scheme)
    : grid_(g), tube_(&tube), geometry_(&geometry), guide_(scheme),
      clamp_load_(tube, load_reach(g, guide_)),
      transfer_(g, tube, guide_.kernels(), clamp_load_.spreading_rings()),
      pressure_force_(g, tube, load_reach(g, guide_)), ghosts_{make_ghosts(g, tube, Location::u),
                                                               make_ghosts(g, tube, Location::v),
                                                               make_ghosts(g, tube, Location::w)}
{
}

void Coupling::initialise(const WallState& wall, GhostStates& ghosts)
{
    const InterceptSearch search(tube_->mesh, wall.x, *geometry_);
    for (std::size_t c = 0; c < 3; ++c) ghosts_[c].initialise(wall.x, search, ghosts[c]);
    pressure_force_.initialise(ghosts[0]);
}

bool Coupling::update(const WallState& wall, GhostStates& ghosts)
{
    if (!transfer_.update(wall.x)) return false;
    if (tube_->moving_begin() == tube_->moving_end()) return true;
    return ghosts_[0].update(InterceptSearch(tube_->mesh, wall.x, *geometry_), ghosts[0]);
}

void Coupling::spread(Array<Vec3>& f, VectorField& F)
{
    guide_.constrain_force(*tube_, *geometry_, f);
    clamp_load_.apply(*geometry_, f);
    for (Location c : components) transfer_.spread(c, f, F[c]);
}

void Coupling::complete_pressure_force(const GhostStates& ghosts, const ScalarField& P,
                                       VectorField& F)
{
    pressure_force_.complete(ghosts[0], P, F[Location::u]);
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
