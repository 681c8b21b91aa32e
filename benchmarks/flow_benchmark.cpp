/// Kernels of the fluid.
#include "flow/momentum.hpp"
#include "flow/periodic_lines.hpp"
#include "flow/projection.hpp"
#include "grid/stencils.hpp"
#include "stage.hpp"

namespace starling::benchmarks {
namespace {

constexpr Real implicit = 2.5; ///< theta dt/(Re h^2) of the lines

template <Location C>
void AdvectionAndDiffusion(benchmark::State& state)
{
    const Grid g = grid_of(state);
    const VectorField u = velocity(g);
    ScalarField out(g);
    const Advection<C> advection(g, u);
    const Laplacian laplacian(g.spacing());
    const View<const Real> c = u[C].view();
    const View<Real> result = out.view();
    for (auto _ : state)
        for_each(g.unknowns(C), [=](Index i, Index j, Index k) {
            const Index n = c.offset(i, j, k);
            result.data[n] = laplacian(c, n) - advection(n);
        });
    count_items(state, g.cell_count());
}
BENCHMARK(AdvectionAndDiffusion<Location::u>)->Apply(grids);
BENCHMARK(AdvectionAndDiffusion<Location::v>)->Apply(grids);
BENCHMARK(AdvectionAndDiffusion<Location::w>)->Apply(grids);

void Divergence(benchmark::State& state)
{
    const Grid g = grid_of(state);
    const VectorField u = velocity(g);
    ScalarField out(g);
    const DivergenceAtCell divergence(g, u);
    const View<Real> result = out.view();
    for (auto _ : state)
        for_each(g.unknowns(Location::cell),
                 [=](Index i, Index j, Index k) { result(i, j, k) = divergence(i, j, k); });
    count_items(state, g.cell_count());
}
BENCHMARK(Divergence)->Apply(grids);

void VelocityHalo(benchmark::State& state)
{
    const Grid g = grid_of(state);
    VectorField u = velocity(g);
    for (auto _ : state) fill_velocity_halo(g, u);
    count_items(state, g.cell_count());
}
BENCHMARK(VelocityHalo)->Apply(grids);

/// Lines along z, plane by plane; with a prescribed node in every row if `masked`.
template <bool masked>
void LinesAlongZ(benchmark::State& state)
{
    const Grid g = grid_of(state);
    ScalarField field(g);
    fill_waves(g, Location::cell, field);
    Field<std::uint8_t> mask(g);
    if (masked)
        for (Index j = 0; j < g.ny(); ++j) mask(0, j, g.nz() / 2) = 1;
    const PeriodicLines lines(implicit, g.nz());
    Array<Real> scratch(PeriodicLines::scratch_size(g.nz()) * max_threads());
    const View<Real> f = field.view();
    for (auto _ : state)
        for_planes(0, g.nx(), [&](Index i) {
            Real* own = scratch.data() + PeriodicLines::scratch_size(g.nz()) * thread_number();
            for (Index j = 0; j < g.ny(); j += PeriodicLines::block)
                lines.solve(&f(i, j, 0), &mask(0, j, 0), f.stride_y,
                            std::min(PeriodicLines::block, g.ny() - j), own);
        });
    count_items(state, g.cell_count());
}
BENCHMARK(LinesAlongZ<false>)->Apply(grids);
BENCHMARK(LinesAlongZ<true>)->Apply(grids);

TridiagonalRow diffusion_row(Index) { return {-implicit, 1 + 2 * implicit, -implicit}; }

void LinesAlongY(benchmark::State& state)
{
    const Grid g = grid_of(state);
    ScalarField field(g);
    fill_waves(g, Location::cell, field);
    EliminatedLine line(g.ny());
    line.set(g.ny(), diffusion_row);
    const View<Real> f = field.view();
    for (auto _ : state)
        for_planes(0, g.nx(), [&](Index i) { line.solve(&f(i, 0, 0), f.stride_y, g.nz()); });
    count_items(state, g.cell_count());
}
BENCHMARK(LinesAlongY)->Apply(grids);

/// Lines along x in chunks that stay in cache.
void LinesAlongX(benchmark::State& state)
{
    const Grid g = grid_of(state);
    ScalarField field(g);
    fill_waves(g, Location::cell, field);
    EliminatedLine line(g.nx());
    line.set(g.nx(), diffusion_row);
    XLines lines(g.nx());
    const View<Real> f = field.view();
    const Index columns = f.offset(0, g.ny() - 1, g.nz());
    for (auto _ : state)
        lines.for_chunks(columns, [&](Index begin, Index width, Real*) {
            line.solve(f.data + begin, f.stride_x, width);
        });
    count_items(state, g.cell_count());
}
BENCHMARK(LinesAlongX)->Apply(grids);

/// Tridiagonal systems along x of the Poisson solver: another matrix in every column.
void TridiagonalsAlongX(benchmark::State& state)
{
    const Grid g = grid_of(state);
    const Index plane = g.ny() * g.nz();
    Array<Real> values(g.nx() * plane);
    values.fill(1);
    Array<Real> diagonal(plane);
    for (Index m = 0; m < plane; ++m) diagonal[m] = -2 - 0.01 * static_cast<Real>(m % 97);
    XLines lines(g.nx());
    const Real* d = diagonal.data();
    for (auto _ : state)
        lines.solve(values.data(), plane, g.nx(), plane, [=](Index, Index column) {
            return [=](Index k) { return TridiagonalRow{1, d[column + k], 1}; };
        });
    count_items(state, g.cell_count());
}
BENCHMARK(TridiagonalsAlongX)->Apply(grids);

/// Forward and backward, in one plane as often as the grid has planes.
void CosineForwardAndBackward(benchmark::State& state)
{
    const Grid g = grid_of(state);
    const CosineTransform cosine(g.ny(), g.nz() / 2);
    const Index nz = g.nz();
    Array<Real> x(g.ny() * nz), X(g.ny() * nz), work(g.ny() * nz);
    for (Index m = 0; m < x.size(); ++m) x[m] = wave(m, 0, 0);
    for (auto _ : state)
        for (Index i = 0; i < g.nx(); ++i) {
            cosine.forward(x.data(), work.data(), X.data());
            cosine.backward(X.data(), work.data(), x.data());
        }
    count_items(state, g.cell_count());
}
BENCHMARK(CosineForwardAndBackward)->Apply(grids);

void PoissonSolve(benchmark::State& state)
{
    const Grid g = grid_of(state);
    ScalarField rhs(g), phi(g);
    fill_waves(g, Location::cell, rhs);
    Poisson poisson(g);
    const View<const Real> f = rhs.view();
    for (auto _ : state) poisson.solve([=](Index i, Index j, Index k) { return f(i, j, k); }, phi);
    count_items(state, g.cell_count());
}
BENCHMARK(PoissonSolve)->Apply(grids);

void MomentumStep(benchmark::State& state)
{
    const Grid g = grid_of(state);
    FluidState s(g);
    VectorField F(g);
    Momentum momentum(g, {});
    const NothingPrescribed nothing(g);
    for (auto _ : state) momentum.predict(s, F, nothing.view(), 1e-3);
    count_items(state, g.cell_count());
}
BENCHMARK(MomentumStep)->Apply(grids);

void PressureStep(benchmark::State& state)
{
    const Grid g = grid_of(state);
    FluidState s(g);
    s.u = velocity(g);
    Projection projection(g, {}, {});
    for (auto _ : state) projection.project(s, 0, 1e-3);
    count_items(state, g.cell_count());
}
BENCHMARK(PressureStep)->Apply(grids);

} // namespace
} // namespace starling::benchmarks
