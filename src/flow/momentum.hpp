#pragma once
/// The advection-diffusion step: intermediate velocity u_hat.
#include <vector>

#include "flow/fluid_state.hpp"
#include "flow/periodic_lines.hpp"
#include "flow/prescribed.hpp"
#include "parallel/x_lines.hpp"

namespace starling {

/// Solves Eq. (36) with theta-diffusion by ADI in increment form.
///
/// Deviation: Eqs. (40)-(43) as printed are first order with an error O(dt) in the steady state;
/// prod_d (1 - theta dt/Re d^2/dx_d^2) (u_hat - u^n) = dt [ -grad P^n - N + Lap u^n / Re + F ]
/// costs the same and has none.
class Momentum {
public:
    Momentum(const Grid& g, const FluidParameters& p);

    /// Advances s.u from u^n to u_hat (valid halos) and s.N_before to N^n. `rhs` comes in as the
    /// body force F at the faces, is used as work space and left zero, ready for the next force.
    /// Prescribed nodes take their value. Needs valid halos of s.u and s.P.
    void predict(FluidState& s, VectorField& rhs, const PrescribedVelocity& prescribed, Real dt);

private:
    template <Location C>
    struct InPlane;
    template <Location C>
    InPlane<C> in_plane(FluidState& s, VectorField& rhs, const PrescribedVelocity& prescribed,
                        Real dt);
    void solve_planes(FluidState& s, VectorField& rhs, const PrescribedVelocity& prescribed,
                      Real dt);
    template <Location C>
    void x_solve_and_add(ScalarField& u, ScalarField& increment, const PrescribedNodes& prescribed,
                         Real dt);

    void find_free_chunks(const PrescribedNodes& prescribed, Index first_column);

    Real implicit(int direction, Real dt) const;

    Grid grid_;
    Real inv_reynolds_, theta_;
    XLines lines_;
    PeriodicLines line_z_;
    EliminatedLine free_line_x_; ///< lines without prescribed nodes
    std::array<EliminatedLine, 3> free_line_y_;
    std::vector<char> chunk_is_free_; ///< chunks of lines along x without prescribed nodes
    Index plane_scratch_;             ///< reals per thread
    Array<Real> scratch_;
};

} // namespace starling
