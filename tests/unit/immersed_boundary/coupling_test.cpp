#include "immersed_boundary/coupling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "unit/grid/random_fields.hpp"
#include "unit/immersed_boundary/boxed_tube.hpp"

namespace starling {
namespace {

constexpr std::array schemes = {CouplingScheme::printed, CouplingScheme::reaction,
                                CouplingScheme::conserving};

struct AnyScheme : testing::TestWithParam<CouplingScheme> {
    support::BoxedTube stage{0.25};
    Coupling coupling{stage.g, stage.tube, stage.geometry, GetParam()};
    GhostStates ghosts{GhostState(stage.g), GhostState(stage.g), GhostState(stage.g)};
    support::Random random;

    void place(const support::Shape& shape)
    {
        stage.place(support::positions(stage.tube, shape));
        coupling.initialise(stage.wall, ghosts);
        EXPECT_TRUE(coupling.weigh(stage.wall));
        EXPECT_TRUE(coupling.search(stage.wall, ghosts));
        coupling.place_images(ghosts);
    }
    Array<Vec3> random_force()
    {
        Array<Vec3> f(stage.wall.x.size());
        for (Vec3& a : f) a = {random(), random(), random()};
        return f;
    }
    Real face_sum(Location c, const ScalarField& F) const
    {
        Real sum = 0;
        support::visit(stage.g.unknowns(c), [&](Index i, Index j, Index k) { sum += F(i, j, k); });
        return sum * stage.g.cell_volume();
    }
};

TEST_P(AnyScheme, SpreadsForceAndNothingElse)
{
    place(support::random_smooth(1, 0.4));
    Array<Vec3> f = random_force();
    for (Index v = 0; v < f.size(); ++v)
        if (stage.wall.x[v].x < 1.6 || stage.wall.x[v].x > 2.5) f[v] = {};
    VectorField F(stage.g);
    coupling.spread(f, F);
    Vec3 total;
    for (const Vec3& a : f) total += a;
    EXPECT_NEAR(face_sum(Location::u, F[Location::u]), total.x, 1e-12);
    EXPECT_NEAR(face_sum(Location::v, F[Location::v]), total.y, 1e-12);
    EXPECT_NEAR(face_sum(Location::w, F[Location::w]), total.z, 1e-12);
    EXPECT_EQ(total.x == 0, GetParam() == CouplingScheme::printed);
}

// What comes to the rigid parts is for their support.
TEST_P(AnyScheme, RigidPartsNeverMove)
{
    place(support::lobed(2, 0.4));
    const VectorField u = support::random_velocity(stage.g, random);
    const Array<Vec3> before = stage.wall.x;
    coupling.follow(u, stage.wall);
    stage.wall.move(stage.tube, 0.1);
    for (VertexIndex v = 0; v < stage.tube.mesh.vertex_count(); ++v) {
        const bool moves = v >= stage.tube.moving_begin() && v < stage.tube.moving_end();
        EXPECT_EQ(stage.wall.x[v] == before[v], !moves);
        EXPECT_EQ(stage.wall.velocity[v] == Vec3{}, !moves && !supports_rigid_parts(GetParam()));
    }
}

TEST_P(AnyScheme, VerticesMoveWithTheirVelocityAndKeepTheirX)
{
    place(support::lobed(2, 0.4));
    const VectorField u = support::random_velocity(stage.g, random);
    const Array<Vec3> before = stage.wall.x;
    coupling.follow(u, stage.wall);
    stage.wall.move(stage.tube, 0.1);
    for (VertexIndex v = stage.tube.moving_begin(); v < stage.tube.moving_end(); ++v) {
        EXPECT_EQ(stage.wall.x[v].x, before[v].x);
        EXPECT_LT(norm(stage.wall.x[v] - before[v] - 0.1 * stage.wall.velocity[v]), 1e-15);
    }
}

TEST_P(AnyScheme, GhostsOfVAndWLiveInRigidPartsWithoutSupport)
{
    place(support::lobed(2, 0.4));
    for (Location c : components) {
        const PrescribedNodes p = coupling.ghosts(c).prescribed();
        for (Index i = 0; i < stage.g.unknowns(c).end[0]; ++i) {
            const auto n = static_cast<std::size_t>(i);
            const Real x = stage.g.x(c, i);
            const bool rigid = x <= stage.tube.x_clamp_in() || x >= stage.tube.x_clamp_out();
            EXPECT_EQ(p.plane_begin[n + 1] > p.plane_begin[n],
                      c == Location::u || (rigid && !supports_rigid_parts(GetParam())));
        }
    }
}

// Smeared as far as the sharpened kernels reach, three spacings, with the area of the section.
TEST_P(AnyScheme, InsideShareIsThatOfTheTube)
{
    const Array<Real> share = coupling.inside_share();
    const Real h = stage.g.spacing().y;
    Real area = 0;
    for (Index j = 0; j < stage.g.ny(); ++j)
        for (Index k = 0; k < stage.g.nz(); ++k) {
            const Real r = std::hypot(stage.g.y(Location::cell, j), stage.g.z(Location::cell, k));
            const Real a = share[j * stage.g.nz() + k];
            area += a * stage.g.cell_volume() / stage.g.spacing().x;
            const Real sharp = r < 1 ? 1 : 0;
            const bool beside_wall = std::abs(r - 1) < 3.5 * h;
            if (!supports_rigid_parts(GetParam())) {
                EXPECT_EQ(a, sharp);
            } else if (!beside_wall) {
                EXPECT_NEAR(a, sharp, 1e-2);
            }
        }
    EXPECT_NEAR(area, pi, supports_rigid_parts(GetParam()) ? 0.02 : 0.2);
}

TEST_P(AnyScheme, RefusesAWallThatIsNotFiniteOrLeavesTheBox)
{
    place(support::lobed(2, 0.4));
    const Array<Vec3> before = stage.wall.x;
    for (Real bad : {std::numeric_limits<Real>::quiet_NaN(), 2.4, 1e9}) {
        Array<Vec3> x = before;
        x[stage.tube.moving_begin() + 5].y = bad;
        stage.place(x);
        EXPECT_FALSE(coupling.weigh(stage.wall));
    }
}

// In the conserving scheme the power of the wall's forces on the fluid is what they do on the wall.
TEST_P(AnyScheme, PowerBalances)
{
    place(support::random_smooth(2, 0.4));
    const VectorField u = support::random_velocity(stage.g, random);
    Array<Vec3> f = random_force();
    for (Index v = 0; v < f.size(); ++v) // v, w only: u at an end face stands for half a cell
        if (v < stage.tube.moving_begin() || v >= stage.tube.moving_end()) f[v] = {};
    const Array<Vec3> elastic = f;
    VectorField F(stage.g);
    coupling.spread(f, F);
    coupling.follow(u, stage.wall);
    Real on_fluid = 0, on_wall = 0;
    for (Location c : components)
        support::visit(stage.g.unknowns(c), [&](Index i, Index j, Index k) {
            on_fluid += F[c](i, j, k) * u[c](i, j, k) * stage.g.cell_volume();
        });
    for (VertexIndex v = stage.tube.moving_begin(); v < stage.tube.moving_end(); ++v)
        on_wall += dot(elastic[v], stage.wall.velocity[v]);
    if (GetParam() == CouplingScheme::reaction) // not its own adjoint
        EXPECT_GT(std::abs(on_fluid - on_wall), 1e-3);
    else
        EXPECT_NEAR(on_fluid, on_wall, 1e-12);
}

const auto scheme_name = [](const auto& scheme) -> std::string {
    return std::array{"printed", "reaction", "conserving"}[static_cast<std::size_t>(scheme.param)];
};

INSTANTIATE_TEST_SUITE_P(Coupling, AnyScheme, testing::ValuesIn(schemes), scheme_name);

} // namespace
} // namespace starling
