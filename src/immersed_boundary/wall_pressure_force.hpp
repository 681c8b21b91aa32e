#pragma once
/// The axial pressure force on the fluid beside the wall, where kernels smear the pressure jump.
#include "grid/field.hpp"
#include "immersed_boundary/ghost_nodes.hpp"

namespace starling {

/// Spreading smears the jump [P] of the pressure over the kernel's width: P = P_ext + [P] H with a
/// smooth H. The wall's force balances [P] grad H and leaves H d[P]/dx: beside the wall the flow
/// inside feels only a part of the axial gradient, from one half at the wall to all of it at the
/// kernel's reach. The true force is that of the flow beyond the kernel's reach: it is taken from
/// there, along the wall's normal. Derivation: docs/numerics.md.
class WallPressureForce {
public:
    /// The force is found at `depth` (R_0) from the wall; 0 leaves all as it is.
    WallPressureForce(const Grid& g, Real depth);

    /// Makes room for so many near nodes as the ghosts have.
    void initialise(const GhostState& ghosts) { gradient_.reserve(ghosts.near_wall.capacity()); }

    /// Makes dP/dx - F at the inside u-faces next to ghost nodes that of the flow farther inside,
    /// by changing F. Faces from whose ghosts no fluid is found (narrow channels) are left alone.
    /// `place` says where in the list of near nodes a node stands.
    void complete(const GhostState& ghosts, View<const std::int32_t> place, const ScalarField& P,
                  ScalarField& F);

private:
    struct Probe {
        View<const std::uint8_t> inside;
        View<const std::int32_t> place;
        View<const Real> P, F;
    };
    Real net_gradient(const Probe& s, Index i, Index j, Index k) const
    {
        return (s.P(i, j, k) - s.P(i - 1, j, k)) / grid_.spacing().x - s.F(i, j, k);
    }
    bool acts_on(const NearNode& n) const;
    Real gradient_beyond(const Probe& s, const NearNode& ghost) const;
    /// Mean over the ghosts beside an inside node; none without any.
    Real mean_beyond(const Probe& s, const NearNode& n) const;

    static constexpr Real none = std::numeric_limits<Real>::max();
    Grid grid_;
    Real depth_;
    /// Per near node the net gradient: its own inside, at ghosts that of the flow farther inside,
    /// or none.
    std::vector<Real> gradient_;
};

} // namespace starling
