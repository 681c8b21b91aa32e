#include "config/quantities.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace starling {

namespace {

struct NamedQuantity {
    Quantity quantity;
    std::string_view name;
    Dimension dimension;
    std::vector<std::string_view> units; ///< from small to large
};

const std::vector<NamedQuantity>& quantities()
{
    static const std::vector<NamedQuantity> table = {
        {Quantity::none, "a plain number", {}, {}},
        {Quantity::length, "a length", {0, 1, 0}, {"nm", "um", "mm", "m"}},
        {Quantity::area, "an area", {0, 2, 0}, {"um^2", "mm^2", "m^2"}},
        {Quantity::volume, "a volume", {0, 3, 0}, {"nl", "ul", "ml", "l", "m^3"}},
        {Quantity::time, "a time", {0, 0, 1}, {"ns", "us", "ms", "s"}},
        {Quantity::velocity, "a velocity", {0, 1, -1}, {"um/s", "mm/s", "m/s"}},
        {Quantity::flow_rate, "a flow rate", {0, 3, -1}, {"ul/min", "ml/min", "m^3/s"}},
        {Quantity::pressure, "a pressure", {1, -1, -2}, {"Pa", "kPa", "MPa"}},
        {Quantity::force, "a force", {1, 1, -2}, {"nN", "uN", "mN", "N"}},
        {Quantity::energy, "an energy", {1, 2, -2}, {"nJ", "uJ", "mJ", "J"}},
        {Quantity::power, "a power", {1, 2, -3}, {"nW", "uW", "mW", "W"}},
        {Quantity::surface_tension, "a force per length", {1, 0, -2}, {"uN/m", "mN/m", "N/m"}},
        {Quantity::shear_stress, "a pressure", {1, -1, -2}, {"Pa", "kPa", "MPa"}},
        {Quantity::rate, "a rate", {0, 0, -1}, {"1/s"}},
        {Quantity::density, "a density", {1, -3, 0}, {"kg/m^3"}},
        {Quantity::viscosity, "a viscosity", {1, -1, -1}, {"mPa s", "Pa s"}},
        {Quantity::flow_resistance, "a flow resistance", {1, -4, -1}, {"Pa s/m^3", "mmHg s/ml"}},
        {Quantity::compliance, "a compliance", {-1, 4, 2}, {"m^3/Pa", "ml/mmHg"}},
        {Quantity::stiffness_per_area,
         "a stiffness per area",
         {1, -2, -2},
         {"Pa/m", "kPa/m", "MPa/m", "GPa/m"}},
        {Quantity::damping_per_area, "a damping per area", {1, -2, -1}, {"Pa s/m", "kPa s/m"}},
        {Quantity::surface_viscosity,
         "a surface viscosity",
         {1, 0, -1},
         {"uPa s m", "mPa s m", "Pa s m"}},
    };
    return table;
}

const NamedQuantity& named(Quantity q)
{
    for (const NamedQuantity& n : quantities())
        if (n.quantity == q) return n;
    throw std::logic_error("quantity without a name");
}

/// The largest usual unit that keeps the number at or above 1.
std::string handy_unit(long double si, Quantity q)
{
    const auto& units = named(q).units;
    if (si == 0 || units.empty()) return Scaling{.si = true}.unit(q);
    for (auto unit = units.rbegin(); unit != units.rend(); ++unit)
        if (std::abs(si) >= parse_measure("1 " + std::string(*unit)).value)
            return std::string(*unit);
    return std::string(units.front());
}

/// At least that many significant digits; without an exponent where that is readable.
std::string decimal(long double value, int digits)
{
    std::array<char, 64> text{};
    const auto print = [&](std::chars_format format, int precision) {
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(), value, format, precision);
        return std::string(text.data(), end.ptr);
    };
    const long double size = std::abs(value);
    if (size < 1e-3L || size >= 1e6L) return print(std::chars_format::general, digits);
    const int leading = 1 + static_cast<int>(std::floor(std::log10(size)));
    return print(std::chars_format::fixed, std::max(0, digits - leading));
}

std::string power(std::string_view unit, int exponent)
{
    if (exponent == 0) return "";
    return exponent == 1 ? fmt::format(" {}", unit) : fmt::format(" {}^{}", unit, exponent);
}

} // namespace

Dimension dimension(Quantity q) { return named(q).dimension; }

std::string describe(Dimension d)
{
    for (const NamedQuantity& n : quantities())
        if (n.dimension == d) return std::string(n.name);
    return "something in" + power("kg", d.mass) + power("m", d.length) + power("s", d.time);
}

std::string usual_units(Quantity q)
{
    std::string units = fmt::format("{}", fmt::join(named(q).units, ", "));
    return dimension(q) == dimension(Quantity::pressure) ? units + ", mmHg, cmH2O" : units;
}

std::string format_measure(long double si, Quantity q, const std::function<bool(long double)>& same)
{
    const std::string unit = handy_unit(si, q);
    const long double factor = parse_measure("1 " + unit).value;
    std::string text;
    for (int digits = 1; digits <= 21; ++digits) {
        text = fmt::format("{} {}", decimal(si / factor, digits), unit);
        if (same(parse_measure(text).value)) break;
    }
    return text;
}

} // namespace starling
