#pragma once
/// What a state says about itself: samples, profiles and snapshots. Numbers only, no files.
#include "solver/monitor_data.hpp"
#include "solver/power_balance.hpp"
#include "wall/lumen.hpp"

namespace starling {

/// Largest speed component times dt over spacing, and the largest speed; NaN if a value is not
/// finite.
struct SpeedCheck {
    Real cfl = 0;
    Real u_max = 0;
};
SpeedCheck check_speed(const Grid& g, const VectorField& u, Real dt);

/// Measures a state. Everything is summed in a fixed order, so results do not depend on threads.
class Monitor {
public:
    /// Holds references to the operators.
    Monitor(const Grid& g, Operators& op, const FluidParameters& fluid,
            const DriveParameters& drive);

    Sample sample(const State& s);
    std::vector<ProfileRow> profile(const State& s);
    /// The cross-sections through the rings of vertices.
    std::vector<SectionPoint> sections(const State& s) const;
    WallSnapshot wall(const State& s, const Array<Vec3>& elastic_force);
    /// Without what takes a look at the fluid: also of a wall that is not finite.
    WallSnapshot wall_motion(const State& s, const Array<Vec3>& elastic_force) const;
    FluidSnapshot fluid(const State& s) const;
    /// Stress of the fluid inside on the wall, in its plane, at each vertex (rho U_c^2):
    /// mu d(u - U)/dn along the inward normal, from probes 1.5 and 3 spacings inside.
    std::vector<Vec3> wall_shear_stress(const State& s);

private:
    struct Ring {
        Real mean = 0, min = 0, max = 0;
    };
    Ring ring_radius(const Array<Vec3>& x, Index ring) const;
    void add_narrowest_section(const Array<Vec3>& x, Sample& a) const;
    Real undeformed_area(Index ring) const;
    void find_positions_before(const State& s);
    Real volume_rate(const State& s);
    std::vector<Real> leak_up_to_rings(const State& s);
    Real transmural_pressure(const State& s, VertexIndex v) const;
    Vec3 wall_shear_stress(const State& s, VertexIndex v) const;
    Vec3 outward_normal(VertexIndex v) const;

    Grid grid_;
    const Tube* tube_;
    const ElasticForce* elastic_;
    Bending* bending_;
    Real inv_reynolds_;
    Geometry geometry_;
    Array<Vec3> before_; ///< positions before the last step
    SectionFlow section_flow_;
    PowerBalance power_;
};

} // namespace starling
