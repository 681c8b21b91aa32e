#include "wall/high_pass.hpp"

#include <gtest/gtest.h>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

using enum HighPass::Beyond;

struct Waves : testing::TestWithParam<HighPass::Beyond> {
    Tube tube = make_tube(support::short_tube(), 0.1);
    HighPass high_pass{tube.mesh, tube.first(3), tube.first(23), GetParam()};

    /// Largest value left of d(ring, position in the ring), at rings `margin` off the range's ends.
    template <class F>
    Real left_of(F d, VertexIndex margin)
    {
        const VertexIndex first = high_pass.first(), n = tube.ring_size;
        for (VertexIndex v = first; v < high_pass.last(); ++v) {
            const Real a = d(v / n, v % n);
            high_pass.values()[v - first] = {a, -2 * a};
        }
        high_pass.apply();
        Real most = 0;
        for (VertexIndex v = first + margin * n; v < high_pass.last() - margin * n; ++v) {
            const Across& a = high_pass.values()[v - first];
            EXPECT_DOUBLE_EQ(a.z, -2 * a.y);
            most = std::max(most, std::abs(a.y));
        }
        return most;
    }
};

TEST_P(Waves, AConstantPassesOnlyWhereTheRangeEndsInZeros)
{
    const auto constant = [](auto, auto) { return 3.0; };
    EXPECT_LT(left_of(constant, 4), 1e-13);
    if (GetParam() == not_at_all)
        EXPECT_LT(left_of(constant, 0), 1e-13);
    else
        EXPECT_GT(left_of(constant, 0), 0.01);
}

TEST_P(Waves, ShortWavesPassAndLongOnesDoNot)
{
    const auto wave = [this](Real rings) {
        return left_of([=](VertexIndex r, auto) { return std::cos(2 * pi * r / rings); }, 4);
    };
    EXPECT_NEAR(wave(2), std::pow(8. / 9, 4), 1e-12); // (2/3)(1 - cos)/1.5 for rows
    EXPECT_LT(wave(8), 1e-3);
    const auto around = [](auto, VertexIndex t) { return t % 2 == 0 ? 1.0 : -1.0; };
    EXPECT_NEAR(left_of(around, 4), std::pow(8. / 9, 4), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(HighPass, Waves, testing::Values(as_zero, not_at_all));

} // namespace
} // namespace starling
