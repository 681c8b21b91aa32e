#pragma once
/// How the reports of the theories write numbers.
#include <string>
#include <string_view>

#include "core/types.hpp"

namespace starling {

/// Appends "  label   value unit"; "none" for NaN.
void add_line(std::string& text, std::string_view label, Real value, std::string_view unit = "");

/// A table cell 14 wide; "-" for NaN.
std::string cell(Real value);

/// "quantity [unit]".
std::string heading(std::string_view quantity, const std::string& unit);

} // namespace starling
