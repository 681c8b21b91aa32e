#include "flow/momentum.hpp"

#include "flow/diffusion_line.hpp"
#include "grid/boundary.hpp"
#include "grid/stencils.hpp"

namespace starling {

namespace {

/// The count of reals, rounded up to fill cache lines: threads do not share one.
Index whole_cache_lines(Index count) { return (count + 7) / 8 * 8; }

} // namespace

Momentum::Momentum(const Grid& g, const FluidParameters& p)
    : grid_(g), inv_reynolds_(1 / p.reynolds), theta_(p.theta), lines_(g.nx() + 1),
      line_z_(0, g.nz()),
      free_line_x_(g.nx() + 1), free_line_y_{EliminatedLine(g.ny()), EliminatedLine(g.ny()),
                                             EliminatedLine(g.ny())},
      chunk_is_free_(static_cast<std::size_t>(g.ny() * (g.nz() + 2) / XLines::chunk + 1)),
      plane_scratch_(
          whole_cache_lines(std::max(g.ny() * g.nz(), PeriodicLines::scratch_size(g.nz())))),
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

/// One component in one x-plane: the explicit terms, then the sweeps along y and z. It reads u^n
/// only, so the components may take turns.
template <Location C>
struct Momentum::InPlane {
    ExplicitTerms<C> terms;
    PrescribedNodes prescribed;
    Box box;
    DiffusionLine line_y;
    const EliminatedLine& free_line_y;
    const PeriodicLines& line_z;
    AdvectionAtEnd<C> inlet, outlet;

