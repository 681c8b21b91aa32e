/// Kernels of the coupling; items are vertices, or ghost nodes where the name says so.
#include "immersed_boundary/coupling.hpp"
#include "stage.hpp"

namespace starling::benchmarks {
namespace {

struct Coupled {
    Grid g;
    Wall wall;
    AxialGuide guide{CouplingScheme::conserving};
    Transfer transfer;
    Array<Vec3> f;

    explicit Coupled(const benchmark::State& state)
        : g(grid_of(state)), wall(g),
          transfer(g, wall.tube, guide.kernels(), guide.acting_rings(wall.tube)), f(wall.vertices())
    {
        f.fill({0.1, 0.2, 0.3});
        transfer.update(wall.state.x);
    }
};

void TransferWeights(benchmark::State& state)
{
    Coupled c(state);
    for (auto _ : state) benchmark::DoNotOptimize(c.transfer.update(c.wall.state.x));
    count_items(state, c.wall.vertices());
}
BENCHMARK(TransferWeights)->Apply(grids);

template <Location C>
void Spread(benchmark::State& state)
{
    Coupled c(state);
    ScalarField F(c.g);
    for (auto _ : state) c.transfer.spread(C, c.f, F);
    count_items(state, c.wall.vertices());
}
BENCHMARK(Spread<Location::u>)->Apply(grids);
BENCHMARK(Spread<Location::v>)->Apply(grids);

template <Location C>
void Interpolate(benchmark::State& state)
{
    Coupled c(state);
    const VectorField u = velocity(c.g);
    for (auto _ : state) c.transfer.interpolate(C, u[C], c.wall.state.velocity);
    count_items(state, c.wall.vertices());
}
BENCHMARK(Interpolate<Location::u>)->Apply(grids);
BENCHMARK(Interpolate<Location::v>)->Apply(grids);

struct Ghosts {
    Grid g;
    Wall wall;
    GhostNodes nodes;
    GhostState s;

    explicit Ghosts(const benchmark::State& state)
        : g(grid_of(state)), wall(g),
          nodes(g, wall.tube, Location::u,
                std::vector<char>(static_cast<std::size_t>(g.nx() + 1), 1)),
          s(g)
    {
        nodes.initialise(wall.state.x, search(), s);
    }
    InterceptSearch search() const
    {
        return InterceptSearch(wall.tube.mesh, wall.state.x, wall.geometry);
    }
};

/// The wall stands still, so that every walk ends in the element where it begins.
void GhostNodeSearch(benchmark::State& state)
{
    Ghosts c(state);
    for (auto _ : state) benchmark::DoNotOptimize(c.nodes.search(c.search(), c.s));
    count_items(state, c.nodes.count());
}
BENCHMARK(GhostNodeSearch)->Apply(grids);

void GhostNodeImages(benchmark::State& state)
{
    Ghosts c(state);
    for (auto _ : state) c.nodes.prescribe(c.s);
    count_items(state, c.nodes.count());
}
BENCHMARK(GhostNodeImages)->Apply(grids);

void GhostNodeValues(benchmark::State& state)
{
    Ghosts c(state);
    const VectorField u = velocity(c.g);
    c.nodes.prescribe(c.s);
    for (auto _ : state) c.nodes.evaluate(u[Location::u]);
    count_items(state, c.nodes.count());
}
BENCHMARK(GhostNodeValues)->Apply(grids);

} // namespace
} // namespace starling::benchmarks
