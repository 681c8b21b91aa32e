#pragma once
/// The case files of cases/, carried inside the program.
#include <string>
#include <string_view>
#include <vector>

namespace starling {

struct ShippedCase {
    std::string_view name;        ///< without ".toml"
    std::string_view description; ///< its first comment line
    std::string_view text;
};

const std::vector<ShippedCase>& shipped_cases();

/// The shipped case of that name; throws InputError with the nearest name.
const ShippedCase& shipped_case(std::string_view name);

/// How to get a shipped case, for a message about a missing file.
std::string shipped_cases_hint();

} // namespace starling
