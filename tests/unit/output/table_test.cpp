#include <gtest/gtest.h>

#include "output/profile.hpp"
#include "output/read_table.hpp"
#include "output/series.hpp"
#include "synthetic.hpp"
#include "temporary_directory.hpp"

namespace starling {
namespace {

std::vector<std::vector<std::string>> read_csv(const std::filesystem::path& path)
{
    std::vector<std::vector<std::string>> rows;
    std::ifstream stream(path);
    for (std::string line; std::getline(stream, line);) {
        std::vector<std::string> cells(1);
        for (char c : line)
            if (c == ',')
                cells.emplace_back();
            else
                cells.back() += c;
        rows.push_back(cells);
    }
    return rows;
}

TEST(Series, HeaderNamesEveryColumnWithItsUnit)
{
    TemporaryDirectory dir;
    SeriesWriter writer(dir.path() / "series.csv", synthetic::si_scaling());
    const auto rows = read_csv(dir.path() / "series.csv");
    ASSERT_EQ(rows.size(), 1u);
    ASSERT_EQ(rows[0].size(), sample_columns().size());
    EXPECT_EQ(rows[0][0], "t [s]");
    EXPECT_EQ(rows[0][1], "step [1]");
    EXPECT_EQ(rows[0][3], "Q_in [m^3/s]");
}

TEST(Series, EveryMemberOfSampleHasAColumn)
{
    // Sample holds nothing but numbers of eight bytes, one per column.
    EXPECT_EQ(sample_columns().size() * sizeof(Real), sizeof(Sample));
}

TEST(Series, RowIsOnDiskInTheUnitsOfTheCaseWhenWriteReturns)
{
    TemporaryDirectory dir;
    SeriesWriter writer(dir.path() / "series.csv", synthetic::si_scaling());
    Sample s;
    s.t = 0.3;
    s.step = 7;
    s.Q_in = 1;
    writer.write(s);
    const auto rows = read_csv(dir.path() / "series.csv");
    ASSERT_EQ(rows.size(), 2u);
    ASSERT_EQ(rows[1].size(), rows[0].size());
    EXPECT_DOUBLE_EQ(std::stod(rows[1][0]), 0.3 * 2 / 3);
    EXPECT_EQ(rows[1][1], "7");
    EXPECT_DOUBLE_EQ(std::stod(rows[1][3]), 12);
}

TEST(Series, NumbersReadBackToTheSameBits)
{
    for (Real value : {1.0 / 3, 0.1 + 0.2, 6.02214076e23, -1e-300})
        EXPECT_EQ(std::stod(number_text(value)), value);
}

TEST(Series, MeanLeakIsOfTheLastHalfUpToAStep)
{
    TemporaryDirectory dir;
    const std::filesystem::path path = dir.path() / "series.csv";
    {
        SeriesWriter writer(path, synthetic::si_scaling());
        for (Index step : {0, 10, 20, 30, 40, 50}) {
            Sample s;
            s.step = step;
            s.t = 0.1 * static_cast<Real>(step);
            s.Q_in = 2;
            s.Q_out = step == 30 ? -6 : 1;
            s.leak = step < 20 || step == 50 ? 100 : step == 30 ? -0.5 : 0.1; // beyond: wild
            writer.write(s);
        }
    }
    EXPECT_NEAR(mean_leak_over_Q(path, 40), 0.7 / 10, 1e-12);
    EXPECT_NEAR(mean_leak_over_Q(path, 45), 0.7 / 10, 1e-12);
    EXPECT_GT(mean_leak_over_Q(path, 50), 1);
    std::string text = read_text(path);
    text[text.find('\n', text.find('\n') + 1) - 1] = 'x'; // in the first row
    std::ofstream(path) << text;
    EXPECT_TRUE(std::isnan(mean_leak_over_Q(path, 40)));
}

TEST(Series, FullDeviceIsReported)
{
    const std::filesystem::path full = "/dev/full";
    if (!std::filesystem::exists(full)) GTEST_SKIP() << "no /dev/full here";
    EXPECT_THROW(SeriesWriter(full, Scaling{}), std::runtime_error);
}

TEST(Profile, HasOneRowPerPlane)
{
    TemporaryDirectory dir;
    std::vector<ProfileRow> profile(3);
    profile[2].x = 1.5;
    profile[2].P_centre = 4;
    write_profile(dir.path() / "profile.csv", profile, Scaling{});
    const auto rows = read_csv(dir.path() / "profile.csv");
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[0][5], "P_centre [rho U_c^2]");
    EXPECT_EQ(rows[3][0], "1.5");
    EXPECT_EQ(rows[3][5], "4");
}

TEST(Profile, EveryMemberOfProfileRowHasAColumn)
{
    EXPECT_EQ(profile_columns().size() * sizeof(Real), sizeof(ProfileRow));
}

} // namespace
} // namespace starling
