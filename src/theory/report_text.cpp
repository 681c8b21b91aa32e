#include "theory/report_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace starling {

void add_line(std::string& text, std::string_view label, Real value, std::string_view unit)
{
    const std::string number = std::isnan(value) ? "none" : fmt::format("{:.6g}", value);
    fmt::format_to(std::back_inserter(text), "  {:<44}{:>12}{}{}\n", label, number,
                   unit.empty() ? "" : " ", unit);
}

std::string cell(Real value)
{
    return std::isnan(value) ? fmt::format("{:>14}", "-") : fmt::format("{:>14.6g}", value);
}

std::string heading(std::string_view quantity, const std::string& unit)
{
    return fmt::format("{} [{}]", quantity, unit);
}

} // namespace starling
