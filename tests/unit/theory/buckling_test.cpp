#include "theory/buckling.hpp"

#include <gtest/gtest.h>

#include "theory/mode_stiffness.hpp"

namespace starling {
namespace {

const std::vector<Material> all_laws{Hooke{1, 0.5}, NeoHookean{1}, MooneyRivlin{1, 0.5},
                                     Skalak{1, 1}};

TEST(Buckling, LongTubeIsARing)
{
    for (const Material& law : all_laws)
        for (const int n : {2, 3, 4}) {
            const BucklingTube tube{law, 1e-5, 1e4};
            EXPECT_NEAR(buckling_pressure(tube, n, 2) / ring_buckling_pressure(n, 1e-5), 1, 2e-3);
            EXPECT_NEAR(buckling_pressure_undeformed(tube, n) / ring_buckling_pressure(n, 1e-5), 1,
                        2e-3);
        }
}

TEST(Buckling, WithoutBendingStretchingAloneResists)
{
    // The tangent moduli at rest: H = 2 G_s/(1 - nu), shear G_s.
    const Real q2 = std::pow(pi / 10, 2), H = 4;
    const BucklingTube tube{Hooke{1, 0.5}, 0, 10};
    for (const int n : {2, 3, 8})
        EXPECT_NEAR(buckling_pressure_undeformed(tube, n), H * q2 / (q2 + H * n * n) / (n * n - 1),
                    1e-15);
}

TEST(Buckling, OfAUniformTubeIsTheZeroOfItsTwoByTwoDeterminant)
{
    for (const Material& law : all_laws)
        for (const int n : {2, 4}) {
            const BucklingTube tube{law, 0.002, 8};
            const Real q2 = std::pow(pi / 8, 2);
            const Real R = radius_at(law, tube.E_b, -buckling_pressure(tube, n));
            const ModeStiffness k = mode_stiffness(law, tube.E_b, R, n);
            const Real ww = k.w_xx * q2 * q2 + k.w_x * q2 + k.w, vv = k.v_x * q2 + k.v;
            EXPECT_NEAR(ww * vv, k.wv * k.wv, 1e-8 * ww * vv);
        }
}

TEST(Buckling, SoftWallsBuckleNearTheLoadOfTheWallAtRest)
{
    for (const Material& law : all_laws)
        for (const int n : {2, 3, 4}) {
            const BucklingTube tube{law, 1e-4, 10};
            EXPECT_NEAR(buckling_pressure(tube, n) / buckling_pressure_undeformed(tube, n), 1,
                        0.03);
        }
}

TEST(Buckling, FactorScalesWithTheLoad)
{
    const BucklingTube tube{Hooke{1, 0.5}, 1e-3, 10};
    const Real once = buckling_factor(tube, 2, {0.1, -0.4});
    EXPECT_NEAR(buckling_factor(tube, 2, {0.2, -0.8}), once / 2, 1e-8 * once);
    EXPECT_NEAR(buckling_factor(tube, 2, {-0.4, 0.1}), once, 1e-8 * once); // mirrored
    EXPECT_NEAR(buckling_factor(tube, 2, {-0.5, -0.5}) * 0.5, buckling_pressure(tube, 2), 1e-10);
    EXPECT_TRUE(std::isnan(buckling_factor(tube, 2, {0.1, 0.2})));
}

TEST(Buckling, LoadsScaleWithTheModulus)
{
    for (const Real B : {1e-3, 1e-7})
        for (const int n : {2, 3, 8}) {
            const BucklingTube soft{Hooke{1, 0.5}, B, 10}, stiff{Hooke{4e4, 0.5}, 4e4 * B, 10};
            const Real load = buckling_factor(soft, n, {0.1, -1});
            EXPECT_NEAR(buckling_factor(stiff, n, {0.1, -1}), 4e4 * load, 1e-8 * 4e4 * load);
        }
}

TEST(Buckling, GalerkinConvergesWithTheNumberOfTerms)
{
    BucklingTube tube{NeoHookean{1}, 1e-3, 10};
    const Real fine = buckling_factor(tube, 3, {0, -1}, 40);
    EXPECT_NEAR(buckling_factor(tube, 3, {0, -1}, 16), fine, 1e-5 * fine);
    tube.ends = TubeEnds::clamped;
    const Real clamped = buckling_factor(tube, 3, {0, -1}, 40);
    EXPECT_NEAR(buckling_factor(tube, 3, {0, -1}, 16), clamped, 0.01 * clamped);
    EXPECT_GT(clamped, fine);
}

/// Stability by finite differences along x: w and v at nodes, energy assembled directly, Cholesky's
/// factorisation of the banded matrix. Pinned: w = v = 0 at both ends, w'' = 0 naturally.
class DifferenceTube {
public:
    DifferenceTube(const BucklingTube& tube, int n, int nodes) : tube_(tube), n_(n), nodes_(nodes)
    {
    }

