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

/// Largest less smallest volume in the oscillation that follows the start of the drive.
Real swing(Real viscosity, const TissueParameters& tissue)
{
    Case c;
    c.fluid.reynolds = 50;
    c.tube = {.length = 6, .rigid_inlet = 1, .rigid_outlet = 1};
    c.material.eps = 0.01;
    c.material.viscosity = viscosity;
    c.material.support = tissue;
    c.grid.spacing = 0.3;
    c.drive.pressure_inlet = 0.5 * c.baseline_pressure_drop();
    Simulation simulation(c);
    Real low = 100, high = 0;
    while (simulation.time() < 10) {
        simulation.step();
        if (simulation.time() < 4) continue;
        const Real volume = simulation.sample().volume;
        low = std::min(low, volume);
        high = std::max(high, volume);
    }
    return high - low;
}

TEST(Inertia, ViscosityOfTheWallAndOfTheTissueDampTheOscillation)
{
    const Real elastic = swing(0, {});
    EXPECT_GT(elastic, 0.1);
    EXPECT_LT(swing(0.4, {}), 0.8 * elastic);
    EXPECT_LT(swing(0, {.damping = 2}), 0.8 * elastic);
}

} // namespace
} // namespace starling
