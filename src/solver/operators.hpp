#pragma once
/// The operators of a step, built once, and the step's work space.
#include "core/timer.hpp"
#include "flow/momentum.hpp"
#include "flow/projection.hpp"
#include "immersed_boundary/coupling.hpp"
#include "immersed_boundary/section_flow.hpp"
#include "wall/bending_force.hpp"
#include "wall/contact.hpp"
#include "wall/elastic_force.hpp"
#include "wall/membrane_viscosity.hpp"
#include "wall/mesh_filter.hpp"
#include "wall/rigid_support.hpp"
#include "wall/smoothing.hpp"
#include "wall/tissue.hpp"

namespace starling {

/// Phases of a step that are timed, in order.
enum class Phase : std::size_t {
    wall_force,
    element_search,
    ghost_nodes,
    spread,
    momentum,
    pressure,
    wall_motion
};

/// What the wall resists with, in solver units.
struct WallModel {
    Material material;
    Real E_b = 0; ///< bending modulus (rho U_c^2 R_0^3)
    ContactParameters contact;
    Real filter_rate = 0; ///< of the mesh filter (U_c/R_0)
    Real smoothing = 0;   ///< alpha of the smoothing velocity (U_c R_0^3)
    TissueParameters tissue = {};
    Real mu_s = 0;         ///< membrane viscosity (rho U_c R_0^2)
    Real nu_s = 0;         ///< Poisson ratio of the viscosity
    AlongX stiffness = {}; ///< factor on the material's tensions
};

/// Holds references to `tube`, which must outlive it.
struct Operators {
    const Tube& tube;
    Geometry geometry;
    ElasticForce elastic;
    MembraneViscosity viscosity;
    Bending bending;
    Contact contact;
    Tissue tissue;
    RigidSupport support;
    Coupling coupling;
    Momentum momentum;
    Projection projection;
    SurfaceSmoothing smoothing;
    MeshFilter filter;

    Operators(const Grid& g, const Tube& tube_, const WallModel& wall, const FluidParameters& fluid,
              const DriveParameters& drive, CouplingScheme scheme)
        : tube(tube_), geometry(tube.mesh), elastic(tube, wall.material, wall.stiffness),
          viscosity(tube, wall.mu_s, wall.nu_s), bending(tube, wall.E_b),
          contact(tube, wall.contact), tissue(tube, wall.tissue),
          support(tube, supports_rigid_parts(scheme), fluid.reynolds, g.delta()),
          coupling(g, tube, geometry, scheme), momentum(g, fluid), projection(g, fluid, drive),
          smoothing(tube, wall.smoothing), filter(tube, wall.filter_rate)
    {
        SectionFlow section_flow(g, tube);
        const Array<Vec3> at_rest = WallState(tube).x;
        projection.set_ends(coupling.inside_share(), {section_flow.weights(at_rest, 0),
                                                      section_flow.weights(at_rest, g.nx())});
    }
    Operators(const Operators&) = delete;
    Operators& operator=(const Operators&) = delete;
};

/// Memory a step uses and forgets.
struct Workspace {
    Array<Vec3> f; ///< force on each vertex
    VectorField F; ///< force density at the faces, then increment; zero between the steps
    PhaseTimer timer{{"wall force", "element search", "ghost nodes", "spread", "momentum",
                      "pressure", "wall motion"}};

    Workspace(const Grid& g, const Tube& tube) : f(static_cast<Index>(tube.X.size())), F(g) {}
    void mark(Phase p) { timer.mark(static_cast<std::size_t>(p)); }
};

} // namespace starling
