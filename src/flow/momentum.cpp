#include "flow/momentum.hpp"

#include "flow/diffusion_line.hpp"
#include "grid/boundary.hpp"
#include "grid/stencils.hpp"

namespace starling {

Momentum::Momentum(const Grid& g, const FluidParameters& p)
    : grid_(g), inv_reynolds_(1 / p.reynolds), theta_(p.theta), lines_(g.nx() + 1, g.nz()),
      line_z_(0, g.nz()), free_line_x_(g.nx() + 1), free_line_y_(g.ny()),
      row_is_free_(static_cast<std::size_t>(g.ny())),
      plane_scratch_(std::max(g.ny() * g.nz(), PeriodicLines::scratch_size(g.nz()))),
      scratch_(plane_scratch_ * max_threads())
{
}

namespace {

/// dt [ F - grad P - N + Lap u / Re ] at the nodes of one plane, Adams-Bashforth for N. (36)
template <Location C>
struct ExplicitTerms {
    Advection<C> advection;
    Laplacian laplacian;
    View<const Real> u, P;
    View<Real> N_before, rhs;
    Real inv_h = 0, inv_reynolds = 0, dt = 0, weight = 0, weight_before = 0;

    void operator()(Index n) const
    {
        const Real N = advection(n);
        const Real gradient = (P.data[n] - P.data[n - P.stride(axis(C))]) * inv_h;
        const Real N_half = weight * N - weight_before * N_before.data[n];
        rhs.data[n] = dt * (rhs.data[n] - gradient - N_half + inv_reynolds * laplacian(u, n));
        N_before.data[n] = N;
    }
};

Real spacing(const Grid& g, int direction)
{
    return direction == 0 ? g.spacing().x : direction == 1 ? g.spacing().y : g.spacing().z;
}

} // namespace

template <Location C>
void Momentum::explicit_terms_and_plane_solves(FluidState& s, ScalarField& rhs_field,
                                               const PrescribedNodes& prescribed, Real dt)
{
    const Box box = grid_.unknowns(C);
    const Real ratio = s.dt_before > 0 ? dt / s.dt_before : 0;
    const View<Real> rhs = rhs_field.view();
    const View<const Real> u = s.u[C].view();
    const ExplicitTerms<C> terms{Advection<C>(grid_, s.u),
                                 Laplacian(grid_.spacing()),
                                 u,
                                 s.P.view(),
                                 s.N_before[C].view(),
                                 rhs,
                                 1 / spacing(grid_, axis(C)),
                                 inv_reynolds_,
                                 dt,
                                 1 + ratio / 2,
                                 ratio / 2};
    const auto implicit = [&](int d) {
        const Real h = spacing(grid_, d);
        return theta_ * dt * inv_reynolds_ / (h * h);
    };
    const DiffusionLine line_y = diffusion_line(grid_, C, 1, implicit(1));
    line_z_.set(implicit(2));
    const std::uint8_t free = 0;
    free_line_y_.set(line_y.last + 1, [&](Index m) { return line_y.row(m, &free)(0); });
    const PeriodicLines* line_z = &line_z_;
    const EliminatedLine* free_line_y = &free_line_y_;
    const View<const std::uint8_t> mask = prescribed.mask;
    const Index j_begin = box.begin[1], j_end = box.end[1], nz = grid_.nz();
    Real* all_scratch = scratch_.data();
    const Index scratch_size = plane_scratch_;

    for_range(box.begin[0], box.end[0], [=](Index i) {
        Real* scratch = all_scratch + scratch_size * thread_number();
        const ExplicitTerms<C> plane_terms = terms; // local, so that the loop vectorises
        for (Index j = j_begin; j < j_end; ++j) {
            const Index row = rhs.offset(i, j, 0);
#pragma omp simd
            for (Index k = 0; k < nz; ++k) plane_terms(row + k);
        }
        const Index first = prescribed.plane_begin[static_cast<std::size_t>(i)];
        const Index last = prescribed.plane_begin[static_cast<std::size_t>(i + 1)];
        for (Index m = first; m < last; ++m) {
            const auto e = static_cast<std::size_t>(m);
            rhs.data[prescribed.node[e]] = prescribed.value[e] - u.data[prescribed.node[e]];
        }
        const std::uint8_t* plane_mask = &mask(i, j_begin, 0);
        const Index mask_stride = mask.stride_y;
        if (first == last)
            free_line_y->solve(&rhs(i, j_begin, 0), rhs.stride_y, nz);
        else
            solve_lines(
                &rhs(i, j_begin, 0), rhs.stride_y, j_end - j_begin, nz,
                [=](Index m) { return line_y.row(m, plane_mask + m * mask_stride); }, scratch);
        for (Index j = j_begin; j < j_end; j += PeriodicLines::block)
            line_z->solve(&rhs(i, j, 0), &mask(i, j, 0), rhs.stride_y,
                          std::min(PeriodicLines::block, j_end - j), scratch);
    });
}

void Momentum::find_free_rows(const PrescribedNodes& prescribed)
{
    const View<const std::uint8_t> mask = prescribed.mask;
    std::fill(row_is_free_.begin(), row_is_free_.end(), 1);
    for (Index node : prescribed.node)
        row_is_free_[static_cast<std::size_t>(node % mask.stride_x / mask.stride_y)] = 0;
}

template <Location C>
void Momentum::x_solve_and_add(ScalarField& u_field, ScalarField& increment,
                               const PrescribedNodes& prescribed, Real dt)
{
    const Box box = grid_.unknowns(C);
    const Real h = grid_.spacing().x;
    const DiffusionLine line = diffusion_line(grid_, C, 0, theta_ * dt * inv_reynolds_ / (h * h));
    const View<const std::uint8_t> mask = prescribed.mask;
    const View<Real> delta = increment.view(), u = u_field.view();
    const std::uint8_t free = 0;
    free_line_x_.set(box.end[0], [&](Index m) { return line.row(m, &free)(0); });
    find_free_rows(prescribed);
    const EliminatedLine* free_line = &free_line_x_;
    const char* row_is_free = row_is_free_.data();
    const Index planes = box.end[0], nz = grid_.nz();
    lines_.for_rows({box.begin[1], box.end[1]}, [=](Index j, Real* scratch) {
        if (row_is_free[j])
            free_line->solve(&delta(0, j, 0), delta.stride_x, nz);
        else
            solve_lines(
                &delta(0, j, 0), delta.stride_x, planes, nz,
                [=](Index i) { return line.row(i, &mask(i, j, 0)); }, scratch);
        for (Index i = 0; i < planes; ++i) {
            Real* u_row = &u(i, j, 0);
            const Real* delta_row = &delta(i, j, 0);
#pragma omp simd
            for (Index k = 0; k < nz; ++k) u_row[k] += delta_row[k];
        }
    });
    fill_velocity_halo(grid_, C, u_field);
}

void Momentum::predict(FluidState& s, VectorField& rhs, const PrescribedVelocity& prescribed,
                       Real dt)
{
    using enum Location;
    explicit_terms_and_plane_solves<u>(s, rhs[u], prescribed[0], dt);
    explicit_terms_and_plane_solves<v>(s, rhs[v], prescribed[1], dt);
    explicit_terms_and_plane_solves<w>(s, rhs[w], prescribed[2], dt);
    x_solve_and_add<u>(s.u[u], rhs[u], prescribed[0], dt);
    x_solve_and_add<v>(s.u[v], rhs[v], prescribed[1], dt);
    x_solve_and_add<w>(s.u[w], rhs[w], prescribed[2], dt);
    s.dt_before = dt;
}

} // namespace starling
