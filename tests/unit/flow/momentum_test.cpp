#include "flow/momentum.hpp"

#include <gtest/gtest.h>

#include "grid/stencils.hpp"
#include "unit/flow/prescribed_nodes.hpp"

namespace starling {
namespace {

using support::largest;

Real spacing(const Grid& g, int d)
{
    return d == 0 ? g.spacing().x : d == 1 ? g.spacing().y : g.spacing().z;
}

/// Random velocity, pressure and past advection with valid halos.
FluidState random_state(const Grid& g, support::Random& random)
{
    FluidState s(g);
    s.u = support::random_velocity(g, random);
    support::randomise(g, Location::cell, s.P, random);
    fill_increment_halo(g, s.P);
    for (Location c : components) support::randomise(g, c, s.N_before[c], random);
    return s;
}

VectorField random_force(const Grid& g, support::Random& random)
{
    VectorField F(g);
    for (Location c : components) support::randomise(g, c, F[c], random);
    return F;
}

class MomentumStep : public testing::Test {
protected:
    Grid g{{9, 10, 7}, {0, 0, 0}, {1.8, 2.1, 1.3}};
    FluidParameters fluid{.reynolds = 2, .theta = 0.5};
    Real dt = 0.03;
    support::Random random;
    NothingPrescribed nothing{g};

