#include "immersed_boundary/delta.hpp"

#include <gtest/gtest.h>

#include <string>

namespace starling {
namespace {

struct AnyKernel : testing::TestWithParam<Kernel> {
    /// Weight of node n for a point at s.
    static Real weight(Kernel kernel, std::int32_t n, Real s)
    {
        const Stencil4 stencil = delta_weights(kernel, s);
        const std::int32_t m = n - stencil.first;
        return m < 0 || m > 3 ? 0 : stencil.weight[static_cast<std::size_t>(m)];
    }
    Real weight(std::int32_t n, Real s) const { return weight(GetParam(), n, s); }
};

std::vector<Real> sample_points()
{
    std::vector<Real> points;
    for (int n = 0; n <= 200; ++n) points.push_back(-2 + 0.0203 * n);
    for (Real special : {-1., -0.5, 0., 0.25, 0.5, 1., 7.}) points.push_back(special);
    return points;
}

/// Sum over the stencil of weight * (node - s)^power.
Real moment(Kernel kernel, Real s, int power)
{
    const Stencil4 stencil = delta_weights(kernel, s);
    Real sum = 0;
    for (std::size_t m = 0; m < 4; ++m)
        sum += stencil.weight[m] * std::pow(stencil.first + static_cast<Real>(m) - s, power);
    return sum;
}

TEST_P(AnyKernel, SumsToOne)
{
    for (Real s : sample_points()) EXPECT_NEAR(moment(GetParam(), s, 0), 1, 4e-16);
}

TEST_P(AnyKernel, HasNoNegativeWeight)
{
    for (Real s : sample_points())
        for (Real w : delta_weights(GetParam(), s).weight) EXPECT_GE(w, 0);
}

TEST_P(AnyKernel, IsEven)
{
    for (Real s : sample_points())
        for (std::int32_t n = -3; n <= 3; ++n) EXPECT_NEAR(weight(n, s), weight(-n, -s), 1e-15);
}

TEST_P(AnyKernel, DependsOnTheDistanceOnly)
{
    for (Real s : sample_points())
        for (std::int32_t n = -3; n <= 3; ++n)
            EXPECT_NEAR(weight(n, s), weight(n + 5, s + 5), 1e-14);
}

TEST_P(AnyKernel, IsContinuousAndVanishesAtItsEnds)
{
    const Real step = 1e-6, steepest = 1;
    for (std::int32_t half = -8; half <= 8; ++half)
        for (std::int32_t n = -3; n <= 3; ++n) {
            const Real s = 0.5 * half;
            EXPECT_NEAR(weight(n, s - step), weight(n, s + step), 2 * step * steepest);
        }
    EXPECT_NEAR(weight(0, 2 - step), 0, step);
    EXPECT_EQ(weight(0, 2.5), 0);
}

INSTANTIATE_TEST_SUITE_P(Delta, AnyKernel,
                         testing::Values(Kernel::cosine, Kernel::quadratic_bspline,
                                         Kernel::cubic_bspline),
                         [](const auto& kernel) -> std::string {
                             switch (kernel.param) {
                             case Kernel::cosine: return "cosine";
                             case Kernel::quadratic_bspline: return "quadratic";
                             case Kernel::cubic_bspline: return "cubic";
                             }
                             return "";
                         });

TEST(Delta, BSplinesHaveNoFirstMoment)
{
    for (Real s : sample_points()) {
        EXPECT_NEAR(moment(Kernel::quadratic_bspline, s, 1), 0, 1e-15);
        EXPECT_NEAR(moment(Kernel::cubic_bspline, s, 1), 0, 1e-15);
    }
}

TEST(Delta, BSplinesHaveAConstantSecondMoment)
{
    for (Real s : sample_points()) {
        EXPECT_NEAR(moment(Kernel::quadratic_bspline, s, 2), 0.25, 1e-15);
        EXPECT_NEAR(moment(Kernel::cubic_bspline, s, 2), 1. / 3, 1e-15);
    }
}

TEST(Delta, FirstMomentOfTheCosineKernelIsAtMostTwoPercentOfASpacing)
{
    Real most = 0;
    for (Real s : sample_points()) most = std::max(most, std::abs(moment(Kernel::cosine, s, 1)));
    EXPECT_NEAR(most, 0.0211, 1e-4);
}

TEST(Delta, CosineKernelIsThatOfEquation27)
{
    for (Real s : sample_points())
        for (std::int32_t n = -3; n <= 3; ++n) {
            const Real r = n - s;
            const Real expected = std::abs(r) < 2 ? (1 + std::cos(pi * r / 2)) / 4 : 0;
            EXPECT_NEAR(AnyKernel::weight(Kernel::cosine, n, s), expected, 1e-15);
        }
}

// With B4' (r) = B3(r + 1/2) - B3(r - 1/2) the interpolated velocity has the divergence that the
// order-3 splines interpolate from the cells.
TEST(Delta, DerivativeOfTheCubicIsTheDifferenceOfTwoQuadratics)
{
    const Real h = 1e-5;
    for (Real s : sample_points())
        for (std::int32_t n = -3; n <= 3; ++n) {
            const auto cubic = [n](Real at) {
                return AnyKernel::weight(Kernel::cubic_bspline, n, at);
            };
            const auto quadratic = [](std::int32_t m, Real at) {
                return AnyKernel::weight(Kernel::quadratic_bspline, m, at);
            };
            EXPECT_NEAR((cubic(s + h) - cubic(s - h)) / (2 * h),
                        quadratic(n, s + 0.5) - quadratic(n, s - 0.5), 2 * h);
        }
}

} // namespace
} // namespace starling
