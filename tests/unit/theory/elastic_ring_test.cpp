#include "theory/elastic_ring.hpp"

#include <gtest/gtest.h>

#include "theory/buckling.hpp"

namespace starling {
namespace {

Real polygon_area(const std::vector<OutlinePoint>& points)
{
    Real twice = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const OutlinePoint &a = points[i], &b = points[(i + 1) % points.size()];
        twice += a.y * b.z - a.z * b.y;
    }
    return twice / 2;
}

TEST(ElasticRing, LeavesTheCircleAtTheBucklingPressure)
{
    for (const int n : {2, 3, 4, 5, 6, 8}) {
        EXPECT_EQ(tube_law(n, 3).front().area_ratio, 1);
        EXPECT_NEAR(ring_at_area(n, 0.9999).pressure, ring_buckling_pressure(n, 1),
                    1e-3 * ring_buckling_pressure(n, 1));
    }
}

TEST(ElasticRing, ContactPressuresAreThePublishedOnes)
{
    // Flaherty, Keller & Rubinow, SIAM J. Appl. Math. 23 (1972), 446-455
    EXPECT_NEAR(ring_at_contact(2).pressure, 5.247, 5e-4);
    EXPECT_NEAR(ring_at_contact(3).pressure, 21.65, 5e-3);
    EXPECT_NEAR(ring_at_contact(4).pressure, 51.84, 5e-3);
    EXPECT_NEAR(ring_at_contact(2).area_ratio, 0.2709, 5e-5);
}

TEST(ElasticRing, OutlineHasTheAreaAndTheDistancesOfTheRing)
{
    for (const int n : {2, 3, 5})
        for (const Real area : {0.9, 0.6, 0.4}) {
            const ElasticRing ring = ring_at_area(n, area);
            const int count = 3600;
            const auto points = outline(ring, count);
            const auto waist = points[static_cast<std::size_t>(count / n / 2)];
            EXPECT_NEAR(polygon_area(points), pi * area, 2e-4);
            EXPECT_NEAR(points[0].y, ring.tip_distance, 1e-8);
            EXPECT_NEAR(std::hypot(waist.y, waist.z), ring.waist_distance, 1e-8);
        }
}

TEST(ElasticRing, OutlineClosesAndKeepsItsLength)
{
    const int count = 600;
    const auto points = outline(ring_at_area(3, 0.3), count);
    Real length = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const OutlinePoint &a = points[i], &b = points[(i + 1) % points.size()];
        const Real distance = std::hypot(b.y - a.y, b.z - a.z);
        EXPECT_NEAR(distance, 2 * pi / count, 1e-4); // no gap from the last point to the first
        length += distance;
    }
    EXPECT_NEAR(length, 2 * pi, 1e-3);
}

/// The outline's curvature, by differences, obeys kappa'' + kappa^3/2 - c kappa = p.
TEST(ElasticRing, OutlineIsInEquilibrium)
{
    for (const int n : {2, 3}) {
        const ElasticRing ring = ring_at_area(n, 0.4);
        const int count = 2400;
        const auto points = outline(ring, count);
        const Real h = 2 * pi / count;
        const auto at = [&](int i) {
            return points[static_cast<std::size_t>((i + count) % count)];
        };
        std::vector<Real> kappa;
        for (int i = 0; i < count; ++i) {
            const OutlinePoint a = at(i - 1), b = at(i), c = at(i + 1);
            const Real first = std::atan2(b.z - a.z, b.y - a.y);
            const Real turn = std::atan2(c.z - b.z, c.y - b.y) - first;
            kappa.push_back(std::remainder(turn, 2 * pi) / h);
        }
        for (int i = 2; i + 2 < count; ++i) { // away from where the outline closes
            const auto j = static_cast<std::size_t>(i);
            const Real second = (kappa[j + 1] - 2 * kappa[j] + kappa[j - 1]) / (h * h);
            EXPECT_NEAR(second + std::pow(kappa[j], 3) / 2 - ring.tension * kappa[j], ring.pressure,
                        0.004 * ring.pressure);
        }
    }
}

/// The integral of kappa^2/2, from the angles between the pieces of the outline.
Real bending_energy(const ElasticRing& ring)
{
    const int count = 4000;
    const auto points = outline(ring, count);
    Real sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const OutlinePoint &a = points[(i + points.size() - 1) % points.size()], &b = points[i],
                           &c = points[(i + 1) % points.size()];
        const Real turn = std::atan2(c.z - b.z, c.y - b.y) - std::atan2(b.z - a.z, b.y - a.y);
        sum += std::pow(std::remainder(turn, 2 * pi), 2);
    }
    return sum / (2 * 2 * pi / count);
}

/// Along the branch the work of the pressure, -p dA, is stored as bending energy.
TEST(ElasticRing, WorkOfThePressureIsTheBendingEnergy)
{
    for (const int n : {2, 3, 4}) {
        const ElasticRing a = ring_at_area(n, 0.5), b = ring_at_area(n, 0.49);
        const Real work = (a.pressure + b.pressure) / 2 * 0.01 * pi;
        EXPECT_NEAR(bending_energy(b) - bending_energy(a), work, 1e-3 * work);
    }
}

TEST(ElasticRing, PressureRisesAndAreaFallsUntilContact)
{
    for (const int n : {2, 3, 6}) {
        const auto law = tube_law(n, 21);
        for (std::size_t i = 1; i < law.size(); ++i) {
            EXPECT_GT(law[i].pressure, law[i - 1].pressure);
            EXPECT_LT(law[i].area_ratio, law[i - 1].area_ratio);
        }
        EXPECT_NEAR(law.back().gap, 0, 1e-9);
        EXPECT_LT(law.back().area_ratio, 0.3);
    }
}

} // namespace
} // namespace starling
