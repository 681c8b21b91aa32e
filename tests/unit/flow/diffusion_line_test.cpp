#include "flow/diffusion_line.hpp"

#include <gtest/gtest.h>

#include "unit/grid/random_fields.hpp"

namespace starling {
namespace {

class DiffusionLineOf : public testing::TestWithParam<Location> {
protected:
    Grid g{{6, 5, 4}, {0, 0, 0}, {1, 1, 1}};
    support::Random random;
};

TEST_P(DiffusionLineOf, RowsEqualTheExplicitOperatorWithItsHalos)
{
    const Location c = GetParam();
    ScalarField f(g);
    support::randomise(g, c, f, random);
    fill_velocity_halo(g, c, f);
    const Box box = g.unknowns(c);
    const View<const Real> view = std::as_const(f).view();
    constexpr Real a = 0.7;
    for (int direction : {0, 1}) {
        const DiffusionLine line = diffusion_line(g, c, direction, a);
        const Index stride = view.stride(direction);
        const auto d = static_cast<std::size_t>(direction);
        EXPECT_EQ(line.last, box.end[d] - box.begin[d] - 1);
        support::visit(box, [&](Index i, Index j, Index k) {
            const Index m = direction == 0 ? i : j - box.begin[1];
            const std::uint8_t free = 0;
            const TridiagonalRow r = line.row(m, &free)(0);
            const Real* x = &view(i, j, k);
            if (m == 0) {
                EXPECT_EQ(r.lower, 0);
            }
            if (m == line.last) {
                EXPECT_EQ(r.upper, 0);
            }
            EXPECT_NEAR(r.lower * x[-stride] + r.diagonal * x[0] + r.upper * x[stride],
                        x[0] - a * (x[-stride] - 2 * x[0] + x[stride]), 1e-15 * 10);
        });
    }
}

TEST_P(DiffusionLineOf, PrescribedRowsAreTheIdentity)
{
    for (int direction : {0, 1}) {
        const DiffusionLine line = diffusion_line(g, GetParam(), direction, 0.7);
        for (Index m = 0; m <= line.last; ++m) {
            const std::uint8_t prescribed = 1;
            const TridiagonalRow r = line.row(m, &prescribed)(0);
            EXPECT_EQ(r.lower, 0);
            EXPECT_EQ(r.diagonal, 1);
            EXPECT_EQ(r.upper, 0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(EveryComponent, DiffusionLineOf, testing::ValuesIn(components),
                         [](const auto& c) { return std::string(1, "uvw"[axis(c.param)]); });

} // namespace
} // namespace starling
