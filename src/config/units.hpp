#pragma once
/// Values with units, such as "5 mm", "120 mmHg" or "4 mPa s".
#include <string_view>

namespace starling {

/// Powers of kilogram, metre and second.
struct Dimension {
    int mass = 0, length = 0, time = 0;
    friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// A value in SI units. Wider than Real so that a written case reads back to the same bits.
struct Measure {
    long double value = 0;
    Dimension dimension;
};

/// Reads a number and a product of prefixed units ("mPa s", "kg/m^3", "ml/min", "um").
/// Throws std::invalid_argument, with what is wrong, on anything else.
Measure parse_measure(std::string_view text);

/// The unit in such a text, as it is written there: "mm" of "5 mm"; empty where it has none.
std::string_view written_unit(std::string_view text);

} // namespace starling
