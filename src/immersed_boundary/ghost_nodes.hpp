#pragma once
/// Ghost nodes of one velocity component: who they are, their intercepts, their values.
#include <vector>

#include "flow/prescribed.hpp"
#include "grid/field.hpp"
#include "immersed_boundary/intercept_search.hpp"
#include "wall/tube.hpp"

namespace starling {

/// A node beside the wall and its boundary intercept, whose element the next search starts from.
struct NearNode {
    std::int32_t i = 0, j = 0, k = 0;
    bool searched = false; ///< the intercept belongs to the present wall
    Intercept intercept;
};

/// What ghost nodes remember from one step to the next; part of a checkpoint.
struct GhostState {
    Field<std::uint8_t> inside;      ///< 1 inside the tube, at the nodes of the component
    std::vector<NearNode> near_wall; ///< nodes with a neighbour on the other side, memory order

    explicit GhostState(const Grid& g) : inside(g) {}
};

/// Keeps the set of ghost nodes of a component up to date while the wall moves (sec. 2.6) and
/// evaluates the no-slip condition at the wall, Eqs. (31), (32), (44). A ghost node lies outside
/// and has one of its six neighbours inside, on the grid of its own component. The neighbours of
/// ghost nodes farther out are held at rest: the fluid outside meets a wall that does not move
/// along the component, and not the ghost nodes, which continue the flow inside backwards.
class GhostNodes {
public:
    /// Ghost nodes live on the planes i marked in `active_planes`, one flag per plane.
    GhostNodes(const Grid& g, const Tube& tube, Location component,
               std::vector<char> active_planes);

    /// Finds everything from scratch for the wall at x.
    void initialise(const Array<Vec3>& x, const InterceptSearch& search, GhostState& s);

    /// Steps (i) and (ii): walks from the old intercept elements, turns nodes over that the wall
    /// has passed, declassifies and adds ghost nodes. The wall may have moved by at most one
    /// spacing since the last call. Returns false if the set does not settle (the wall moved too
    /// far).
    bool search(const InterceptSearch& search, GhostState& s);

    /// Step (iii): image points and weights of the ghosts found.
    void prescribe(const GhostState& s);

    /// Values for a wall that does not move along this component: half of the node's own u and half
    /// of u_GN = -(sum_l beta_l u_l - curvature)/(1 + beta_self), the quadratic continuation of the
    /// flow inside through zero at the intercept. The ghost node's own weight is eliminated: its
    /// image point's cell may contain it.
    void evaluate(const ScalarField& u);

    /// View for the momentum step; valid until the next update.
    PrescribedNodes prescribed() const;

    /// Where in `near_wall` each of its nodes stands, since the last search; meaningless elsewhere.
    View<const std::int32_t> place() const { return index_.view(); }

    /// Ghost nodes, without the nodes at rest.
    Index count() const { return ghost_begin_.back(); }

private:
    struct Stencil {
        Index base;                    ///< offset of the lowest of the eight nodes
        std::array<Real, 8> beta;      ///< -beta_l / (1 + beta_self), own weight zero
        std::array<Real, 6> curvature; ///< weights of xx, yy, zz, yz, zx, xy second differences
        Index place;                   ///< offset of the lowest node of the cell they are taken in
        std::array<Real, 3> fraction;  ///< and where in it
    };
    static constexpr std::int32_t at_rest = -1;

    Vec3 position(const NearNode& n) const { return grid_.position(component_, n.i, n.j, n.k); }
    bool exists(std::int32_t i, std::int32_t j, std::int32_t k) const;
    bool touches_other_side(const Field<std::uint8_t>& inside, const NearNode& n) const;
    template <class F>
    void for_neighbours(const NearNode& n, F f) const;
    void classify_planes(const Array<Vec3>& x, Field<std::uint8_t>& inside);
    template <class Ghosts, class F>
    void for_neighbours_across(Ghosts& s, const NearNode& n, F f) const;
    template <class F>
    void find(GhostState& s, F f);
    void search_missing(const InterceptSearch& search, GhostState& s);
    bool follows_another_wall(const GhostState& s, const NearNode& n) const;
    void search_from_each_other(const InterceptSearch& search, GhostState& s, NearNode& n);
    void turn_over(GhostState& s);
    std::size_t merge_candidates(std::vector<NearNode>& nodes);
    void rebuild(GhostState& s);
    template <class F>
    void for_ghosts(const GhostState& s, std::size_t plane, F f) const;
    void mark_plane(const GhostState& s, std::size_t plane);
    void list_plane(const GhostState& s, std::size_t plane);
    Stencil make_stencil(const GhostState& s, const NearNode& n) const;
    void add_curvature(const GhostState& s, const NearNode& n, Stencil& stencil) const;

    Grid grid_;
    const Tube* tube_;
    Location component_;
    std::vector<char> active_planes_;
    std::vector<char> beside_rigid_wall_; ///< planes whose intercepts never change
    Box nodes_;

    Field<std::uint8_t> mask_;
    Field<std::int32_t> index_; ///< position of a node in near_wall; empty without active planes
    std::vector<char> flags_;   ///< per node of near_wall
    std::vector<NearNode*> found_;
    std::vector<NearNode> turned_, candidates_;
    std::vector<Index> near_begin_;            ///< node of near_wall at which plane i begins
    std::vector<Index> ghost_begin_;           ///< ghost at which plane i begins
    std::vector<Index> offsets_, plane_begin_; ///< ghosts and nodes at rest together
    std::vector<std::int32_t> source_;         ///< which ghost, or `at_rest`
    std::vector<Stencil> stencils_;            ///< per ghost
    std::vector<Real> values_;
};

} // namespace starling
