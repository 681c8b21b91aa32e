#include "config/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "config/quantities.hpp"

namespace starling {
namespace {

TEST(Units, AreReadInSi)
{
    struct Reading {
        const char* text;
        double si;
        Quantity quantity;
    };
    const Reading readings[] = {
        {"5 mm", 5e-3, Quantity::length},
        {"5mm", 5e-3, Quantity::length},
        {"+5e-1 cm", 5e-3, Quantity::length},
        {"  5 mm  ", 5e-3, Quantity::length},
        {"25 um", 25e-6, Quantity::length},
        {"25 \xC2\xB5m", 25e-6, Quantity::length},
        {"25 \xCE\xBCm", 25e-6, Quantity::length},
        {"25\xC2\xA0\xC2\xB5m", 25e-6, Quantity::length},
        {"3 m^2", 3, Quantity::area},
        {"3 m2", 3, Quantity::area},
        {"3 mm\xC2\xB2", 3e-6, Quantity::area},
        {"1 ml", 1e-6, Quantity::volume},
        {"1 uL", 1e-9, Quantity::volume},
        {"120 mmHg", 120 * 133.322387415, Quantity::pressure},
        {"1 cmH2O", 98.0665, Quantity::pressure},
        {"50 kPa", 50e3, Quantity::pressure},
        {"-50 kPa", -50e3, Quantity::pressure},
        {"760 Torr", 101325, Quantity::pressure},
        {"0.07 N/mm^2", 70e3, Quantity::pressure},
        {"1060 kg/m^3", 1060, Quantity::density},
        {"1.06 g/cm^3", 1060, Quantity::density},
        {"1060 kg m^-3", 1060, Quantity::density},
        {"1060 kg/m\xC2\xB3", 1060, Quantity::density},
        {"1.06 g/ml", 1060, Quantity::density},
        {"4 mPa s", 4e-3, Quantity::viscosity},
        {"4 mPa*s", 4e-3, Quantity::viscosity},
        {"4 mPa.s", 4e-3, Quantity::viscosity},
        {"4 mPa\xC2\xB7s", 4e-3, Quantity::viscosity},
        {"4 cP", 4e-3, Quantity::viscosity},
        {"0.04 P", 4e-3, Quantity::viscosity},
        {"0.04 g/cm/s", 4e-3, Quantity::viscosity},
        {"0.2 N/m", 0.2, Quantity::surface_tension},
        {"200 dyn/cm", 0.2, Quantity::surface_tension},
        {"4 kPa um", 4e-3, Quantity::surface_tension},
        {"1 ml/min", 1e-6 / 60, Quantity::flow_rate},
        {"2 cm/s", 0.02, Quantity::velocity},
        {"3 s", 3, Quantity::time},
        {"2 h", 7200, Quantity::time},
        {"1 us", 1e-6, Quantity::time},
        {"5 1/s", 5, Quantity::rate},
        {"5 Hz", 5, Quantity::rate},
        {"7", 7, Quantity::none},
    };
    for (const Reading& r : readings) {
        const Measure m = parse_measure(r.text);
        EXPECT_DOUBLE_EQ(static_cast<double>(m.value), r.si) << r.text;
        EXPECT_EQ(m.dimension, dimension(r.quantity)) << r.text;
    }
}

TEST(Units, RefuseWhatIsNoMeasure)
{
    for (const char* text :
         {"",           " ",           "mm",       "nan mm",   "inf mm", "-inf mm",
          "1e99999 mm", "1e-99999 mm", "5 xm",     "5 Mm^",    "5 m^x",  "5 m/",
          "5 /s",       "5 m//s",      "5 kg/m s", "5 (m)",    "5 m,",   "5,0 mm",
          "0x5 mm",     "--5 mm",      "+-5 mm",   "5 mm mm^", "5 mmin", "5 kmin",
          "5 m^-",      "5 \xff",      "5 m\xC2",  "1e4930 Gm"})
        EXPECT_THROW(parse_measure(text), std::invalid_argument) << text;
    EXPECT_THROW(parse_measure(std::string(1000, '1')), std::invalid_argument);
}

TEST(Units, DimensionsHaveNames)
{
    EXPECT_EQ(describe(Dimension{1, -1, -2}), "a pressure");
    EXPECT_EQ(describe(Dimension{1, 0, 3}), "something in kg s^3");
}

TEST(Units, AreWrittenAsShortAsTheyReadBack)
{
    const auto exactly = [](long double wanted) {
        return
            [=](long double si) { return static_cast<double>(si) == static_cast<double>(wanted); };
    };
    EXPECT_EQ(format_measure(5e-3L, Quantity::length, exactly(5e-3L)), "5 mm");
    EXPECT_EQ(format_measure(-70e3L, Quantity::pressure, exactly(-70e3L)), "-70 kPa");
    EXPECT_EQ(format_measure(0, Quantity::pressure, exactly(0)), "0 Pa");
    EXPECT_EQ(format_measure(1e-12L, Quantity::length, exactly(1e-12L)), "0.001 nm");
}

TEST(Units, EveryUsualUnitHasTheDimensionOfItsQuantity)
{
    for (int q = static_cast<int>(Quantity::length); q <= static_cast<int>(Quantity::viscosity);
         ++q) {
        std::string units = usual_units(static_cast<Quantity>(q)) + ", ";
        for (std::size_t at = 0, comma; (comma = units.find(", ", at)) != std::string::npos;
             at = comma + 2)
            EXPECT_EQ(parse_measure("1 " + units.substr(at, comma - at)).dimension,
                      dimension(static_cast<Quantity>(q)));
    }
}

} // namespace
} // namespace starling
