#include "theory/wave_speed.hpp"

#include <gtest/gtest.h>

#include "wall/materials.hpp"

namespace starling {
namespace {

constexpr Real Re = 10;

MaterialParameters material(ElasticLaw law)
{
    MaterialParameters m;
    m.law = law;
    m.eps = 0.02;
    return m;
}

TEST(WaveSpeed, HookeGivesMoensKorteweg)
{
    MaterialParameters m = material(ElasticLaw::hooke);
    m.poisson_ratio = 0.3;
    EXPECT_NEAR(wave_speed(m, Re), 1 / std::sqrt(Re * m.eps * (1 - 0.3)), 1e-14);
}

TEST(WaveSpeed, TissueAroundAddsHalfItsStiffnessToTheSquare)
{
    MaterialParameters m = material(ElasticLaw::hooke);
    m.support.stiffness = 6;
    EXPECT_NEAR(std::pow(wave_speed(m, Re), 2), 1 / (Re * m.eps * 0.5) + 3, 1e-12);
}

TEST(WaveSpeed, LawsAgreeOnTheUndeformedTube)
{
    const Real hooke = wave_speed(material(ElasticLaw::hooke), Re);
    for (const ElasticLaw law :
         {ElasticLaw::neo_hookean, ElasticLaw::mooney_rivlin, ElasticLaw::skalak})
        EXPECT_NEAR(wave_speed(material(law), Re), hooke, 1e-13 * hooke);
}

TEST(WaveSpeed, InflatedTubeMatchesADifferenceOfThePressure)
{
    const MaterialParameters m = material(ElasticLaw::skalak);
    const Skalak law = std::get<Skalak>(make_material(m, Re));
    const Real R = 1.3, h = 1e-5;
    const auto P = [&](Real r) { return law.tensions(1.0, r).tau2 / r; };
    const Real c2 = R / 2 * (P(R + h) - P(R - h)) / (2 * h);
    EXPECT_NEAR(wave_speed(m, Re, R), std::sqrt(c2), 1e-8 * std::sqrt(c2));
}

TEST(WaveSpeed, SofteningWallSlowsWavesAndHardeningWallSpeedsThem)
{
    const Real R = 1.5;
    EXPECT_LT(wave_speed(material(ElasticLaw::neo_hookean), Re, R),
              wave_speed(material(ElasticLaw::neo_hookean), Re));
    EXPECT_GT(wave_speed(material(ElasticLaw::skalak), Re, R),
              wave_speed(material(ElasticLaw::skalak), Re));
}

} // namespace
} // namespace starling
