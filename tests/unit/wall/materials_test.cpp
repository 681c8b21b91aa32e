#include "wall/materials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace starling {
namespace {

constexpr Real G_s = 7;

std::vector<std::pair<Real, Real>> stretches()
{
    return {{1, 1}, {1.2, 1}, {1, 0.8}, {1.1, 1.4}, {0.7, 1.3}, {1.6, 2.5}, {0.9, 0.6}};
}

Real invariant1(Real l1, Real l2) { return l1 * l1 + l2 * l2 - 2; }
Real invariant2(Real l1, Real l2) { return l1 * l1 * l2 * l2 - 1; }

std::vector<Material> laws_with_energy()
{
    return {NeoHookean{G_s}, MooneyRivlin{G_s, 0.3}, Skalak{G_s, 0.6}};
}

std::vector<Material> laws_that_agree()
{
    return {Hooke{G_s, 0.5}, NeoHookean{G_s}, MooneyRivlin{G_s, 0.4}, Skalak{G_s, 1}};
}

Tensions tensions(const Material& material, Real l1, Real l2)
{
    return std::visit([&](const auto& law) { return law.tensions(l1, l2); }, material);
}

/// Calls check(law) for each law that has an energy.
template <class Check>
void for_each_energy(Check check)
{
    for (const Material& material : laws_with_energy())
        std::visit(
            [&](const auto& law) {
                if constexpr (std::decay_t<decltype(law)>::has_energy) check(law);
            },
            material);
}

TEST(Materials, TensionsAreTheDerivativeOfTheEnergy)
{
    for_each_energy([](const auto& law) {
        const Real h = 1e-5;
        const auto W = [&](Real l1, Real l2) {
            return law.energy(invariant1(l1, l2), invariant2(l1, l2));
        };
        for (const auto& [l1, l2] : stretches()) {
            const Tensions tau = law.tensions(l1, l2);
            EXPECT_NEAR(tau.tau1, (W(l1 + h, l2) - W(l1 - h, l2)) / (2 * h * l2), 1e-6 * G_s);
            EXPECT_NEAR(tau.tau2, (W(l1, l2 + h) - W(l1, l2 - h)) / (2 * h * l1), 1e-6 * G_s);
        }
    });
}

TEST(Materials, EnergyGradientGivesTheTensionsToRoundOff)
{
    for_each_energy([](const auto& law) {
        for (const auto& [l1, l2] : stretches()) {
            const EnergyGradient dW = law.energy_gradient(invariant1(l1, l2), invariant2(l1, l2));
            const Tensions tau = law.tensions(l1, l2);
            const Real scale = 1e-13 * G_s * (1 + std::abs(tau.tau1) + std::abs(tau.tau2));
            EXPECT_NEAR(tau.tau1, 2 * l1 / l2 * dW.dI1 + 2 * l1 * l2 * dW.dI2, scale);
            EXPECT_NEAR(tau.tau2, 2 * l2 / l1 * dW.dI1 + 2 * l1 * l2 * dW.dI2, scale);
        }
    });
}

TEST(Materials, UnstrainedWallHasNeitherEnergyNorTension)
{
    for_each_energy([](const auto& law) { EXPECT_NEAR(law.energy(0, 0), 0, 1e-14 * G_s); });
    for (const Material& material : laws_that_agree()) {
        EXPECT_EQ(tensions(material, 1, 1).tau1, 0);
        EXPECT_EQ(tensions(material, 1, 1).tau2, 0);
    }
}

TEST(Materials, LawsAgreeToFirstOrderInTheStrain)
{
    const auto difference = [](Real size) {
        Real largest = 0;
        const Tensions hooke = tensions(laws_that_agree()[0], 1 + size, 1 - 0.7 * size);
        for (const Material& material : laws_that_agree()) {
            const Tensions tau = tensions(material, 1 + size, 1 - 0.7 * size);
            largest = std::max(
                {largest, std::abs(tau.tau1 - hooke.tau1), std::abs(tau.tau2 - hooke.tau2)});
        }
        return largest / G_s;
    };
    EXPECT_LT(difference(1e-4), 1e-6);
    EXPECT_NEAR(difference(1e-4) / difference(1e-3), 0.01, 5e-4);
}

TEST(Materials, LawsAreIsotropic)
{
    for (const Material& material : laws_that_agree())
        for (const auto& [l1, l2] : stretches()) {
            const Tensions a = tensions(material, l1, l2), b = tensions(material, l2, l1);
            EXPECT_DOUBLE_EQ(a.tau1, b.tau2);
            EXPECT_DOUBLE_EQ(a.tau2, b.tau1);
        }
}

TEST(Materials, MooneyRivlinAtPsiOneIsNeoHookean)
{
    for (const auto& [l1, l2] : stretches()) {
        const Tensions a = MooneyRivlin{G_s, 1}.tensions(l1, l2);
        const Tensions b = NeoHookean{G_s}.tensions(l1, l2);
        EXPECT_DOUBLE_EQ(a.tau1, b.tau1);
        EXPECT_DOUBLE_EQ(a.tau2, b.tau2);
    }
}

TEST(Materials, HookeHasTheYoungModulusOfEquation9)
{
    // Uniaxial tension: tau2 = 0 needs e2 = -nu e1, then tau1 = E_s e1 with the Green strain e1.
    const Real nu = 0.3, e1 = 0.2, E_s = 2 * (1 + nu) * G_s;
    const Tensions tau = Hooke{G_s, nu}.tensions(std::sqrt(1 + 2 * e1), std::sqrt(1 - 2 * nu * e1));
    EXPECT_NEAR(tau.tau1, E_s * e1, 1e-13 * G_s);
    EXPECT_NEAR(tau.tau2, 0, 1e-13 * G_s);
}

TEST(Materials, ModulusFollowsTheDeformability)
{
    MaterialParameters p;
    p.eps = 0.02;
    const Real expected = 1 / (0.1 * 0.02);
    EXPECT_DOUBLE_EQ(std::get<Hooke>(make_material(p, 0.1)).G_s, expected);
    p.law = ElasticLaw::neo_hookean;
    EXPECT_DOUBLE_EQ(std::get<NeoHookean>(make_material(p, 0.1)).G_s, expected);
    p.law = ElasticLaw::mooney_rivlin;
    p.psi = 0.25;
    EXPECT_EQ(std::get<MooneyRivlin>(make_material(p, 0.1)).psi, 0.25);
    p.law = ElasticLaw::skalak;
    p.skalak_C = 2;
    EXPECT_EQ(std::get<Skalak>(make_material(p, 0.1)).C, 2);
}

} // namespace
} // namespace starling