    bool is_stable(Real P_in, Real P_out) const
    {
        std::vector<std::vector<Real>> K(size(), std::vector<Real>(size()));
        const Real h = tube_.length / (nodes_ + 1);
        for (int i = 0; i <= nodes_ + 1; ++i) {
            const ModeStiffness k = stiffness(i * h, P_in, P_out);
            add(K, {{w(i), 1}}, {{w(i), 1}}, k.w);
            add(K, {{w(i), 1}}, {{v(i), 1}}, k.wv);
            add(K, {{v(i), 1}}, {{w(i), 1}}, k.wv);
            add(K, {{v(i), 1}}, {{v(i), 1}}, k.v);
            if (i == 0 || i == nodes_ + 1) continue;
            const Terms second{{w(i - 1), 1}, {w(i), -2}, {w(i + 1), 1}};
            add(K, second, second, k.w_xx / std::pow(h, 4));
        }
        for (int i = 0; i <= nodes_; ++i) {
            const ModeStiffness k = stiffness((i + 0.5) * h, P_in, P_out);
            const Terms w_x{{w(i), -1}, {w(i + 1), 1}}, v_x{{v(i), -1}, {v(i + 1), 1}};
            add(K, w_x, w_x, k.w_x / (h * h));
            add(K, v_x, v_x, k.v_x / (h * h));
        }
        return eliminates_with_positive_pivots(K);
    }

private:
    using Terms = std::vector<std::pair<int, Real>>;

    std::size_t size() const { return 2 * static_cast<std::size_t>(nodes_); }
    int w(int node) const { return node >= 1 && node <= nodes_ ? 2 * (node - 1) : -1; }
    int v(int node) const { return node >= 1 && node <= nodes_ ? 2 * (node - 1) + 1 : -1; }

    ModeStiffness stiffness(Real x, Real P_in, Real P_out) const
    {
        const Real s = x / tube_.length;
        return mode_stiffness(tube_.law, tube_.E_b,
                              radius_at(tube_.law, tube_.E_b, (1 - s) * P_in + s * P_out), n_);
    }

    static void add(std::vector<std::vector<Real>>& K, const Terms& a, const Terms& b, Real factor)
    {
        for (const auto& [i, x] : a)
            for (const auto& [j, y] : b)
                if (i >= 0 && j >= 0)
                    K[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += factor * x * y;
    }

    static bool eliminates_with_positive_pivots(std::vector<std::vector<Real>>& K)
    {
        constexpr std::size_t band = 5;
        for (std::size_t p = 0; p < K.size(); ++p) {
            if (!(K[p][p] > 0)) return false;
            for (std::size_t i = p + 1; i < std::min(p + band, K.size()); ++i)
                for (std::size_t j = p + 1; j < std::min(p + band, K.size()); ++j)
                    K[i][j] -= K[i][p] * K[p][j] / K[p][p];
        }
        return true;
    }

    BucklingTube tube_;
    int n_, nodes_;
};

TEST(Buckling, AgreesWithFiniteDifferencesAlongTheTube)
{
    for (const Material& law : {Material{Hooke{1, 0.5}}, Material{Skalak{1, 1}}})
        for (const int n : {2, 3}) {
            const BucklingTube tube{law, 1e-3, 10};
            const DifferenceTube by_differences(tube, n, 200);
            for (const auto& [inlet, outlet] : {std::pair{0.0, -1.0}, {0.3, -1.0}, {-1.0, -1.0}}) {
                const Real factor = buckling_factor(tube, n, {inlet, outlet});
                for (const Real below : {0.999, 1.001})
                    EXPECT_EQ(
                        by_differences.is_stable(below * factor * inlet, below * factor * outlet),
                        below < 1);
            }
        }
}

TEST(Buckling, ShorterTubesAndThinnerWallsHaveMoreLobes)
{
    const auto mode = [](Real E_b, Real length) {
        int best = 2;
        for (int n = 3; n <= 12; ++n)
            if (buckling_pressure({Hooke{1, 0.5}, E_b, length}, n, 4) <
                buckling_pressure({Hooke{1, 0.5}, E_b, length}, best, 4))
                best = n;
        return best;
    };
    EXPECT_LT(mode(1e-3, 20), mode(1e-3, 5));
    EXPECT_LT(mode(1e-3, 10), mode(1e-5, 10));
}

} // namespace
} // namespace starling
