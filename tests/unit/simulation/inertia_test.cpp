/// Stiff walls at finite Reynolds number, where inertia and not viscosity answers the wall.
#include <gtest/gtest.h>

#include "simulation/simulation.hpp"

namespace starling {
namespace {

Case stiff_tube(Real safety)
{
    Case c;
    c.fluid.reynolds = 30;
    c.tube = {.length = 6, .rigid_inlet = 1.18, .rigid_outlet = 0.6};
    c.material.eps = 0.002;
    c.grid.spacing = 0.25;
    c.time.safety = safety;
    c.drive.pressure_inlet = 1.5 * c.baseline_pressure_drop();
    return c;
}

// Forces of the rigid parts that only add up what passes made a swing that grew, the faster the
// shorter the step: a kinetic energy of 25 at t = 3.9, and of 2e4 at 1.3 with a quarter of the
// step.
TEST(Inertia, RigidPartsDoNotSwing)
{
    for (Real safety : {1.0, 0.5}) {
        Simulation simulation(stiff_tube(safety));
        while (simulation.time() < 4) simulation.step(4);
        const Sample s = simulation.sample();
        EXPECT_LT(s.kinetic_energy, 4) << safety; // 3.14
        EXPECT_NEAR(s.Q_in, 1.355, 0.03) << safety;
        EXPECT_LT(std::abs(s.leak), 0.02 * s.Q_in) << safety; // 0.4 %
    }
}

} // namespace
} // namespace starling
