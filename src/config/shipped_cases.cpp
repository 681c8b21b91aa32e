#include "config/shipped_cases.hpp"

#include <fmt/format.h>

#include "config/nearest_name.hpp"
#include "config/shipped_case_texts.hpp" // made by module.cmake from cases/*.toml
#include "core/error.hpp"

namespace starling {

namespace {

std::string_view first_comment(std::string_view text)
{
    const std::string_view line = text.substr(0, text.find('\n'));
    const auto start = line.find_first_not_of("# ");
    return start == std::string_view::npos ? "" : line.substr(start);
}

std::vector<std::string_view> names()
{
    std::vector<std::string_view> list;
    for (const ShippedCase& c : shipped_cases()) list.push_back(c.name);
    return list;
}

} // namespace

const std::vector<ShippedCase>& shipped_cases()
{
    static const std::vector<ShippedCase> cases = [] {
        std::vector<ShippedCase> list;
        for (const auto& [name, text] : shipped_case_texts)
            list.push_back({name, first_comment(text), text});
        return list;
    }();
    return cases;
}

const ShippedCase& shipped_case(std::string_view name)
{
    for (const ShippedCase& c : shipped_cases())
        if (c.name == name) return c;
    throw InputError(
        fmt::format("no shipped case {}; {}", in_quotes(name), suggestion(name, names())));
}

std::string shipped_cases_hint()
{
    const std::string_view name = shipped_cases().front().name;
    return fmt::format("\"starling cases {0} > {0}.toml\" writes a shipped one", name);
}

} // namespace starling
