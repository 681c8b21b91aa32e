#include "wall/elastic_force.hpp"

#include <gtest/gtest.h>

#include <omp.h>

#include <algorithm>

#include "unit/wall/shapes.hpp"

namespace starling {
namespace {

constexpr Real G_s = 7;

struct Law {
    std::string name;
    Material material;
};

void PrintTo(const Law& law, std::ostream* out) { *out << law.name; }

std::vector<Law> laws_with_energy()
{
    return {{"NeoHookean", NeoHookean{G_s}},
            {"MooneyRivlin", MooneyRivlin{G_s, 0.3}},
            {"Skalak", Skalak{G_s, 0.6}}};
}

std::vector<Law> all_laws()
{
    std::vector<Law> laws = laws_with_energy();
    laws.push_back({"Hooke", Hooke{G_s, 0.4}});
    return laws;
}

Tensions tensions(const Material& material, Real lambda1, Real lambda2)
{
    return std::visit([&](const auto& law) { return law.tensions(lambda1, lambda2); }, material);
}

Array<Vec3> forces(const Tube& tube, const Material& material, const Array<Vec3>& x)
{
    Array<Vec3> f(x.size());
    ElasticForce(tube, material).compute(x, f);
    return f;
}

Real largest(const Array<Vec3>& f)
{
    Real m = 0;
    for (const Vec3& a : f) m = std::max(m, norm(a));
    return m;
}

template <class Map>
Array<Vec3> mapped(const Array<Vec3>& x, Map map)
{
    Array<Vec3> y(x.size());
    for (Index v = 0; v < x.size(); ++v) y[v] = map(x[v]);
    return y;
}

/// A flat sheet of cells x cells squares of two triangles in the plane of two directions, dressed
/// as a tube of which every element deforms.
Tube flat_sheet(VertexIndex cells, const Vec3& e1, const Vec3& e2)
{
    Tube sheet;
    std::vector<std::array<VertexIndex, 3>> elements;
    const VertexIndex row = cells + 1;
    for (VertexIndex i = 0; i <= cells; ++i)
        for (VertexIndex j = 0; j <= cells; ++j) {
            sheet.X.push_back((0.3 * i + 0.05 * j) * e1 + 0.2 * j * e2);
            if (i == cells || j == cells) continue;
            const VertexIndex a = i * row + j, b = a + row, c = b + 1, d = a + 1;
            elements.push_back({a, b, c});
            elements.push_back({a, c, d});
        }
    sheet.mesh = WallMesh(row * row, std::move(elements));
    sheet.ring_size = 1;
    sheet.clamp_out = cells * cells;
    return sheet;
}

/// Membrane forces of a sheet under the uniform Cauchy tension T: every side of the boundary pulls
/// half of T . (outward normal) * length inwards at both of its ends; nothing acts inside.
template <class Tension>
Array<Vec3> boundary_forces(const WallMesh& mesh, const Array<Vec3>& x, const Vec3& normal,
                            Tension T)
{
    Array<Vec3> f(x.size());
    for (ElementIndex e = 0; e < mesh.element_count(); ++e)
        for (int k = 0; k < 3; ++k) {
            if (mesh.neighbour(e, k) >= 0) continue;
            const VertexIndex a = mesh.element(e)[static_cast<std::size_t>((k + 1) % 3)];
            const VertexIndex b = mesh.element(e)[static_cast<std::size_t>((k + 2) % 3)];
            const Vec3 pull = 0.5 * T(cross(x[b] - x[a], normal));
            f[a] -= pull;
            f[b] -= pull;
        }
    return f;
}

struct EveryLaw : testing::TestWithParam<Law> {
    const Material& material = GetParam().material;
    Tube tube = make_tube(support::short_tube(), 0.3);
    Array<Vec3> rest = WallState(tube).x;

