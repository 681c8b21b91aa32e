/// Kernels of the wall; items are vertices.
#include "stage.hpp"
#include "wall/bending_force.hpp"
#include "wall/contact.hpp"
#include "wall/elastic_force.hpp"
#include "wall/mesh_filter.hpp"

namespace starling::benchmarks {
namespace {

void WallGeometry(benchmark::State& state)
{
    Wall w(grid_of(state));
    for (auto _ : state) w.geometry.update(w.state.x);
    count_items(state, w.vertices());
}
BENCHMARK(WallGeometry)->Apply(grids);

/// One law of each kind: with an energy, without.
template <class Law>
void Elastic(benchmark::State& state)
{
    Wall w(grid_of(state));
    ElasticForce elastic(w.tube, Law{1});
    Array<Vec3> f(w.vertices());
    for (auto _ : state) elastic.compute(w.state.x, f);
    count_items(state, w.vertices());
}
BENCHMARK(Elastic<Hooke>)->Apply(grids);
BENCHMARK(Elastic<NeoHookean>)->Apply(grids);

void BendingForce(benchmark::State& state)
{
    Wall w(grid_of(state));
    Bending bending(w.tube, 1);
    Array<Vec3> f(w.vertices());
    for (auto _ : state) bending.add(w.state.x, w.geometry, f);
    count_items(state, w.vertices());
}
BENCHMARK(BendingForce)->Apply(grids);

void ContactForce(benchmark::State& state)
{
    Wall w(grid_of(state));
    const Contact contact(w.tube, {.pressure = 1, .range = 0.2});
    Array<Vec3> f(w.vertices());
    for (auto _ : state) contact.add(w.state.x, w.geometry, f);
    count_items(state, w.vertices());
}
BENCHMARK(ContactForce)->Apply(grids);

void Filter(benchmark::State& state)
{
    Wall w(grid_of(state));
    MeshFilter filter(w.tube, 1);
    for (auto _ : state) filter.add_velocity(w.geometry, w.state, 1e-3);
    count_items(state, w.vertices());
}
BENCHMARK(Filter)->Apply(grids);

} // namespace
} // namespace starling::benchmarks
