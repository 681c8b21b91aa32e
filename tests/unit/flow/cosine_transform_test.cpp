#include "flow/cosine_transform.hpp"

#include <gtest/gtest.h>

#include <tuple>
#include <vector>

namespace starling {
namespace {

class CosineTransformOf : public testing::TestWithParam<std::tuple<Index, Index>> {
protected:
    Index n = std::get<0>(GetParam());
    Index width = std::get<1>(GetParam());
    CosineTransform transform{n};
    std::vector<Real> x = std::vector<Real>(static_cast<std::size_t>(n * width));
    std::vector<Real> scratch = std::vector<Real>(static_cast<std::size_t>((n + 1) * width));

    void forward() { transform.forward(x.data(), width, x.data(), width, width, scratch.data()); }
    void backward() { transform.backward(x.data(), width, x.data(), width, width, scratch.data()); }
    Real& at(Index j, Index k) { return x[static_cast<std::size_t>(j * width + k)]; }
};

TEST_P(CosineTransformOf, BackwardUndoesForward)
{
    for (Index j = 0; j < n; ++j)
        for (Index k = 0; k < width; ++k)
            at(j, k) = std::sin(3. * static_cast<Real>(j * j + 7 * k));
    const std::vector<Real> before = x;
    forward();
    backward();
    for (std::size_t m = 0; m < x.size(); ++m) EXPECT_NEAR(x[m], before[m], 1e-14);
}

TEST_P(CosineTransformOf, ACosineBecomesOneCoefficient)
{
    for (Index wave = 0; wave < n; ++wave) {
        for (Index j = 0; j < n; ++j)
            for (Index k = 0; k < width; ++k)
                at(j, k) = static_cast<Real>(k + 1) *
                           std::cos(pi * static_cast<Real>(wave) * (static_cast<Real>(j) + 0.5) /
                                    static_cast<Real>(n));
        forward();
        const Real norm = static_cast<Real>(n) / (wave == 0 ? 1 : 2);
        for (Index m = 0; m < n; ++m)
            for (Index k = 0; k < width; ++k)
                EXPECT_NEAR(at(m, k), m == wave ? norm * static_cast<Real>(k + 1) : 0,
                            1e-13 * static_cast<Real>(n * width));
    }
}

TEST_P(CosineTransformOf, BitsOfAColumnDependNeitherOnTheOthersNorOnWhereRowsLie)
{
    for (Index j = 0; j < n; ++j)
        for (Index k = 0; k < width; ++k) at(j, k) = std::sin(static_cast<Real>(5 * j + k * k));
    const Index stride = width + 3, last = width - 1;
    std::vector<Real> apart(static_cast<std::size_t>(n * stride)), alone(apart.size());
    transform.forward(x.data(), width, apart.data(), stride, width, scratch.data());
    transform.forward(&at(0, last), width, alone.data(), 1, 1, scratch.data());
    forward();
    for (Index j = 0; j < n; ++j) {
        for (Index k = 0; k < width; ++k)
            EXPECT_EQ(apart[static_cast<std::size_t>(j * stride + k)], at(j, k));
        EXPECT_EQ(alone[static_cast<std::size_t>(j)], at(j, last));
    }
}

INSTANTIATE_TEST_SUITE_P(LengthsAndWidths, CosineTransformOf,
                         testing::Combine(testing::Values(1, 2, 3, 8, 9, 30, 48),
                                          testing::Values(1, 11, 16, 37)));

} // namespace
} // namespace starling