    Array<Vec3> deformed() const
    {
        Array<Vec3> x = support::positions(tube, support::random_smooth(1, 0.5));
        support::shake(tube, x, 0.03);
        return x;
    }
};

TEST_P(EveryLaw, UniformStretchGivesTheClosedFormTensions)
{
    const Vec3 E1{0.6, 0.8, 0}, E2{0, 0, 1};                            // undeformed plane
    const Vec3 m1{2. / 3, 1. / 3, 2. / 3}, m2{-2. / 3, 2. / 3, 1. / 3}; // deformed plane
    const Tube sheet = flat_sheet(4, E1, E2);
    for (const auto& [l1, l2] : std::vector<std::pair<Real, Real>>{
             {1, 1}, {1.3, 1}, {1, 1.3}, {1.2, 1.2}, {1.6, 0.8}, {0.7, 0.9}, {2.5, 2}})
        for (Real angle : {0., 0.4, 1.1, 2.5}) { // of the principal directions in the plane
            const Vec3 M1 = std::cos(angle) * E1 + std::sin(angle) * E2;
            const Vec3 M2 = -std::sin(angle) * E1 + std::cos(angle) * E2;
            const Array<Vec3> x = mapped(WallState(sheet).x, [&, l1 = l1, l2 = l2](const Vec3& X) {
                return l1 * dot(M1, X) * m1 + l2 * dot(M2, X) * m2 + Vec3{3, -1, 2};
            });
            const Tensions tau = tensions(material, l1, l2);
            const Array<Vec3> expected =
                boundary_forces(sheet.mesh, x, cross(m1, m2), [&](const Vec3& n) {
                    return tau.tau1 * dot(m1, n) * m1 + tau.tau2 * dot(m2, n) * m2;
                });
            const Array<Vec3> f = forces(sheet, material, x);
            for (Index v = 0; v < f.size(); ++v)
                EXPECT_LT(norm(f[v] - expected[v]), 1e-13 * G_s * (1 + std::abs(tau.tau1)))
                    << l1 << " " << l2 << " " << angle;
        }
}

TEST_P(EveryLaw, SimpleShearGivesTheClosedFormTensions)
{
    // F = I + gamma e1 e2: principal stretches l and 1/l with l - 1/l = gamma
    const Real gamma = 0.7, l = gamma / 2 + std::sqrt(1 + gamma * gamma / 4);
    const Vec3 e1{1, 0, 0}, e2{0, 1, 0};
    const Tube sheet = flat_sheet(3, e1, e2);
    const Array<Vec3> x =
        mapped(WallState(sheet).x, [&](const Vec3& X) { return X + gamma * X.y * e1; });
    // B = F F^T has the eigenvalue l^2 along (l, 1), normalised
    const Vec3 n1 = (1 / std::hypot(l, 1)) * Vec3{l, 1, 0}, n2{-n1.y, n1.x, 0};
    const Tensions tau = tensions(material, l, 1 / l);
    const Array<Vec3> expected = boundary_forces(sheet.mesh, x, {0, 0, 1}, [&](const Vec3& n) {
        return tau.tau1 * dot(n1, n) * n1 + tau.tau2 * dot(n2, n) * n2;
    });
    const Array<Vec3> f = forces(sheet, material, x);
    for (Index v = 0; v < f.size(); ++v) EXPECT_LT(norm(f[v] - expected[v]), 1e-13 * G_s);
}

TEST_P(EveryLaw, VanishesUnderRigidMotion)
{
    EXPECT_LT(largest(forces(tube, material, rest)), 1e-13 * G_s);
    const Array<Vec3> x = mapped(rest, [](const Vec3& X) {
        return support::rotated(X, {1, -2, 0.5}, 2.1) + Vec3{10, -3, 7};
    });
    EXPECT_LT(largest(forces(tube, material, x)), 1e-12 * G_s);
}

TEST_P(EveryLaw, TurnsWithTheWall)
{
    const auto turn = [](const Vec3& a) { return support::rotated(a, {0.3, 1, -0.5}, 1.2); };
    const Array<Vec3> x = deformed(), f = forces(tube, material, x);
    const Array<Vec3> g = forces(tube, material, mapped(x, turn));
    for (Index v = 0; v < f.size(); ++v) EXPECT_LT(norm(g[v] - turn(f[v])), 1e-12 * largest(f));
}

TEST_P(EveryLaw, HasNoNetForceAndNoNetTorque)
{
    const Array<Vec3> x = deformed(), f = forces(tube, material, x);
    Vec3 force, torque;
    for (Index v = 0; v < f.size(); ++v) {
        force += f[v];
        torque += cross(x[v], f[v]);
    }
    EXPECT_GT(largest(f), 0.1 * G_s * 0.3);
    EXPECT_LT(norm(force), 1e-12 * largest(f));
    EXPECT_LT(norm(torque), 1e-12 * largest(f));
}

TEST_P(EveryLaw, ActsOnlyOnElementsThatCanDeform)
{
    const Array<Vec3> f = forces(tube, material, deformed());
    for (VertexIndex v = 0; v < tube.mesh.vertex_count(); ++v)
        if (v < tube.first(tube.clamp_in) || v >= tube.first(tube.clamp_out + 1)) {
            EXPECT_EQ(norm(f[v]), 0);
        }
}

/// Relative error of the radial force on a ring of the tube inflated to radius R. A ring carries
/// tau2/R on its share of the area, 2 pi R times the distance of rings; the rings are apart far
/// from the clamps, where the wall is inflated uniformly.
Real ring_force_error(const Material& material, Real edge, Real R)
{
    const Tube tube = make_tube(support::short_tube(), edge);
    const Array<Vec3> x = mapped(WallState(tube).x, [R](const Vec3& X) {
        return Vec3{X.x, R * X.y, R * X.z};
    });
    const Array<Vec3> f = forces(tube, material, x);
    const Index ring = (tube.clamp_in + tube.clamp_out) / 2;
    Real radial = 0;
    for (VertexIndex v = tube.first(ring); v < tube.first(ring + 1); ++v) {
        EXPECT_NEAR(f[v].x, 0, 1e-12 * G_s);
        radial += (f[v].y * x[v].y + f[v].z * x[v].z) / R;
    }
    const auto r = static_cast<std::size_t>(ring);
    const Real expected =
        -2 * pi * tensions(material, 1, R).tau2 * (tube.ring_x[r + 1] - tube.ring_x[r]);
    return radial / expected - 1;
}

TEST_P(EveryLaw, InflatedRingCarriesItsHoopTension)
{
    // second order in the edge
    for (Real R : {0.8, 1.1, 1.5, 2.})
        for (Real edge : {0.2, 0.1, 0.05})
            EXPECT_LT(std::abs(ring_force_error(material, edge, R)), 0.2 * edge * edge)
                << R << " " << edge;
}

TEST_P(EveryLaw, DoesNotDependOnThreads)
{
    const Array<Vec3> x = deformed();
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const Array<Vec3> one = forces(tube, material, x);
    omp_set_num_threads(2);
    const Array<Vec3> two = forces(tube, material, x);
    omp_set_num_threads(before);
    EXPECT_TRUE(std::ranges::equal(one, two));
}

const auto law_name = [](const auto& law) { return law.param.name; };

INSTANTIATE_TEST_SUITE_P(ElasticForce, EveryLaw, testing::ValuesIn(all_laws()), law_name);

struct LawWithEnergy : EveryLaw {};

TEST_P(LawWithEnergy, ForceIsMinusTheGradientOfTheEnergy)
{
    const Tube coarse = make_tube(support::short_tube(), 0.6);
    Array<Vec3> x = support::positions(coarse, support::random_smooth(1, 0.5));
    support::shake(coarse, x, 0.1);
    ElasticForce elastic(coarse, material);
    Array<Vec3> f(x.size());
    elastic.compute(x, f);
    const Real h = 1e-5;
    for (VertexIndex v = coarse.first(coarse.clamp_in); v < coarse.first(coarse.clamp_out + 1); ++v)
        for (const Vec3& e : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
            const Vec3 before = x[v];
            x[v] = before + h * e;
            const Real up = elastic.energy(x);
            x[v] = before - h * e;
            const Real down = elastic.energy(x);
            x[v] = before;
            EXPECT_NEAR(dot(f[v], e), -(up - down) / (2 * h), 1e-7 * largest(f));
        }
}

TEST_P(LawWithEnergy, TensionsAndEnergyGiveTheSameForceToRoundOff)
{
    const Array<Vec3> x = deformed(), f = forces(tube, material, x);
    Array<Vec3> g(x.size());
    ElasticForce(tube, material).compute_from_energy(x, g);
    for (Index v = 0; v < f.size(); ++v) EXPECT_LT(norm(f[v] - g[v]), 1e-12 * largest(f));
}

INSTANTIATE_TEST_SUITE_P(ElasticForce, LawWithEnergy, testing::ValuesIn(laws_with_energy()),
                         law_name);

TEST(ElasticForce, HookeHasNoEnergy)
{
    const Tube tube = make_tube(support::short_tube(), 0.5);
    const Array<Vec3> x = WallState(tube).x;
    Array<Vec3> f(x.size());
    ElasticForce elastic(tube, Hooke{G_s, 0.5});
    EXPECT_TRUE(std::isnan(elastic.energy(x)));
    EXPECT_THROW(elastic.compute_from_energy(x, f), std::invalid_argument);
}

TEST(ElasticForce, HookeIsTheGradientOfAnEnergyAtPoissonRatioOneThird)
{
    // with nu = 1/3 the power of a closed path vanishes: go round a loop in the space of two
    // vertices and integrate f . dx
    const Tube tube = make_tube(support::short_tube(), 0.6);
    const auto work = [&](Real nu) {
        ElasticForce elastic(tube, Hooke{G_s, nu});
        Array<Vec3> x = support::positions(tube, support::random_smooth(1, 0.5)), f(x.size());
        const VertexIndex a = tube.moving_begin() + 3;
        const Vec3 centre = x[a];
        const int steps = 400;
        Real sum = 0;
        for (int n = 0; n < steps; ++n) {
            const Real angle = 2 * pi * n / steps;
            x[a] = centre + 0.1 * Vec3{std::cos(angle), std::sin(angle), 0};
            elastic.compute(x, f);
            sum += dot(f[a], 0.1 * 2 * pi / steps * Vec3{-std::sin(angle), std::cos(angle), 0});
        }
        return sum;
    };
    EXPECT_NEAR(work(1. / 3), 0, 1e-12 * G_s);
    EXPECT_GT(std::abs(work(0.5)), 1e-6 * G_s);
}

TEST(ElasticForce, RigidTubeHasNoElements)
{
    const Tube tube = make_tube({.length = 2, .rigid = true}, 0.3);
    Array<Vec3> x = WallState(tube).x;
    for (Vec3& a : x) a *= 1.1;
    EXPECT_EQ(largest(forces(tube, NeoHookean{G_s}, x)), 0);
    EXPECT_EQ(ElasticForce(tube, NeoHookean{G_s}).energy(x), 0);
}

TEST(ElasticForce, StretchesOfAnInflatedTubeAreItsRadiusAndOne)
{
    const Tube tube = make_tube(support::short_tube(), 0.05);
    const ElasticForce elastic(tube, Hooke{G_s, 0.5});
    const Array<Vec3> x = mapped(WallState(tube).x, [](const Vec3& X) {
        return Vec3{X.x, 1.7 * X.y, 1.7 * X.z};
    });
    for (ElementIndex e = 0; e < tube.mesh.element_count(); ++e) {
        EXPECT_NEAR(elastic.stretches(x, e)[0], 1.7, 1e-12);
        EXPECT_NEAR(elastic.stretches(x, e)[1], 1, 1e-3);
    }
}

} // namespace
} // namespace starling
