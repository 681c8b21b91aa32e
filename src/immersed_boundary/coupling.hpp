#pragma once
/// The hybrid coupling of fluid and wall, Eq. (35): the only place where the two meet in a step.
#include "immersed_boundary/axial_guide.hpp"
#include "immersed_boundary/ghost_nodes.hpp"
#include "immersed_boundary/transfer.hpp"
#include "immersed_boundary/wall_pressure_force.hpp"

namespace starling {

using GhostStates = std::array<GhostState, 3>;

/// Ghost nodes act on u everywhere; v and w move the wall and carry its forces. In the rigid parts
/// ghost nodes act on v and w too, or (scheme `conserving`) forces that hold the wall in place.
class Coupling {
public:
    /// `tube` and `geometry` must outlive the coupling.
    Coupling(const Grid& g, const Tube& tube, const Geometry& geometry, CouplingScheme scheme);

    /// Finds all ghost nodes from scratch for the wall at x (geometry up to date).
    void initialise(const WallState& wall, GhostStates& ghosts);

    /// Weights of spreading and interpolation for the present wall. Returns false if a vertex is
    /// not finite or leaves the box.
    bool weigh(const WallState& wall);

    /// Intercept elements and ghost nodes for the present wall (geometry up to date). Returns false
    /// if it moved by more than a spacing.
    bool search(const WallState& wall, GhostStates& ghosts);

    /// Image points and weights of the ghost nodes.
    void place_images(const GhostStates& ghosts);

    /// F += force of the wall on the fluid at the faces; f comes in as a force on each vertex and
    /// leaves with the axial reaction. (28)
    void spread(Array<Vec3>& f, VectorField& F);

    /// Makes F whole beside the wall, where it has smeared the jump of the pressure P.
    void complete_pressure_force(const GhostStates& ghosts, const ScalarField& P, VectorField& F);

    /// Ghost-node values from the present velocity. (44)
    PrescribedVelocity no_slip(const VectorField& u);

    /// wall.velocity of the acting rings = the fluid's velocity there, as the guide allows. (30)
    void follow(const VectorField& u, WallState& wall);

    /// How much of a cell counts as inside the tube in the pressures of the end faces: as a field
    /// of ny x nz cells, z fastest. Sharp, or smeared as the forces of the rigid parts are.
    Array<Real> inside_share();

    const GhostNodes& ghosts(Location c) const
    {
        return ghosts_[static_cast<std::size_t>(axis(c))];
    }

private:
    Grid grid_;
    const Tube* tube_;
    const Geometry* geometry_;
    AxialGuide guide_;
    RingRange acting_;
    Transfer transfer_;
    WallPressureForce pressure_force_;
    std::array<GhostNodes, 3> ghosts_;
};

} // namespace starling
