#pragma once
/// Where the energy goes: what the drive puts in, what the fluid and the wall take.
#include "immersed_boundary/section_flow.hpp"
#include "solver/operators.hpp"
#include "solver/state.hpp"

namespace starling {

/// Rates of energy in the last step (rho U_c^3 R_0^2); zero before the first.
struct Powers {
    Real inlet = 0;    ///< work of the inlet pressure and kinetic energy that enters, in the tube
    Real outlet = 0;   ///< the same that leaves through the outlet
    Real exterior = 0; ///< what enters through both end faces outside the tube
    Real dissipation = 0; ///< by the fluid's viscosity
    Real kinetic = 0;     ///< change of the fluid's kinetic energy
    /// Work on the wall and the tissue around: their change of energy, where the law has one, and
    /// their dissipation.
    Real wall = 0;

    /// What the balance leaves over: errors of discretisation in space and time.
    Real residual() const { return inlet - outlet + exterior - dissipation - kinetic - wall; }
};

/// Measures the powers of a state. Derivation: docs/numerics.md, "Energy". Sums have a fixed order.
class PowerBalance {
public:
    /// Holds references to what it is given.
    PowerBalance(const Grid& g, Operators& op, const FluidParameters& fluid,
                 const DriveParameters& drive);

    Powers measure(const State& s);

private:
    struct EndPower {
        Real inside = 0, outside = 0;
    };
    EndPower entering(const State& s, std::size_t end);
    Real dissipation(const State& s);
    void mark_no_fluid(Location c, const GhostStates& ghosts);
    Real work_on_wall(const State& s);

    Grid grid_;
    Operators* op_;
    Real inv_reynolds_;
    bool total_pressure_;
    SectionFlow section_flow_;
    Geometry geometry_;
    Array<Vec3> x_before_, f_;     ///< positions before the last step and the wall's forces there
    Field<std::uint8_t> no_fluid_; ///< 1 at nodes that do not count as fluid
};

} // namespace starling
