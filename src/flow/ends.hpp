#pragma once
/// What is known at the two end faces of the box: pressures, a flow rate, a Windkessel.
#include "flow/fluid_state.hpp"
#include "grid/field.hpp"

namespace starling {

/// The pressure on the end faces, step by step: share * (inside) + (1 - share) * (external), where
/// inside is the drive's pressure or the one with which the flow meets its condition
/// (docs/numerics.md, "The ends").
class Ends {
public:
    Ends(const Grid& g, const DriveParameters& drive);

    /// Shares other than `inside_share` of the pressures inside and outside, 1 - share (ny x nz).
    void set_inside_share(Array<Real> share) { share_ = std::move(share); }
    /// How much the u of each face of an end (ny x nz) counts in the flow rate inside the tube;
    /// without it that is the area of the faces with r < R_0.
    void set_flow_weights(std::size_t end, Array<Real> weights)
    {
        weights_[end] = std::move(weights);
    }

    /// Before the first step.
    void initialise(EndState& ends);
    /// Takes the pressures at time t, and with u_hat the dynamic pressure of what flows in; the
    /// pressure at an end that answers to the flow stays. Returns whether anything changes.
    bool prescribe(EndState& ends, const ScalarField& u_hat, Real t);
    /// Turns a halo of phi that is odd about the end faces into one that takes there what
    /// `prescribe` has changed.
    void add_change(ScalarField& phi) const { add_end_values(phi, change_); }
    /// The same with the pressure itself.
    void add_pressure(const EndState& ends, ScalarField& P) const
    {
        add_end_values(P, ends.pressure);
    }
    /// The part of that change in -dt grad phi, which a solver with phi = 0 on the faces leaves
    /// out.
    void push(ScalarField& u, Real dt) const;

    /// Whether the pressure at an end answers to the flow.
    bool answer_to_flow() const { return inlet_answers() || outlet_answers(); }
    /// Shapes the answers: `unit` is the increment, with valid halos, of one more unit of pressure
    /// inside the inlet.
    void set_unit_increment(ScalarField unit);
    const Array<Real>& share() const { return share_; }
    /// With the increment phi, zero on the faces, and u_hat: finds the pressures with which the
    /// flow at t meets its conditions, and adds what they do to phi, halo included.
    void answer(EndState& ends, const ScalarField& u_hat, Real t, Real dt, ScalarField& phi);

private:
    bool inlet_answers() const { return drive_.inlet_flow.given; }
    bool outlet_answers() const { return !drive_.windkessel.none(); }
    bool set_pressure(EndState& ends, std::size_t end, Real inside, const ScalarField& u_hat);
    void add_end_values(ScalarField& field, const std::array<Array<Real>, 2>& values) const;
    Real flow(std::size_t end, const ScalarField& u_hat, const ScalarField& phi, Real dt) const;
    Real unit_flow(std::size_t end, bool own_pressure) const;
    void add_answer(EndState& ends, const std::array<Real, 2>& more, ScalarField& phi);

    Grid grid_;
    DriveParameters drive_;
    Real external_ = 0;
    Array<Real> share_;
    std::array<Array<Real>, 2> weights_, change_;
    ScalarField unit_;
    /// Flow through an end per unit of pressure at it and at the other end, and of time.
    std::array<Real, 2> conductance_{}, other_conductance_{};
};

} // namespace starling