    void operator()(Index i, Real* scratch) const
    {
        if (i == box.end[0]) return;
        const Index first = prescribed.plane_begin[static_cast<std::size_t>(i)];
        const Index last = prescribed.plane_begin[static_cast<std::size_t>(i + 1)];
        add_explicit_terms(i);
        if (i == 0) add_advection_at(inlet);
        if (i + 1 == box.end[0]) add_advection_at(outlet);
        prescribe(first, last);
        solve_y(i, first == last, scratch);
        solve_z(i, scratch);
    }

private:
    void add_explicit_terms(Index i) const
    {
        const ExplicitTerms<C> plane_terms = terms; // local, so that the loop vectorises
        for (Index j = box.begin[1]; j < box.end[1]; ++j) {
            const Index row = plane_terms.rhs.offset(i, j, 0), nz = box.end[2];
#pragma omp simd
            for (Index k = 0; k < nz; ++k) plane_terms(row + k);
        }
    }
    void add_advection_at(const AdvectionAtEnd<C>& end) const
    {
        const Index i = end.inwards > 0 ? 0 : box.end[0] - 1;
        for (Index j = box.begin[1]; j < box.end[1]; ++j) {
            const Index row = terms.rhs.offset(i, j, 0);
            for (Index n = row; n < row + box.end[2]; ++n) {
                const Real N = end(n);
                terms.rhs.data[n] -= terms.dt * terms.weight * N;
                terms.N_before.data[n] += N;
            }
        }
    }
    void prescribe(Index first, Index last) const
    {
        for (Index m = first; m < last; ++m) {
            const auto e = static_cast<std::size_t>(m);
            const Index node = prescribed.node[e];
            terms.rhs.data[node] = prescribed.value[e] - terms.u.data[node];
        }
    }
    void solve_y(Index i, bool free, Real* scratch) const
    {
        const View<Real> rhs = terms.rhs;
        const std::uint8_t* mask = &prescribed.mask(i, box.begin[1], 0);
        const Index stride = prescribed.mask.stride_y, j_begin = box.begin[1], nz = box.end[2];
        if (free)
            free_line_y.solve(&rhs(i, j_begin, 0), rhs.stride_y, nz);
        else
            solve_lines(
                &rhs(i, j_begin, 0), rhs.stride_y, box.end[1] - j_begin, nz,
                [=, this](Index m) { return line_y.row(m, mask + m * stride); }, scratch);
    }
    void solve_z(Index i, Real* scratch) const
    {
        for (Index j = box.begin[1]; j < box.end[1]; j += PeriodicLines::block)
            line_z.solve(&terms.rhs(i, j, 0), &prescribed.mask(i, j, 0), terms.rhs.stride_y,
                         std::min(PeriodicLines::block, box.end[1] - j), scratch);
    }
};

template <Location C>
Momentum::InPlane<C> Momentum::in_plane(FluidState& s, VectorField& rhs,
                                        const PrescribedVelocity& prescribed, Real dt)
{
    const Real ratio = s.dt_before > 0 ? dt / s.dt_before : 0;
    const ExplicitTerms<C> terms{Advection<C>(grid_, s.u),
                                 Laplacian(grid_.spacing()),
                                 s.u[C].view(),
                                 s.P.view(),
                                 s.N_before[C].view(),
                                 rhs[C].view(),
                                 1 / spacing(grid_, axis(C)),
                                 inv_reynolds_,
                                 dt,
                                 1 + ratio / 2,
                                 ratio / 2};
    const DiffusionLine line_y = diffusion_line(grid_, C, 1, implicit(1, dt));
    EliminatedLine& free_line_y = free_line_y_[static_cast<std::size_t>(axis(C))];
    eliminate(line_y, free_line_y);
    return {terms,
            prescribed[static_cast<std::size_t>(axis(C))],
            grid_.unknowns(C),
            line_y,
            free_line_y,
            line_z_,
            {grid_, s.u, true},
            {grid_, s.u, false}};
}

void Momentum::solve_planes(FluidState& s, VectorField& rhs, const PrescribedVelocity& prescribed,
                            Real dt)
{
    line_z_.set(implicit(2, dt));
    const auto plane_of_u = in_plane<Location::u>(s, rhs, prescribed, dt);
    const auto plane_of_v = in_plane<Location::v>(s, rhs, prescribed, dt);
    const auto plane_of_w = in_plane<Location::w>(s, rhs, prescribed, dt);
    for_planes(0, grid_.nx() + 1, [=, this](Index i) {
        Real* scratch = scratch_.data() + plane_scratch_ * thread_number();
        plane_of_u(i, scratch);
        plane_of_v(i, scratch);
        plane_of_w(i, scratch);
    });
}

void Momentum::find_free_chunks(const PrescribedNodes& prescribed, Index first_column)
{
    const Index plane = prescribed.mask.stride_x;
    std::fill(chunk_is_free_.begin(), chunk_is_free_.end(), 1);
    for (Index node : prescribed.node)
        chunk_is_free_[static_cast<std::size_t>((node % plane - first_column) / XLines::chunk)] = 0;
}

/// The columns run through the halo values between the rows: these are solved along, and filled at
/// the end.
template <Location C>
void Momentum::x_solve_and_add(ScalarField& u_field, ScalarField& increment,
                               const PrescribedNodes& prescribed, Real dt)
{
    const Box box = grid_.unknowns(C);
    const DiffusionLine line = diffusion_line(grid_, C, 0, implicit(0, dt));
    eliminate(line, free_line_x_);
    const EliminatedLine* free_line = &free_line_x_;

    const Index stride = prescribed.mask.stride_x, planes = box.end[0];
    const Index first = prescribed.mask.offset(0, box.begin[1], 0);
    const Index columns = prescribed.mask.offset(0, box.end[1] - 1, grid_.nz()) - first;
    find_free_chunks(prescribed, first);
    const char* chunk_is_free = chunk_is_free_.data();
    Real *u_0 = u_field.view().data + first, *delta_0 = increment.view().data + first;
    const std::uint8_t* mask_0 = prescribed.mask.data + first;

    lines_.for_chunks(columns, [=](Index begin, Index width, Real* scratch) {
        Real *u = u_0 + begin, *delta = delta_0 + begin;
        const std::uint8_t* mask = mask_0 + begin;
        const auto clear = [=](Index i) { std::fill_n(delta + i * stride, width, Real{0}); };
        // the increments of a plane serve the plane before once more
        const auto add = [=](Index i) {
#pragma omp simd
            for (Index k = 0; k < width; ++k) u[i * stride + k] += delta[i * stride + k];
            if (i + 1 < planes) clear(i + 1);
            if (i == 0) clear(0);
        };
        if (chunk_is_free[begin / XLines::chunk])
            free_line->solve(delta, stride, width, add);
        else
            solve_lines(
                delta, stride, planes, width,
                [=](Index i) { return line.row(i, mask + i * stride); }, scratch, add);
    });
    fill_velocity_halo(grid_, C, u_field);
}

/// theta dt/(Re h^2) of one direction.
Real Momentum::implicit(int direction, Real dt) const
{
    const Real h = spacing(grid_, direction);
    return theta_ * dt * inv_reynolds_ / (h * h);
}

void Momentum::predict(FluidState& s, VectorField& rhs, const PrescribedVelocity& prescribed,
                       Real dt)
{
    using enum Location;
    solve_planes(s, rhs, prescribed, dt);
    x_solve_and_add<u>(s.u[u], rhs[u], prescribed[0], dt);
    x_solve_and_add<v>(s.u[v], rhs[v], prescribed[1], dt);
    x_solve_and_add<w>(s.u[w], rhs[w], prescribed[2], dt);
    s.dt_before = dt;
}

} // namespace starling
