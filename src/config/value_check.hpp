#pragma once
/// One value of a case file against the rule of its key.
#include <array>
#include <string>
#include <variant>

#include "config/case_keys.hpp"
#include "config/document.hpp"

namespace starling {

/// A value of the type its rule asks for; numbers and measures (in SI where the file is) are
/// long double, "auto" is a string.
using CheckedValue =
    std::variant<bool, Index, long double, std::string, std::array<Index, 3>, std::vector<Real>>;

/// What a key takes, for messages: "a plain number from 0.5 to 1", `one of "single", "double"`, "a
/// length with a unit, in quotes (nm, um, mm, m), greater than 0".
std::string what_it_takes(const KeyRule& rule, UnitSystem system);

/// Checks type, unit and, for measures in SI, sign. Throws std::invalid_argument that says what is
/// wrong and what is allowed. Ranges are left to the caller: they need the scaling.
CheckedValue check_value(const KeyRule& rule, const Value& value, UnitSystem system);

} // namespace starling
