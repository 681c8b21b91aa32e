/// A wall that a prescribed, smooth flow carries along and that encloses no sources: its volume
/// must not change.
#include <gtest/gtest.h>

#include "immersed_boundary/coupling.hpp"
#include "wall/lumen.hpp"

namespace starling {
namespace {

constexpr Real length = 6, rigid = 1;

/// sin^2 between the rigid parts, which nothing reaches, and its derivative.
struct Fade {
    Real value = 0, slope = 0;
    explicit Fade(Real x)
    {
        const Real k = pi / (length - 2 * rigid), s = x - rigid;
        if (s <= 0 || s >= length - 2 * rigid) return;
        value = std::sin(k * s) * std::sin(k * s);
        slope = k * std::sin(2 * k * s);
    }
};

/// Velocity of amplitude 1: v = y, w = -z makes an ellipse of a circle; u = 1 shifts the fluid
/// along the tube, which narrows one half of it and widens the other. A discrete curl of values at
/// the edges of the cells, so that no cell has a divergence.
VectorField flow(const Grid& g)
{
    const Vec3 h = g.spacing(), o = g.origin();
    const auto along_x = [&](Index i, Index j, Index k) { // at (i + 1/2, j, k)
        return Fade((static_cast<Real>(i) + 0.5) * h.x).value * (o.y + static_cast<Real>(j) * h.y) *
               (o.z + static_cast<Real>(k) * h.z);
    };
    const auto along_z = [&](Index i, Index j, Index) { // at (i, j, k + 1/2)
        return Fade(static_cast<Real>(i) * h.x).value * (o.y + static_cast<Real>(j) * h.y);
    };
    VectorField u(g);
    for (Index i = -1; i <= g.nx() + 1; ++i)
        for (Index j = -1; j <= g.ny(); ++j)
            for (Index k = -1; k <= g.nz(); ++k) {
                u[Location::u](i, j, k) = (along_z(i, j + 1, k) - along_z(i, j, k)) / h.y;
                u[Location::v](i, j, k) = (along_x(i, j, k + 1) - along_x(i, j, k)) / h.z -
                                          (along_z(i + 1, j, k) - along_z(i, j, k)) / h.x;
                u[Location::w](i, j, k) = -(along_x(i, j + 1, k) - along_x(i, j, k)) / h.y;
            }
    return u;
}

struct Change {
    Real volume = 0;   ///< relative change where the wall turns
    Real movement = 0; ///< largest displacement of a vertex there
};

/// The wall goes with the flow, u = 0.55 sin(pi t) of it, up to t = 1.
Change change_of_volume(Real spacing, CouplingScheme scheme, int steps)
{
    const auto cells = [=](Real l) { return static_cast<Index>(std::lround(l / spacing)); };
    const Grid g({cells(length), cells(5), cells(5)}, {0, -2.5, -2.5}, {length, 5, 5});
    const Tube tube =
        make_tube({.length = length, .rigid_inlet = rigid, .rigid_outlet = rigid}, 0.65 * spacing);
    Geometry geometry(tube.mesh);
    Coupling coupling(g, tube, geometry, scheme);
    WallState wall(tube);
    const VectorField shape = flow(g);
    const Real start = enclosed_volume(tube, wall.x), dt = 1. / steps;
    for (int n = 0; n < steps; ++n) {
        geometry.update(wall.x);
        EXPECT_TRUE(coupling.weigh(wall));
        coupling.follow(shape, wall);
        const Real amplitude = 0.55 * std::sin(pi * (n + 0.5) / steps);
        for (Vec3& U : wall.velocity) U = amplitude * U;
        wall.move(tube, dt);
    }
    Change change{enclosed_volume(tube, wall.x) / start - 1, 0};
    for (Index v = 0; v < wall.x.size(); ++v)
        change.movement =
            std::max(change.movement, norm(wall.x[v] - tube.X[static_cast<std::size_t>(v)]));
    return change;
}

TEST(ClosedVolume, IsKeptUpToTheErrorsOfTrianglesAndTimeStep)
{
    std::array<Real, 2> left{}; // without the error of the step, x += dt U: of first order
    for (std::size_t n : {0, 1}) {
        const Real spacing = n == 0 ? 0.2 : 0.1;
        const auto scheme = CouplingScheme::conserving;
        const Change coarse = change_of_volume(spacing, scheme, 500);
        const Change fine = change_of_volume(spacing, scheme, 1000);
        EXPECT_NEAR(fine.movement, 0.64, 0.02);
        EXPECT_LT(std::abs(fine.volume), 1e-4); // 7.3e-5, -1.0e-5
        left[n] = 2 * fine.volume - coarse.volume;
    }
    EXPECT_LT(std::abs(left[1]), 4e-5);           // 2.9e-5
    EXPECT_GT(std::log2(left[0] / left[1]), 1.8); // 1.93: the triangles
}

/// The wall of the printed scheme does not follow the flow along the tube.
TEST(ClosedVolume, IsNotKeptByThePrintedScheme)
{
    EXPECT_GT(std::abs(change_of_volume(0.2, CouplingScheme::printed, 1000).volume), 5e-3);
}

} // namespace
} // namespace starling
