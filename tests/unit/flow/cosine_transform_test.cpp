#include "flow/cosine_transform.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace starling {
namespace {

class CosineTransformOf : public testing::TestWithParam<std::tuple<Index, Index>> {
protected:
    Index n = std::get<0>(GetParam());
    Index width = 2 * std::get<1>(GetParam());
    CosineTransform transform{n, width / 2};
    Array<Real> x{n * width}, work{n * width};

    void forward() { transform.forward(x.data(), work.data(), x.data()); }
    void backward()
    {
        const Array<Real> X = x;
        transform.backward(X.data(), work.data(), x.data());
    }
    /// Value k of row j.
    Real& at(Index j, Index k)
    {
        Index m = 0;
        while (transform.row_at(m) != j) ++m;
        return x[m * width + k];
    }
    Real transformed(Index m, Index k) const { return x[m * width + k]; }
};

TEST_P(CosineTransformOf, BackwardUndoesForward)
{
    for (Index j = 0; j < n; ++j)
        for (Index k = 0; k < width; ++k)
            at(j, k) = std::sin(3. * static_cast<Real>(j * j + 7 * k));
    const Array<Real> before = x;
    forward();
    backward();
    for (Index m = 0; m < x.size(); ++m) EXPECT_NEAR(x[m], before[m], 1e-14);
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
                EXPECT_NEAR(transformed(m, k), m == wave ? norm * static_cast<Real>(k + 1) : 0,
                            1e-13 * static_cast<Real>(n * width));
    }
}

TEST_P(CosineTransformOf, BitsDoNotDependOnWhetherItIsInPlace)
{
    for (Index m = 0; m < x.size(); ++m) x[m] = std::sin(static_cast<Real>(m * m));
    Array<Real> X(x.size());
    transform.forward(x.data(), work.data(), X.data());
    forward();
    for (Index m = 0; m < x.size(); ++m) EXPECT_EQ(X[m], x[m]);
}

TEST_P(CosineTransformOf, IsTheSumOfCosines)
{
    for (Index j = 0; j < n; ++j)
        for (Index k = 0; k < width; ++k) at(j, k) = std::sin(static_cast<Real>(7 * j + 3 * k * k));
    const Array<Real> before = x;
    forward();
    for (Index m = 0; m < n; ++m)
        for (Index k = 0; k < width; ++k) {
            Real sum = 0;
            for (Index place = 0; place < n; ++place) {
                const Index j = transform.row_at(place);
                sum += before[place * width + k] *
                       std::cos(pi * static_cast<Real>(m) * (static_cast<Real>(j) + 0.5) /
                                static_cast<Real>(n));
            }
            EXPECT_NEAR(transformed(m, k), sum, 1e-14 * static_cast<Real>(n + 1));
        }
}

INSTANTIATE_TEST_SUITE_P(LengthsAndColumns, CosineTransformOf,
                         testing::Combine(testing::Values(1, 2, 3, 7, 8, 9, 30, 48, 240),
                                          testing::Values(1, 6, 8, 19)));

} // namespace
} // namespace starling
