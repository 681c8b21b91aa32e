#pragma once
/// What kernels are timed on: a grid, fields that are not zero, a tube that is deformed a little.
#include <benchmark/benchmark.h>

#include "grid/boundary.hpp"
#include "wall/geometry.hpp"

namespace starling::benchmarks {

/// Cells of the grids of a sweep; the last two are those across the tube.
inline void grids(benchmark::internal::Benchmark* b)
{
    b->Args({64, 48, 48})->Args({256, 96, 96})->Args({64, 240, 240});
    b->ArgNames({"nx", "ny", "nz"})->Unit(benchmark::kMillisecond)->UseRealTime();
}

inline Grid grid_of(const benchmark::State& state)
{
    const std::array<Index, 3> cells = {state.range(0), state.range(1), state.range(2)};
    constexpr Real width = 4.7;
    const Real length = width * static_cast<Real>(cells[0]) / static_cast<Real>(cells[1]);
    return Grid(cells, {0, -width / 2, -width / 2}, {length, width, width});
}

/// Reports items (cells, vertices, unknowns) per second.
inline void count_items(benchmark::State& state, Index items)
{
    state.SetItemsProcessed(items * static_cast<Index>(state.iterations()));
}

/// A smooth value that differs from node to node.
inline Real wave(Index i, Index j, Index k)
{
    return std::sin(0.7 * static_cast<Real>(i) + 0.4 * static_cast<Real>(j) +
                    0.9 * static_cast<Real>(k));
}

/// Values at all unknowns; halos untouched.
inline void fill_waves(const Grid& g, Location where, ScalarField& field)
{
    const View<Real> f = field.view();
    for_each(g.unknowns(where), [=](Index i, Index j, Index k) { f(i, j, k) = wave(i, j, k); });
}

/// A velocity with valid halos.
inline VectorField velocity(const Grid& g)
{
    VectorField u(g);
    for (Location c : components) fill_waves(g, c, u[c]);
    fill_velocity_halo(g, u);
    return u;
}

/// A tube as long as the grid, edges of 0.65 spacings, widened by 5 % between the clamps.
struct Wall {
    Tube tube;
    WallState state;
    Geometry geometry;

    explicit Wall(const Grid& g) : tube(make(g)), state(tube), geometry(tube.mesh)
    {
        const Real begin = tube.x_clamp_in(), length = tube.x_clamp_out() - begin;
        for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) {
            Vec3& x = state.x[v];
            const Real s = 1 + 0.05 * std::sin(pi * (x.x - begin) / length);
            x.y *= s, x.z *= s;
        }
        geometry.update(state.x);
    }
    Index vertices() const { return state.x.size(); }

private:
    static Tube make(const Grid& g)
    {
        TubeParameters p;
        p.length = g.lengths().x;
        p.rigid_inlet = p.rigid_outlet = 0.1 * p.length;
        return make_tube(p, p.edge_over_spacing * g.delta());
    }
};

} // namespace starling::benchmarks
