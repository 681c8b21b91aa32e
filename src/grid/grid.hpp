#pragma once
/// The uniform staggered grid: x slowest, z fastest; the tube's axis is y = z = 0 at zero offset.
#include "core/for_each.hpp"
#include "core/types.hpp"
#include "grid/grid_parameters.hpp"

namespace starling {

/// Where a field lives: on the faces normal to x, y, z (velocity components) or in the cells.
/// u(i,j,k) sits on the low-x face of cell (i,j,k), v on the low-y and w on the low-z face.
enum class Location { u, v, w, cell };

inline constexpr std::array<Location, 3> components = {Location::u, Location::v, Location::w};

/// Number of a velocity component: 0, 1, 2.
constexpr int axis(Location c) { return static_cast<int>(c); }

/// Cell counts, spacings and node positions; lengths in R_0.
class Grid {
public:
    Grid(std::array<Index, 3> cells, Vec3 origin, Vec3 lengths);

    Index nx() const { return cells_[0]; }
    Index ny() const { return cells_[1]; }
    Index nz() const { return cells_[2]; }
    const std::array<Index, 3>& cells() const { return cells_; }
    Index cell_count() const { return cells_[0] * cells_[1] * cells_[2]; }
    const Vec3& origin() const { return origin_; }
    const Vec3& lengths() const { return lengths_; }
    const Vec3& spacing() const { return spacing_; }
    /// The spacing called Delta in limits and tolerances: geometric mean of the three.
    Real delta() const { return delta_; }
    Real cell_volume() const { return spacing_.x * spacing_.y * spacing_.z; }

    /// Coordinate of node n along one direction for a field at `where`.
    Real x(Location where, Index i) const
    {
        return origin_.x + spacing_.x * (static_cast<Real>(i) + (where == Location::u ? 0. : 0.5));
    }
    Real y(Location where, Index j) const
    {
        return origin_.y + spacing_.y * (static_cast<Real>(j) + (where == Location::v ? 0. : 0.5));
    }
    Real z(Location where, Index k) const
    {
        return origin_.z + spacing_.z * (static_cast<Real>(k) + (where == Location::w ? 0. : 0.5));
    }
    Vec3 position(Location where, Index i, Index j, Index k) const
    {
        return {x(where, i), y(where, j), z(where, k)};
    }

    /// Nodes that carry an unknown: u on all nx + 1 face planes, v not on the two y walls.
    Box unknowns(Location where) const;

private:
    std::array<Index, 3> cells_;
    Vec3 origin_, lengths_, spacing_;
    Real delta_;
};

/// Smallest product of 2, 3 and 5 (even if asked) nearest to n.
Index nearest_smooth(Real n, bool even = false);

/// The grid of a case: counts from the wanted spacing, box centred on the tube's axis + offset.
Grid make_grid(const GridParameters& p, Real tube_length);

} // namespace starling
