#pragma once
/// A short tube in a coarse box, for tests of the coupling.
#include "grid/grid.hpp"
#include "unit/wall/shapes.hpp"
#include "wall/geometry.hpp"

namespace starling::support {

/// The tube's axis is off the grid's symmetry lines; spacings differ slightly.
inline Grid box_around(Real spacing, Real length = 4)
{
    const auto cells = [spacing](Real l) { return static_cast<Index>(std::lround(l / spacing)); };
    return Grid({cells(length), cells(5.1), cells(5)}, {0, -2.53, -2.46}, {length, 5.1, 5});
}

/// A shared stage: grid, tube and the wall's geometry.
struct BoxedTube {
    Grid g;
    Tube tube;
    WallState wall;
    Geometry geometry;

    explicit BoxedTube(Real spacing, TubeParameters p = short_tube())
        : g(box_around(spacing, p.length)), tube(make_tube(p, p.edge_over_spacing * g.delta())),
          wall(tube), geometry(tube.mesh)
    {
        place(wall.x);
    }
    void place(const Array<Vec3>& x)
    {
        wall.x = x;
        geometry.update(wall.x);
    }
};

/// What one pair of threads counts must agree on: runs `make` with 1 and with 2 threads.
template <class Make>
auto with_one_and_two_threads(Make make)
{
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    auto one = make();
    omp_set_num_threads(2);
    auto two = make();
    omp_set_num_threads(before);
    return std::pair{std::move(one), std::move(two)};
}

} // namespace starling::support
