#include "config/document.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "config/nearest_name.hpp"

namespace starling {

namespace {

constexpr const char* override_file = "--set";

int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

/// Whole numbers if all are, else numbers.
Value array_value(const toml::array& array)
{
    std::vector<Index> counts;
    std::vector<Real> numbers;
    for (const toml::node& element : array) {
        if (!element.is_number()) return OtherValue{"an array of other things than numbers"};
        numbers.push_back(*element.value<double>());
        if (element.is_integer()) counts.push_back(element.as_integer()->get());
    }
    if (counts.size() == numbers.size()) return counts;
    return numbers;
}

Value to_value(const toml::node& node)
{
    if (const auto* v = node.as_boolean()) return v->get();
    if (const auto* v = node.as_integer()) return Index{v->get()};
    if (const auto* v = node.as_floating_point()) return v->get();
    if (const auto* v = node.as_string()) return v->get();
    if (const auto* v = node.as_array()) return array_value(*v);
    return OtherValue{node.is_table() ? "a table" : "a date or time"};
}

toml::table parse_toml(std::string_view text, const std::string& file)
{
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& e) {
        const auto at = e.source().begin;
        throw InputError(
            {{file, static_cast<int>(at.line), "",
              fmt::format("no valid TOML (column {}): {}", at.column, e.description())}});
    }
}

void add_section(Document& d, const std::string& section, const toml::table& table)
{
    d.sections[section] = {d.file, line_of(table)};
    for (const auto& [key, node] : table)
        d.entries.push_back(
            {section, std::string(key.str()), to_value(node), {d.file, line_of(node)}});
}

/// A number, boolean, array or quoted string as in TOML; anything else is a bare string.
std::optional<Value> override_value(const std::string& text)
{
    if (text.find('\n') != std::string::npos) return std::nullopt;
    try {
        const toml::table t = toml::parse("value = " + text);
        if (t.size() == 1 && t.contains("value")) return to_value(*t.get("value"));
    } catch (const toml::parse_error&) { // a bare string
    }
    if (text.find('\'') != std::string::npos) return std::nullopt;
    try {
        return to_value(*toml::parse("value = '" + text + "'").get("value"));
    } catch (const toml::parse_error&) { // not even UTF-8
        return std::nullopt;
    }
}

std::string trimmed(const std::string& text)
{
    const auto first = text.find_first_not_of(' ');
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

void apply_override(Document& d, const std::string& assignment)
{
    const auto reject = [&](const std::string& message) {
        d.problems.push_back({override_file, 0, "", in_quotes(assignment) + ": " + message});
    };
    const auto equals = assignment.find('=');
    if (equals == std::string::npos) return reject("must be section.key=value");
    const std::string name = trimmed(assignment.substr(0, equals));
    const auto dot = name.find('.');
    const std::string section = dot == std::string::npos ? "" : name.substr(0, dot);
    const std::string key = dot == std::string::npos ? name : name.substr(dot + 1);
    if (key.empty() || (dot == 0)) return reject("must be section.key=value");

    const std::string text = trimmed(assignment.substr(equals + 1));
    std::erase_if(d.entries, [&](const Entry& e) { return e.section == section && e.key == key; });
    if (text.empty()) return;
    const std::optional<Value> value = override_value(text);
    if (!value) return reject("the value is neither TOML nor plain text");
    if (!section.empty()) d.sections.try_emplace(section, Place{override_file, 0});
    d.entries.push_back({section, key, *value, {override_file, 0}});
}

} // namespace

Document parse_document(std::string_view text, const std::string& file,
                        const std::vector<std::string>& overrides)
{
    Document d{file, {}, {}, {}};
    const toml::table root = parse_toml(text, file);
    for (const auto& [key, node] : root) {
        const std::string name = key.str().empty() ? "\"\"" : std::string(key.str());
        if (const toml::table* table = node.as_table())
            add_section(d, name, *table);
        else
            d.entries.push_back({"", name, to_value(node), {file, line_of(node)}});
    }
    for (const std::string& assignment : overrides) apply_override(d, assignment);
    return d;
}

} // namespace starling
