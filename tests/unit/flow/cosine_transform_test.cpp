#include "flow/cosine_transform.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace starling {
namespace {

class CosineTransformOf : public testing::TestWithParam<Index> {
protected:
    Index n = GetParam();
    Index width = 11;
    CosineTransform transform{n};
    std::vector<Real> x = std::vector<Real>(static_cast<std::size_t>(n * width));
    std::vector<Real> scratch = std::vector<Real>(static_cast<std::size_t>((n + 1) * width));

    Real& at(Index j, Index k) { return x[static_cast<std::size_t>(j * width + k)]; }
};

TEST_P(CosineTransformOf, BackwardUndoesForward)
{
    for (Index j = 0; j < n; ++j)
        for (Index k = 0; k < width; ++k)
            at(j, k) = std::sin(3. * static_cast<Real>(j * j + 7 * k));
    const std::vector<Real> before = x;
    transform.forward(x.data(), width, scratch.data());
    transform.backward(x.data(), width, scratch.data());
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
        transform.forward(x.data(), width, scratch.data());
        const Real norm = static_cast<Real>(n) / (wave == 0 ? 1 : 2);
        for (Index m = 0; m < n; ++m)
            for (Index k = 0; k < width; ++k)
                EXPECT_NEAR(at(m, k), m == wave ? norm * static_cast<Real>(k + 1) : 0,
                            1e-13 * static_cast<Real>(n * width));
    }
}

INSTANTIATE_TEST_SUITE_P(OddAndEvenLengths, CosineTransformOf,
                         testing::Values(1, 2, 3, 8, 9, 30, 48));

} // namespace
} // namespace starling
