/// What is said of states that are not sound: each fault is put into a sound state by hand.
#include <gtest/gtest.h>

#include <limits>

#include "core/error.hpp"
#include "simulation/soundness.hpp"

namespace starling {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

/// A short round tube at rest.
struct Example {
    Case description;
    Grid grid;
    Tube tube;
    State state;
    std::vector<TimeStepLimit> limits;
    Soundness soundness;

    Example()
        : description(short_tube()), grid(make_grid(description.grid, description.tube.length)),
          tube(make_tube(description.tube, 0.65 * grid.delta())), state(grid, tube),
          limits(time_step_limits(description, grid.delta(), 1)),
          soundness(description, grid, tube, state, limits)
    {
        state.fluid.dt_before = smallest(limits).dt;
    }
    static Case short_tube()
    {
        Case c;
        c.tube = {.length = 4, .rigid_inlet = 0.8, .rigid_outlet = 0.8};
        c.grid.spacing = 0.3;
        return c;
    }
    /// A vertex about half way.
    VertexIndex middle() const { return tube.first(tube.rings() / 2) + 3; }
    /// What a check throws.
    template <class Check>
    NumericalError error_of(Check check) const
    {
        try {
            check(soundness);
        } catch (const NumericalError& e) {
            return e;
        }
        return {"no error", ""};
    }
};

void expect_words(const NumericalError& e, std::initializer_list<std::string> words)
{
    const std::string message = e.what();
    for (const std::string& word : words)
        EXPECT_NE(message.find(word), std::string::npos) << "not '" << word << "' in " << message;
}

void check_step(const Soundness& s) { s.check_step(); }
void check_folds(const Soundness& s) { s.check_folds(); }
void report_lost_wall(const Soundness& s) { s.report_lost_wall(); }

TEST(Soundness, OfATubeAtRestIsComplete)
{
    const Example e;
    EXPECT_NO_THROW(e.soundness.check_step());
    EXPECT_NO_THROW(e.soundness.check_folds());
    EXPECT_NO_THROW(e.soundness.check_gaps());
    EXPECT_NO_THROW(e.soundness.check_flow({0.1, 1}));
}

TEST(Soundness, NamesWhereTheFlowWasWildestBeforeItWasNotFinite)
{
    Example e;
    e.state.fluid.N_before[Location::v](4, 5, 6) = -1e200;
    e.state.fluid.P.fill(nan);
    const NumericalError error = e.error_of(check_step);
    expect_words(error, {"not finite", "(cell 4, 5, 6)", "theta = ", "term: ", "time.safety=0.5"});
    EXPECT_EQ(error.breakdown().place, e.grid.position(Location::v, 4, 5, 6));
    EXPECT_TRUE(error.breakdown().shorter_step_helps);
}

TEST(Soundness, NamesTheVertexThatMovesTooFar)
{
    Example e;
    const VertexIndex v = e.middle();
    e.state.wall.velocity[v] = {0, 1.5 * e.grid.delta() / e.state.fluid.dt_before, 0};
    const NumericalError error = e.error_of(check_step);
    expect_words(error, {"moved by 1.5 grid spacings", "(vertex " + std::to_string(v) + ")",
                         "theta = ", "term: "});
    EXPECT_EQ(error.breakdown().place, e.state.wall.x[v]);
    EXPECT_TRUE(error.breakdown().shorter_step_helps);
}

TEST(Soundness, StopsAFlowFarOverTheLimitOfAdvectionOnly)
{
    Example e;
    const Real u = e.state.fluid.u[Location::u](7, 3, 2) = 500;
    const auto check = [&](const Soundness& s) {
        s.check_flow({e.state.fluid.dt_before * u / e.grid.spacing().x, u});
    };
    // Fast as it is, the limit is CFL 0.2.
    e.state.fluid.dt_before = 3.9 * 0.2 * e.grid.delta() / u; // CFL 0.78
    expect_words(e.error_of(check), {"no error"});
    e.state.fluid.dt_before = 3 * e.grid.spacing().x / u;
    const NumericalError error = e.error_of(check);
    expect_words(error,
                 {"advection is unstable", "(cell 7, 3, 2)", "runs through 3 grid spacings"});
    EXPECT_TRUE(error.breakdown().shorter_step_helps);
}

TEST(Soundness, FindsAnElementThatIsFoldedOver)
{
    Example e;
    const auto& corners = e.tube.mesh.element(e.tube.mesh.element_count() / 2);
    // Its corner goes past the opposite side, within the plane that touches the tube there.
    Vec3& a = e.state.wall.x[corners[0]];
    const Vec3 b = e.state.wall.x[corners[1]], c = e.state.wall.x[corners[2]];
    a += 2.5 * (0.5 * (b + c) - a);
    const NumericalError error = e.error_of(check_folds);
    expect_words(error, {"is inverted", "(vertex ", "theta = ", "term: ", "wall.bending"});
    EXPECT_TRUE(error.breakdown().shorter_step_helps);
}

TEST(Soundness, WallAtTheSideOfTheBoxIsNotBlamedOnTheStep)
{
    Example e;
    for (VertexIndex v = e.tube.moving_begin(); v < e.tube.moving_end(); ++v)
        e.state.wall.x[v].y *= 2.2;
    const NumericalError error = e.error_of(report_lost_wall);
    expect_words(error, {"side of the box", "theta = ", "grid.width_y"});
    EXPECT_FALSE(error.breakdown().shorter_step_helps);
}

TEST(Soundness, SearchThatDoesNotCloseIsNamed)
{
    const Example e;
    const NumericalError error = e.error_of(report_lost_wall);
    expect_words(error, {"does not close", "(vertex ", "a finer grid"});
    EXPECT_TRUE(error.breakdown().place.has_value());
}

} // namespace
} // namespace starling
