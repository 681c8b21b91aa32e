#pragma once
/// Implicit diffusion along one grid line: 1 - a d^2, with its boundary conditions.
#include <cstdint>

#include "grid/grid.hpp"
#include "parallel/tridiagonal.hpp"

namespace starling {

/// Rows of 1 - a d^2 (second difference times h^2) for n unknowns. At both ends the neighbour
/// outside is folded in: the end row is (1 + a end_diagonal) x_0 - a end_neighbour x_1.
/// Prescribed nodes have identity rows, so a prescribed increment passes every sweep unchanged.
struct DiffusionLine {
    Real a;
    Index last;
    Real end_diagonal, end_neighbour;

    /// Row m for the nodes of one grid row; mask[k] is 1 where node k is prescribed.
    struct Row {
        Real lower, diagonal_less_1, upper;
        const std::uint8_t* mask;

        TridiagonalRow operator()(Index k) const
        {
            const Real active = 1 - static_cast<Real>(mask[k]);
            return {active * lower, 1 + active * diagonal_less_1, active * upper};
        }
    };
    Row row(Index m, const std::uint8_t* mask) const
    {
        const bool first = m == 0, end = first || m == last;
        return {first ? 0
                : end ? -a * end_neighbour
                      : -a,
                a * (end ? end_diagonal : 2),
                m == last ? 0
                : first   ? -a * end_neighbour
                          : -a,
                mask};
    }
};

/// Eliminates the matrix of a line without prescribed nodes.
inline void eliminate(const DiffusionLine& line, EliminatedLine& eliminated)
{
    const std::uint8_t free = 0;
    eliminated.set(line.last + 1, [&](Index m) { return line.row(m, &free)(0); });
}

/// The line of component c along x (direction 0) or y (1), with a = theta dt/(Re h^2):
/// zero normal derivative at the x ends (u is even about its end face, v and w about the face half
/// a cell away), no slip at the y walls (u, w are odd about the wall; v is zero on it).
inline DiffusionLine diffusion_line(const Grid& g, Location c, int direction, Real a)
{
    if (direction == 0)
        return c == Location::u ? DiffusionLine{a, g.nx(), 2, 2}
                                : DiffusionLine{a, g.nx() - 1, 1, 1};
    return c == Location::v ? DiffusionLine{a, g.ny() - 2, 2, 1}
                            : DiffusionLine{a, g.ny() - 1, 3, 1};
}

} // namespace starling
