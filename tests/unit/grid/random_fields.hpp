#pragma once
/// Random fields on the grid and serial reductions, for tests of discrete identities.
#include <algorithm>
#include <random>

#include "grid/boundary.hpp"
#include "grid/field.hpp"

namespace starling::support {

/// Uniform values in (-1, 1), the same in every run.
class Random {
public:
    explicit Random(unsigned seed = 1) : engine_(seed) {}
    Real operator()() { return distribution_(engine_); }

private:
    std::mt19937_64 engine_;
    std::uniform_real_distribution<Real> distribution_{-1, 1};
};

/// Calls f(i, j, k) in order, on one thread.
template <class F>
void visit(const Box& b, F f)
{
    for (Index i = b.begin[0]; i < b.end[0]; ++i)
        for (Index j = b.begin[1]; j < b.end[1]; ++j)
            for (Index k = b.begin[2]; k < b.end[2]; ++k) f(i, j, k);
}

/// Largest |f(i, j, k)| over the box.
template <class F>
Real largest(const Box& b, F f)
{
    Real m = 0;
    visit(b, [&](Index i, Index j, Index k) { m = std::max(m, std::abs(f(i, j, k))); });
    return m;
}

/// Random unknowns of a field at `where`; halos untouched.
inline void randomise(const Grid& g, Location where, ScalarField& f, Random& random)
{
    visit(g.unknowns(where), [&](Index i, Index j, Index k) { f(i, j, k) = random(); });
}

/// Random velocity with valid halos.
inline VectorField random_velocity(const Grid& g, Random& random)
{
    VectorField u(g);
    for (Location c : components) randomise(g, c, u[c], random);
    fill_velocity_halo(g, u);
    return u;
}

/// The discrete curl of a random vector potential on the edges: its divergence is round-off in
/// every cell. The potential vanishes within `margin` faces of the x ends and the y walls, so no
/// flow crosses them. Halos are valid.
inline VectorField random_solenoidal_velocity(const Grid& g, Index margin, Random& random)
{
    const auto in_x = [&](Index i, Index end) { return i >= margin && i < end - margin; };
    const auto in_y = [&](Index j, Index end) { return j >= margin && j < end - margin; };
    const Index nx = g.nx(), ny = g.ny(), nz = g.nz();
    ScalarField A_x(g), A_y(g), A_z(g); // on the edges parallel to x, y and z
    visit({{0, 0, 0}, {nx + 1, ny + 1, nz}}, [&](Index i, Index j, Index k) {
        A_x(i, j, k) = in_x(i, nx) && in_y(j, ny + 1) ? random() : 0;
        A_y(i, j, k) = in_x(i, nx + 1) && in_y(j, ny) ? random() : 0;
        A_z(i, j, k) = in_x(i, nx + 1) && in_y(j, ny + 1) ? random() : 0;
    });
    const Vec3 h = g.spacing();
    VectorField u(g);
    visit({{0, 0, 0}, {nx + 1, ny, nz}}, [&](Index i, Index j, Index k) {
        const Index up = (k + 1) % nz;
        u[Location::u](i, j, k) =
            (A_z(i, j + 1, k) - A_z(i, j, k)) / h.y - (A_y(i, j, up) - A_y(i, j, k)) / h.z;
        if (i == nx) return;
        u[Location::v](i, j, k) =
            (A_x(i, j, up) - A_x(i, j, k)) / h.z - (A_z(i + 1, j, k) - A_z(i, j, k)) / h.x;
        u[Location::w](i, j, k) =
            (A_y(i + 1, j, k) - A_y(i, j, k)) / h.x - (A_x(i, j + 1, k) - A_x(i, j, k)) / h.y;
    });
    fill_velocity_halo(g, u);
    return u;
}

} // namespace starling::support