    template <Location C>
    ScalarField advection(const VectorField& u) const
    {
        ScalarField N(g);
        const Advection<C> at(g, u);
        support::visit(g.unknowns(C), [&](Index i, Index j, Index k) {
            N(i, j, k) = at(u[C].view().offset(i, j, k));
        });
        return N;
    }
    VectorField advection(const VectorField& u) const
    {
        VectorField N(g);
        N[Location::u] = advection<Location::u>(u);
        N[Location::v] = advection<Location::v>(u);
        N[Location::w] = advection<Location::w>(u);
        for (Index end : {Index{0}, g.nx()}) add_advection_at(end, u, N);
        return N;
    }
    /// On the face less u div(u), and with u du/dx upwind where fluid leaves; what enters brings no
    /// v, w.
    void add_advection_at(Index end, const VectorField& velocity, VectorField& N) const
    {
        const ScalarField& u = velocity[Location::u];
        const Real h = g.spacing().x, outwards = end == 0 ? -1 : 1;
        const Index cell = end == 0 ? 0 : end - 1, inner = end == 0 ? 1 : end - 1;
        support::visit({{end, 0, 0}, {end + 1, g.ny(), g.nz()}}, [&](Index i, Index j, Index k) {
            const Real leaving = outwards * u(i, j, k), slope = (u(i, j, k) - u(inner, j, k)) / h;
            N[Location::u](i, j, k) += (leaving > 0 ? 2 : 1) * leaving * slope;
        });
        support::visit({{end, 1, 0}, {end + 1, g.ny(), g.nz()}}, [&](Index i, Index j, Index k) {
            const Real entering = -outwards * (u(i, j - 1, k) + u(i, j, k)) / 2;
            if (entering > 0)
                N[Location::v](cell, j, k) += entering * velocity[Location::v](cell, j, k) / h;
        });
        support::visit({{end, 0, 0}, {end + 1, g.ny(), g.nz()}}, [&](Index i, Index j, Index k) {
            const Real entering = -outwards * (u(i, j, k - 1) + u(i, j, k)) / 2;
            if (entering > 0)
                N[Location::w](cell, j, k) += entering * velocity[Location::w](cell, j, k) / h;
        });
    }
    /// (1 - theta dt/Re d^2/dx_d^2) f with the boundary conditions of component c.
    ScalarField implicit_operator(Location c, const ScalarField& f, int d) const
    {
        ScalarField filled = f, result(g);
        fill_velocity_halo(g, c, filled);
        const Real a = fluid.theta * dt / fluid.reynolds / (spacing(g, d) * spacing(g, d));
        const Index stride = f.view().stride(d);
        support::visit(g.unknowns(c), [&](Index i, Index j, Index k) {
            const Real* x = &filled(i, j, k);
            result(i, j, k) = x[0] - a * (x[-stride] - 2 * x[0] + x[stride]);
        });
        return result;
    }
    /// Largest residual of the factored equations of component c, with N at the half step.
    Real residual(Location c, const FluidState& before, const FluidState& after,
                  const VectorField& F, const VectorField& N_half) const
    {
        ScalarField left(g);
        const Box box = g.unknowns(c);
        support::visit(box, [&](Index i, Index j, Index k) {
            left(i, j, k) = after.u[c](i, j, k) - before.u[c](i, j, k);
        });
        for (int d : {0, 1, 2}) left = implicit_operator(c, left, d);
        const Laplacian laplacian(g.spacing());
        const View<const Real> u = before.u[c].view(), P = before.P.view();
        const Real h = spacing(g, axis(c));
        return largest(box, [&](Index i, Index j, Index k) {
            const Index n = u.offset(i, j, k);
            const Real gradient = (P.data[n] - P.data[n - P.stride(axis(c))]) / h;
            return left(i, j, k) - dt * (F[c](i, j, k) - gradient - N_half[c](i, j, k) +
                                         laplacian(u, n) / fluid.reynolds);
        });
    }
};

TEST_F(MomentumStep, FirstStepSolvesTheFactoredEquationsWithEulerAdvection)
{
    const FluidState before = random_state(g, random);
    const VectorField F = random_force(g, random);
    FluidState after = before;
    VectorField work = F;
    Momentum(g, fluid).predict(after, work, nothing.view(), dt);
    for (Location c : components)
        EXPECT_LT(residual(c, before, after, F, advection(before.u)), 1e-12) << axis(c);
}

TEST_F(MomentumStep, LeavesItsWorkSpaceZero)
{
    FluidState s = random_state(g, random);
    VectorField work = random_force(g, random);
    Momentum(g, fluid).predict(s, work, nothing.view(), dt);
    for (Location c : components)
        EXPECT_EQ(
            largest(g.unknowns(c), [&](Index i, Index j, Index k) { return work[c](i, j, k); }), 0)
            << axis(c);
}

TEST_F(MomentumStep, LaterStepsExtrapolateAdvectionToTheMiddleOfTheStep)
{
    FluidState before = random_state(g, random);
    before.dt_before = 0.05;
    const VectorField F = random_force(g, random), N = advection(before.u);
    FluidState after = before;
    VectorField work = F, N_half(g);
    Momentum(g, fluid).predict(after, work, nothing.view(), dt);
    const Real r = dt / before.dt_before / 2;
    for (Location c : components) {
        support::visit(g.unknowns(c), [&](Index i, Index j, Index k) {
            N_half[c](i, j, k) = (1 + r) * N[c](i, j, k) - r * before.N_before[c](i, j, k);
        });
        EXPECT_LT(residual(c, before, after, F, N_half), 1e-12) << axis(c);
    }
}

TEST_F(MomentumStep, RemembersAdvectionAndTimeStep)
{
    FluidState s = random_state(g, random);
    const VectorField N = advection(s.u);
    VectorField work(g);
    Momentum(g, fluid).predict(s, work, nothing.view(), dt);
    EXPECT_EQ(s.dt_before, dt);
    for (Location c : components)
        EXPECT_LT(
            largest(g.unknowns(c), [&](Index i, Index j,
                                       Index k) { return s.N_before[c](i, j, k) - N[c](i, j, k); }),
            1e-12);
}

TEST_F(MomentumStep, LeavesValidHalos)
{
    FluidState s = random_state(g, random);
    VectorField work = random_force(g, random);
    Momentum(g, fluid).predict(s, work, nothing.view(), dt);
    VectorField filled = s.u;
    fill_velocity_halo(g, filled);
    for (Location c : components)
        EXPECT_TRUE(std::ranges::equal(filled[c].values(), s.u[c].values())) << axis(c);
}

TEST_F(MomentumStep, FluidAtRestStaysAtRest)
{
    FluidState s(g);
    VectorField work(g);
    Momentum(g, fluid).predict(s, work, nothing.view(), dt);
    for (Location c : components) EXPECT_EQ(largest(g.unknowns(c), s.u[c].view()), 0);
}

TEST_F(MomentumStep, PrescribedNodesTakeTheirValue)
{
    fluid = {.reynolds = 0.1, .theta = 1}; // strongly implicit
    for (Real share : {0.02, 0.3, 1.}) {
        const support::RandomPrescribed prescribed(g, share, random);
        FluidState s = random_state(g, random);
        VectorField work = random_force(g, random);
        Momentum(g, fluid).predict(s, work, prescribed.view(), dt);
        for (Location c : components) {
            const PrescribedNodes nodes = prescribed.view()[static_cast<std::size_t>(axis(c))];
            ASSERT_FALSE(nodes.node.empty());
            for (std::size_t m = 0; m < nodes.node.size(); ++m)
                EXPECT_NEAR(s.u[c].view().data[nodes.node[m]], nodes.value[m], 1e-15);
        }
    }
}

TEST_F(MomentumStep, PrescribedNodesThatKeepTheirValueStopTheIncrementThere)
{
    // all neighbours of a node prescribed to stay: the node obeys its own scalar equation
    FluidState s = random_state(g, random);
    const FluidState before = s;
    const VectorField F = random_force(g, random);
    const Location c = Location::w;
    const std::array<Index, 3> centre{4, 5, 3};
    Field<std::uint8_t> mask(g);
    std::vector<Index> node, plane_begin{0};
    std::vector<Real> value;
    for (Index i = 0; i <= g.nx(); ++i) {
        const Box plane{{i, 0, 0}, {i + 1, g.ny(), g.nz()}};
        if (i < g.nx())
            support::visit(plane, [&](Index, Index j, Index k) {
                if (std::array{i, j, k} == centre) return;
                mask(i, j, k) = 1;
                node.push_back(mask.view().offset(i, j, k));
                value.push_back(s.u[c](i, j, k));
            });
        plane_begin.push_back(static_cast<Index>(node.size()));
    }
    PrescribedVelocity prescribed = nothing.view();
    prescribed[2] = {std::as_const(mask).view(), node, value, plane_begin};
    VectorField work = F;
    Momentum(g, fluid).predict(s, work, prescribed, dt);

    const auto [i, j, k] = centre;
    const Index n = before.u[c].view().offset(i, j, k);
    const View<const Real> P = before.P.view();
    Real factor = 1;
    for (int d : {0, 1, 2})
        factor *= 1 + 2 * fluid.theta * dt / fluid.reynolds / (spacing(g, d) * spacing(g, d));
    const Real rhs = F[c](i, j, k) - (P(i, j, k) - P(i, j, k - 1)) / g.spacing().z -
                     Advection<Location::w>(g, before.u)(n) +
                     Laplacian(g.spacing())(before.u[c].view(), n) / fluid.reynolds;
    EXPECT_NEAR(s.u[c](i, j, k) - before.u[c](i, j, k), dt * rhs / factor, 1e-13);
}

} // namespace
} // namespace starling
