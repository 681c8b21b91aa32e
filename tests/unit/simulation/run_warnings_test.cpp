#include "simulation/run_warnings.hpp"

#include <gtest/gtest.h>

namespace starling {
namespace {

/// Of a steady run that leaks as the scheme should not.
struct Leaking : testing::Test {
    Case c;
    Summary s;

    Leaking()
    {
        s.converged = true;
        s.spacing = 0.1;
        s.last.Q_in = s.last.Q_mid = s.last.Q_out = 2;
        s.last.smallest_gap = 2;
        s.last.leak = -0.1;
    }
    std::string warning() const
    {
        const auto found = run_warnings(c, s, 1);
        return found.size() == 1 ? found[0] : "";
    }
    bool says(const std::string& words) const { return warning().find(words) != std::string::npos; }
};

TEST_F(Leaking, LittleIsNoWarning)
{
    s.last.leak = 0.03;
    EXPECT_TRUE(run_warnings(c, s, 1).empty());
}

TEST_F(Leaking, BeforeTheLastSampleIsToldToo)
{
    s.last.leak = 0; // as at one moment of a period
    s.mean_leak_over_Q = 0.04;
    EXPECT_EQ(warning(),
              "the leak through the wall was 4 % of the flow on the mean of the last half "
              "of the time: take a finer grid");
}

TEST_F(Leaking, InASteadyTubeWantsAFinerGrid)
{
    EXPECT_EQ(warning(), "the leak through the wall is -5 % of the flow: take a finer grid");
}

TEST_F(Leaking, OfAnotherSchemeNamesTheTightOne)
{
    c.coupling.scheme = CouplingScheme::printed;
    EXPECT_TRUE(says("conserving"));
}

TEST_F(Leaking, BeforeTheSteadyStateMayPass)
{
    s.converged = false;
    EXPECT_TRUE(says("wait for the steady state"));
}

TEST(RunWarnings, NameNarrowGapsAndASmallerStep)
{
    Case c;
    Summary s;
    s.converged = true;
    s.spacing = 0.2;
    s.last.smallest_gap = 0.3;
    const auto found = run_warnings(c, s, 0.25);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NE(found[0].find("1.5 grid spacings"), std::string::npos);
    EXPECT_NE(found[1].find("25 % of the automatic"), std::string::npos);
}

} // namespace
} // namespace starling
