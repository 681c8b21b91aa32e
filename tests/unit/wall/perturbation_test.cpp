#include "wall/perturbation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

Array<Vec3> perturbed(const Tube& tube, const PerturbationParameters& p)
{
    Array<Vec3> x = WallState(tube).x;
    perturb(tube, p, x);
    return x;
}

Real radius(const Vec3& a) { return std::hypot(a.y, a.z); }

/// Root mean square of r - 1 over the vertices between the clamps.
Real mean_square_root(const Tube& tube, const Array<Vec3>& x)
{
    Real sum = 0;
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v)
        sum += std::pow(radius(x[v]) - 1, 2);
    return std::sqrt(sum / (tube.moving_end() - tube.moving_begin()));
}

TEST(Perturbation, IsNothingWithoutAnAmplitude)
{
    const Tube tube = make_tube(support::short_tube(), 0.3);
    EXPECT_TRUE(std::ranges::equal(perturbed(tube, {.mode = 3}), tube.X));
    EXPECT_TRUE(std::ranges::equal(perturbed(tube, {.seed = 3}), tube.X));
}

TEST(Perturbation, OfAModeIsItsWave)
{
    const Tube tube = make_tube(support::short_tube(), 0.2);
    const Array<Vec3> x = perturbed(tube, {.amplitude = 0.05, .mode = 3});
    for (VertexIndex v = 0; v < tube.mesh.vertex_count(); ++v) {
        const Vec3& X = tube.X[static_cast<std::size_t>(v)];
        const Real s = std::clamp(
            (X.x - tube.x_clamp_in()) / (tube.x_clamp_out() - tube.x_clamp_in()), 0., 1.);
        const Real wave = std::cos(3 * std::atan2(X.z, X.y)) * std::sin(pi * s);
        EXPECT_NEAR(radius(x[v]) - 1, 0.05 * wave, 1e-14);
        EXPECT_EQ(x[v].x, X.x);
    }
}

TEST(Perturbation, OfRandomWavesHasItsRootMeanSquareAndChangesWithTheSeed)
{
    const Tube tube = make_tube(support::short_tube(), 0.05);
    const Array<Vec3> one = perturbed(tube, {.amplitude = 0.01, .seed = 1}),
                      again = perturbed(tube, {.amplitude = 0.01, .seed = 1}),
                      two = perturbed(tube, {.amplitude = 0.01, .seed = 2});
    EXPECT_NEAR(mean_square_root(tube, one), 0.01, 1e-4);
    EXPECT_NEAR(mean_square_root(tube, two), 0.01, 1e-4);
    EXPECT_TRUE(std::ranges::equal(one, again));
    EXPECT_FALSE(std::ranges::equal(one, two));
}

TEST(Perturbation, HasTheSameShapeOnEveryMesh)
{
    const PerturbationParameters p{.amplitude = 0.02, .seed = 5};
    // every vertex between the coarse tube's clamps is one of the fine tube's
    const TubeParameters parameters{.length = 4, .rigid_inlet = 1, .rigid_outlet = 1};
    const Tube coarse = make_tube(parameters, 0.4), fine = make_tube(parameters, 0.2);
    const Array<Vec3> a = perturbed(coarse, p), b = perturbed(fine, p);
    VertexIndex compared = 0;
    for (Index v = 0; v < a.size(); ++v)
        for (Index w = 0; w < b.size(); ++w)
            if (norm(coarse.X[static_cast<std::size_t>(v)] - fine.X[static_cast<std::size_t>(w)]) <
                1e-12) {
                EXPECT_LT(norm(a[v] - b[w]), 1e-13);
                ++compared;
            }
    EXPECT_GE(compared, coarse.moving_end() - coarse.moving_begin());
}

TEST(Perturbation, LeavesTheRigidPartsAlone)
{
    const Tube tube = make_tube(support::short_tube(), 0.2);
    const Array<Vec3> x = perturbed(tube, {.amplitude = 0.1});
    for (VertexIndex v = 0; v < tube.mesh.vertex_count(); ++v)
        if (v < tube.moving_begin() || v >= tube.moving_end()) {
            EXPECT_EQ(x[v], tube.X[static_cast<std::size_t>(v)]);
        }
}

} // namespace
} // namespace starling
