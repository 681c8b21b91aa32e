#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "simulation/simulation.hpp"

namespace starling {
namespace {

/// A ring of vertices of a frame.
struct Ring {
    Real inward_force = 0, pressure = 0;
    int vertices = 0;
};

const std::vector<Real>& values_of(const WallSnapshot& frame, const std::string& name)
{
    return std::ranges::find(frame.at_vertex, name, &NamedArray::name)->values;
}

std::map<Real, Ring> rings_of(const WallSnapshot& frame)
{
    const auto &force = values_of(frame, "support_force"),
               &pressure = values_of(frame, "transmural_pressure");
    std::map<Real, Ring> rings;
    for (std::size_t v = 0; v < frame.points.size(); ++v) {
        const Vec3& p = frame.points[v];
        Ring& ring = rings[p.x];
        ring.inward_force -=
            (force[3 * v + 1] * p.y + force[3 * v + 2] * p.z) / std::hypot(p.y, p.z);
        ring.pressure += pressure[v];
        ++ring.vertices;
    }
    return rings;
}

TEST(WallFrame, SupportForceCarriesThePressureOnTheRigidPartsAndNothingElse)
{
    Case c;
    c.grid.spacing = 0.25;
    c.tube.length = 6;
    c.tube.rigid_inlet = 2;
    c.tube.rigid_outlet = 1;
    c.drive.pressure_inlet = c.baseline_pressure_drop();
    Simulation simulation(c);
    for (int n = 0; n < 20; ++n) simulation.step();
    const std::map<Real, Ring> rings = rings_of(simulation.wall_snapshot());
    int compared = 0;
    for (auto ring = std::next(rings.begin()); std::next(ring) != rings.end(); ++ring) {
        const auto& [x, here] = *ring;
        if (x > 2 && x < 5) {
            EXPECT_EQ(here.inward_force, 0) << x;
        }
        if (x < 0.5 || x > 1.5) continue; // apart from the end and the clamp
        const Real width = (std::next(ring)->first - std::prev(ring)->first) / 2;
        const Real load = here.pressure / here.vertices * 2 * pi * width;
        EXPECT_NEAR(here.inward_force, load, 0.1 * load) << x;
        ++compared;
    }
    EXPECT_GT(compared, 3);
}

} // namespace
} // namespace starling
