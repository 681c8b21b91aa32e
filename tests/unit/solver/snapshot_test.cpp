#include "solver/snapshot.hpp"

#include <gtest/gtest.h>

#include "unit/output/synthetic.hpp"

namespace starling {
namespace {

// synthetic::fluid: 6 x 4 x 5 cells, pressure t + x + 10 y + 100 z, velocity (x, y, z).

/// Every value of a snapshot is that of the field at the centre of its cell.
void expect_field_at_centres(const FluidSnapshot& s, Real t)
{
    const auto cells = static_cast<std::size_t>(s.cells[0] * s.cells[1] * s.cells[2]);
    ASSERT_EQ(s.at_cell[0].values.size(), 3 * cells);
    ASSERT_EQ(s.at_cell[1].values.size(), cells);
    std::size_t n = 0;
    for (Index i = 0; i < s.cells[0]; ++i)
        for (Index j = 0; j < s.cells[1]; ++j)
            for (Index k = 0; k < s.cells[2]; ++k, ++n) {
                const Vec3 p = {s.origin.x + s.spacing.x * (static_cast<Real>(i) + 0.5),
                                s.origin.y + s.spacing.y * (static_cast<Real>(j) + 0.5),
                                s.origin.z + s.spacing.z * (static_cast<Real>(k) + 0.5)};
                EXPECT_NEAR(s.at_cell[1].values[n], t + p.x + 10 * p.y + 100 * p.z, 1e-10);
                EXPECT_NEAR(s.at_cell[0].values[3 * n + 1], p.y, 1e-12);
            }
}

TEST(Snapshot, MeansOfALinearFieldAreItsValuesAtTheBlocksCentres)
{
    const FluidSnapshot s = block_means(synthetic::fluid(1, 0), 2);
    EXPECT_EQ(s.cells, (std::array<Index, 3>{3, 2, 2})); // the fifth layer is left out
    EXPECT_EQ(s.spacing, (Vec3{1, 0.5, 1.5}));
    expect_field_at_centres(s, 1);
    EXPECT_EQ(block_means(synthetic::fluid(1, 0), 100).cells, (std::array<Index, 3>{1, 1, 1}));
}

TEST(Snapshot, LayerOfALinearFieldIsItsValueInThePlane)
{
    // The box ends at y = 0 and at z = 1.75: the nearest inner faces are y = -0.25 and z = 0.25.
    const FluidSnapshot y = axial_layer(synthetic::fluid(1, 0), 1);
    EXPECT_EQ(y.cells, (std::array<Index, 3>{6, 1, 5}));
    EXPECT_NEAR(y.origin.y + y.spacing.y / 2, -0.25, 1e-15);
    expect_field_at_centres(y, 1);
    const FluidSnapshot z = axial_layer(synthetic::fluid(1, 0), 2);
    EXPECT_EQ(z.cells, (std::array<Index, 3>{6, 4, 1}));
    EXPECT_NEAR(z.origin.z + z.spacing.z / 2, 0.25, 1e-15);
    expect_field_at_centres(z, 1);
}

TEST(Snapshot, SlabKeepsCellsAndTrianglesBetweenItsPlanes)
{
    const FluidSnapshot s = slab(synthetic::fluid(1, 0), 0.6, 1.2);
    EXPECT_EQ(s.cells, (std::array<Index, 3>{2, 4, 5})); // cells [0.5, 1.5)
    EXPECT_EQ(s.origin.x, 0.5);
    expect_field_at_centres(s, 1);
    EXPECT_EQ(slab(synthetic::fluid(1, 0), 7, 8).cells[0], 1);

    // Of the tetrahedron only vertex 1 stands at x = 1; three triangles have it, with all vertices.
    const WallSnapshot whole = synthetic::wall(0, 0), w = slab(whole, 0.9, 1.1);
    ASSERT_EQ(w.triangles.size(), 3u);
    ASSERT_EQ(w.points.size(), 4u);
    EXPECT_EQ(w.at_element[0].values, (std::vector<Real>{0, 1, 2}));
    for (std::size_t e = 0; e < 3; ++e)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(w.points[static_cast<std::size_t>(w.triangles[e][k])],
                      whole.points[static_cast<std::size_t>(whole.triangles[e][k])]);
    EXPECT_TRUE(slab(whole, 3, 4).points.empty());
}

TEST(Snapshot, OutsideTheTubeIsBlankAndDoesNotEnterMeans)
{
    const Grid g({6, 4, 5}, {0, -1, -2}, {3, 1, 3.75});
    Field<std::uint8_t> inside(g);
    inside(2, 1, 3) = 1; // the face between the cells (1, 1, 3) and (2, 1, 3)
    const SnapshotParameters tube{FluidRegion::tube, 1};
    const FluidSnapshot whole = synthetic::fluid(1, 0), s = reduced(whole, tube, inside);
    Index kept = 0;
    for (std::size_t n = 0; n < s.at_cell[1].values.size(); ++n) {
        if (std::isnan(s.at_cell[1].values[n])) continue;
        ++kept;
        EXPECT_EQ(s.at_cell[1].values[n], whole.at_cell[1].values[n]);
    }
    EXPECT_EQ(kept, 2);
    const FluidSnapshot means = reduced(whole, {FluidRegion::tube, 2}, inside);
    const std::size_t place = (1 * 4 + 1) * 5 + 3, block = (0 * 2 + 0) * 2 + 1;
    EXPECT_EQ(means.at_cell[1].values[block], whole.at_cell[1].values[place]);
    EXPECT_TRUE(std::isnan(means.at_cell[1].values[0]));
}

} // namespace
} // namespace starling
