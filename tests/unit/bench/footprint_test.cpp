/// Not built with sanitizers: their malloc does not say what it has given.
#include <gtest/gtest.h>

#include "bench/stepped_problem.hpp"

namespace starling::bench {
namespace {

// The fluid keeps at least u, P, N, F, phi and its transform.
TEST(Footprint, IsNotLessThanTheFieldsAndWithinWhatIsExpected)
{
    const Problem fluid{{48, 36, 36}}, coupled{{48, 36, 36}, 2000};
    const double cells = static_cast<double>(fluid.cell_count());
    const Footprint without = build(fluid).footprint, with = build(coupled).footprint;
    EXPECT_GT(without.bytes_per_cell, 12 * 8);
    EXPECT_EQ(without.bytes_per_vertex, 0);
    EXPECT_LT(static_cast<double>(without.bytes), expected_bytes(fluid));
    EXPECT_GT(with.bytes_per_cell, without.bytes_per_cell);
    EXPECT_GT(with.bytes_per_vertex, 6 * 24); // positions, velocities, forces, areas
    EXPECT_LT(static_cast<double>(with.bytes), expected_bytes(coupled));
    EXPECT_NEAR(cells * with.bytes_per_cell, static_cast<double>(with.bytes),
                0.2 * static_cast<double>(with.bytes));
}

} // namespace
} // namespace starling::bench
