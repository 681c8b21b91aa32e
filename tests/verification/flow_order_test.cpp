/// Measured orders of accuracy of the whole fluid step on a manufactured flow.
#include <gtest/gtest.h>

#include "flow/momentum.hpp"
#include "flow/projection.hpp"
#include "grid/boundary.hpp"
#include "unit/grid/random_fields.hpp"
#include "verification/manufactured_flow.hpp"

namespace starling {
namespace {

using support::ManufacturedFlow;
using support::ManufacturedForce;
using support::visit;

/// What is compared.
struct Result {
    VectorField u;
    ScalarField P;
};

/// The manufactured flow itself: velocity at time t, pressure at time t_pressure. Valid halos.
Result exact(const ManufacturedFlow& flow, const Grid& g, Real t, Real t_pressure)
{
    Result r{VectorField(g), ScalarField(g)};
    for (Location c : components)
        visit(g.unknowns(c), [&](Index i, Index j, Index k) {
            r.u[c](i, j, k) = flow.T(t) * flow.U(c, g.position(c, i, j, k));
        });
    visit(g.unknowns(Location::cell), [&](Index i, Index j, Index k) {
        r.P(i, j, k) = flow.S(t_pressure) * flow.Q(g.position(Location::cell, i, j, k));
    });
    fill_velocity_halo(g, r.u);
    fill_increment_halo(g, r.P);
    return r;
}

/// Runs the fluid step from the exact state at t = 0.
///
/// The force acts at the time the scheme is centred on, t + theta dt. With theta = 1/2 the pressure
/// of a step belongs to its middle too; the result extrapolates it to the end of the last step.
Result run(const ManufacturedFlow& flow, const Grid& g, Real theta, Real t_end, Index steps)
{
    const Real dt = t_end / static_cast<Real>(steps);
    const FluidParameters fluid{flow.reynolds, theta};
    const ManufacturedForce force(flow, g);
    const NothingPrescribed nothing(g);
    Momentum momentum(g, fluid);
    Projection projection(g, fluid, {});
    FluidState s(g);
    VectorField rhs(g);
    ScalarField P_before(g);
    const Result initial = exact(flow, g, 0, (theta - 1) * dt);
    s.u = initial.u;
    projection.project(s, 0, dt); // or the first pressure increment would be O(h^2/dt)
    s.P = initial.P;
    for (Index n = 0; n < steps; ++n) {
        P_before = s.P;
        force.evaluate((static_cast<Real>(n) + theta) * dt, rhs);
        momentum.predict(s, rhs, nothing.view(), dt);
        projection.project(s, 0, dt);
    }
    visit(g.unknowns(Location::cell), [&](Index i, Index j, Index k) {
        P_before(i, j, k) = s.P(i, j, k) + (1 - theta) * (s.P(i, j, k) - P_before(i, j, k));
    });
    return {s.u, P_before};
}

/// Root mean square and largest difference.
struct Errors {
    Real velocity, velocity_largest, pressure, pressure_largest;
};

Errors difference(const Grid& g, const Result& a, const Result& b)
{
    Errors e{};
    Real count = 0;
    const auto add = [](Real d, Real& sum, Real& most) {
        sum += d * d;
        most = std::max(most, std::abs(d));
    };
    for (Location c : components)
        visit(g.unknowns(c), [&](Index i, Index j, Index k) {
            add(a.u[c](i, j, k) - b.u[c](i, j, k), e.velocity, e.velocity_largest);
            ++count;
        });
    visit(g.unknowns(Location::cell), [&](Index i, Index j, Index k) {
        add(a.P(i, j, k) - b.P(i, j, k), e.pressure, e.pressure_largest);
    });
    e.velocity = std::sqrt(e.velocity / count);
    e.pressure = std::sqrt(e.pressure / static_cast<Real>(g.cell_count()));
    return e;
}

void report(const char* what, const Errors& e)
{
    std::printf("  %-28s u rms %9.3e max %9.3e   P rms %9.3e max %9.3e\n", what, e.velocity,
                e.velocity_largest, e.pressure, e.pressure_largest);
}

Errors orders(const Errors& coarse, const Errors& fine, Real factor)
{
    const auto order = [=](Real a, Real b) { return std::log(a / b) / std::log(factor); };
    const Errors result{order(coarse.velocity, fine.velocity),
                        order(coarse.velocity_largest, fine.velocity_largest),
                        order(coarse.pressure, fine.pressure),
                        order(coarse.pressure_largest, fine.pressure_largest)};
    report("order", result);
    return result;
}

/// Orders in dt on a fixed grid: differences from a run with a much smaller step.
Errors time_orders(Real theta, Index reference_steps)
{
    const ManufacturedFlow flow;
    const Grid g = flow.grid({12, 10, 12});
    const Real t_end = 0.4;
    const Result reference = run(flow, g, theta, t_end, reference_steps);
    const Errors coarse = difference(g, run(flow, g, theta, t_end, 40), reference);
    const Errors fine = difference(g, run(flow, g, theta, t_end, 80), reference);
    report("dt = 0.01", coarse);
    report("dt = 0.005", fine);
    return orders(coarse, fine, 2);
}

TEST(FlowOrder, IsSecondInTimeForThetaOneHalf)
{
    const Errors order = time_orders(0.5, 1280);
    EXPECT_NEAR(order.velocity, 2, 0.1);
    EXPECT_NEAR(order.velocity_largest, 2, 0.15);
}

TEST(FlowOrder, IsFirstInTimeForThetaOne)
{
    const Errors order = time_orders(1, 5120);
    EXPECT_NEAR(order.velocity, 1, 0.1);
}

/// Error of a run on n cells per direction.
Errors error_on(Index n, Index steps)
{
    const ManufacturedFlow flow;
    const Grid g = flow.grid({n, n, n});
    const Real t_end = 0.4;
    const Errors e = difference(g, run(flow, g, 0.5, t_end, steps), exact(flow, g, t_end, t_end));
    report(("n = " + std::to_string(n) + ", " + std::to_string(steps) + " steps").c_str(), e);
    return e;
}

TEST(FlowOrder, IsSecondInSpaceAndTimeTogether)
{
    const Errors order = orders(error_on(16, 32), error_on(32, 64), 2);
    EXPECT_NEAR(order.velocity, 2, 0.15);
}

TEST(FlowOrder, IsSecondInSpaceAtASmallTimeStep)
{
    const Errors order = orders(error_on(12, 120), error_on(24, 120), 2);
    EXPECT_NEAR(order.velocity, 2, 0.15);
}

TEST(FlowSteadyState, DoesNotDependOnTheTimeStepNorOnTheta)
{
    const ManufacturedFlow flow(4, true);
    const Grid g = flow.grid({10, 8, 8});
    const auto steady = [&](Real theta, Real dt) {
        return run(flow, g, theta, 25, std::llround(25 / dt));
    };
    const Result reference = steady(0.5, 0.025);
    for (const auto& [theta, dt] :
         {std::pair{0.5, 0.05}, std::pair{1., 0.025}, std::pair{1., 0.1}}) {
        const Errors e = difference(g, steady(theta, dt), reference);
        report("steady", e);
        EXPECT_LT(e.velocity_largest, 1e-8) << theta << ' ' << dt;
        EXPECT_LT(e.pressure_largest, 1e-8) << theta << ' ' << dt;
    }
    const Real speed = support::largest(g.unknowns(Location::u), reference.u[Location::u].view());
    EXPECT_GT(speed, 1);
}

} // namespace
} // namespace starling
