/// Tubes that collapse until their walls meet.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "core/error.hpp"
#include "simulation/simulation.hpp"

namespace starling {
namespace {

/// A short tube that is pressed flat within some 200 steps.
Case flattened(Real contact)
{
    Case c;
    c.fluid.reynolds = 0.1;
    c.tube = {.length = 2 * pi, .rigid_inlet = 0.6, .rigid_outlet = 0.6};
    c.material.eps = 0.005;
    c.material.bending = 0.01;
    c.material.contact = contact;
    c.perturbation = {.amplitude = 0.2, .mode = 2};
    c.grid.spacing = 0.25;
    c.drive.pressure_outlet = -6 * c.baseline_pressure_drop();
    return c;
}

constexpr Real forever = std::numeric_limits<Real>::infinity();

TEST(Collapse, EndsCleanlyWhereOppositeWallsTouch)
{
    Simulation simulation(flattened(0));
    try {
        for (int n = 0; n < 600; ++n) simulation.step(forever);
        FAIL() << "the walls have not met";
    } catch (const NumericalError& e) {
        const std::string message = e.what();
        for (const char* words :
             {"opposite walls touch at x = ", "theta = ", "(vertex ", "wall.contact"})
            EXPECT_NE(message.find(words), std::string::npos) << message;
        EXPECT_FALSE(e.breakdown().shorter_step_helps);
        ASSERT_TRUE(e.breakdown().place.has_value());
        EXPECT_NEAR(e.breakdown().place->x, pi, 2); // of a tube of length 2 pi
    }
    simulation.back_to_good();
    const Sample s = simulation.sample();
    EXPECT_EQ(s.lobes, 2);
    EXPECT_GT(s.smallest_gap, 0.25 * simulation.spacing());
    EXPECT_LT(s.min_area_ratio, 0.4);
}

TEST(Collapse, GoesOnWhereARepulsionKeepsTheWallsApart)
{
    Simulation simulation(flattened(3));
    for (int n = 0; n < 600; ++n) simulation.step(forever);
    const Sample s = simulation.sample();
    EXPECT_EQ(s.lobes, 2);
    EXPECT_GT(s.smallest_gap, 0.25 * simulation.spacing());
    EXPECT_LT(s.smallest_gap, 2 * simulation.spacing());
}

} // namespace
} // namespace starling
