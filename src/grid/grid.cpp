#include "grid/grid.hpp"

namespace starling {

Grid::Grid(std::array<Index, 3> cells, Vec3 origin, Vec3 lengths)
    : cells_(cells), origin_(origin),
      lengths_(lengths), spacing_{lengths.x / static_cast<Real>(cells[0]),
                                  lengths.y / static_cast<Real>(cells[1]),
                                  lengths.z / static_cast<Real>(cells[2])},
      delta_(std::cbrt(spacing_.x * spacing_.y * spacing_.z))
{
}

Box Grid::unknowns(Location where) const
{
    Box b{{0, 0, 0}, cells_};
    if (where == Location::u) b.end[0] += 1;
    if (where == Location::v) b.begin[1] = 1;
    return b;
}

namespace {

bool is_smooth(Index n)
{
    for (Index p : {2, 3, 5})
        while (n % p == 0) n /= p;
    return n == 1;
}

} // namespace

Index nearest_smooth(Real n, bool even)
{
    Index best = 0;
    for (Index m = 2; static_cast<Real>(m) < 2 * n + 4; ++m) {
        if (!is_smooth(m) || (even && m % 2 != 0)) continue;
        if (best == 0 || std::abs(static_cast<Real>(m) - n) < std::abs(static_cast<Real>(best) - n))
            best = m;
    }
    return best;
}

Grid make_grid(const GridParameters& p, Real tube_length)
{
    const std::array<Index, 3> cells =
        p.cells ? *p.cells
                : std::array<Index, 3>{std::max<Index>(2, std::llround(tube_length / p.spacing)),
                                       nearest_smooth(p.width_y / p.spacing, true),
                                       nearest_smooth(p.width_z / p.spacing, true)};
    return Grid(cells, {0, -p.width_y / 2 - p.tube_offset_y, -p.width_z / 2 - p.tube_offset_z},
                {tube_length, p.width_y, p.width_z});
}

} // namespace starling
