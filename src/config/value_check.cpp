#include "config/value_check.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "config/nearest_name.hpp"
#include "config/quantities.hpp"

namespace starling {

namespace {

[[noreturn]] void fail(const std::string& message) { throw std::invalid_argument(message); }

std::string describe(const Value& value)
{
    if (const auto* v = std::get_if<bool>(&value)) return *v ? "true" : "false";
    if (const auto* v = std::get_if<Index>(&value)) return fmt::format("{}", *v);
    if (const auto* v = std::get_if<Real>(&value)) return fmt::format("{}", *v);
    if (const auto* v = std::get_if<std::string>(&value)) return in_quotes(*v);
    if (const auto* v = std::get_if<std::vector<Index>>(&value))
        return fmt::format("an array of {} whole numbers", v->size());
    if (const auto* v = std::get_if<std::vector<Real>>(&value))
        return fmt::format("an array of {} numbers", v->size());
    return std::get<OtherValue>(value).type;
}

/// The value as a plain number, if it is one.
std::optional<long double> plain_number(const Value& value)
{
    std::optional<long double> number;
    if (const auto* v = std::get_if<Index>(&value)) number = static_cast<Real>(*v);
    if (const auto* v = std::get_if<Real>(&value)) number = *v;
    if (number && !std::isfinite(*number)) fail(fmt::format("is {}; must be finite", *number));
    return number;
}

long double number_value(const Value& value)
{
    if (const auto number = plain_number(value)) return *number;
    fail(fmt::format("is {}; must be a plain number", describe(value)));
}

long double with_unit(const std::string& text, Quantity q)
{
    const auto explain = [&](const std::string& what) {
        fail(fmt::format("{} {}; must be {} ({})", in_quotes(text), what, describe(dimension(q)),
                         usual_units(q)));
    };
    Measure m;
    try {
        m = parse_measure(text);
    } catch (const std::invalid_argument& e) {
        explain(fmt::format("cannot be read: {}", e.what()));
    }
    if (m.dimension == Dimension{} && m.value != 0) explain("has no unit");
    if (m.dimension != dimension(q) && m.dimension != Dimension{})
        explain("is " + describe(m.dimension));
    return m.value;
}

long double si_value(const KeyRule& rule, const Value& value)
{
    const auto* text = std::get_if<std::string>(&value);
    long double si = 0; // a plain 0 is 0 in any unit
    if (text)
        si = with_unit(*text, rule.quantity);
    else if (const auto number = plain_number(value); !number || *number != 0)
        fail(fmt::format("is {}; must be {} with a unit, in quotes ({})", describe(value),
                         describe(dimension(rule.quantity)), usual_units(rule.quantity)));
    constexpr long double largest = 1e20L;
    if (std::abs(si) > largest || (si != 0 && std::abs(si) < 1 / largest))
        fail(fmt::format("is {}; that is out of any physical range", describe(value)));
    const bool too_small = rule.range.open_min ? si <= 0 : si < 0;
    if (rule.range.min >= 0 && too_small)
        fail(fmt::format("is {}; must be greater than 0", describe(value)));
    return si;
}

long double measure_value(const KeyRule& rule, const Value& value, UnitSystem system)
{
    if (system == UnitSystem::si) return si_value(rule, value);
    if (const auto number = plain_number(value)) return *number;
    fail(fmt::format("is {}; must be a plain number (values with units need units = \"si\")",
                     describe(value)));
}

CheckedValue integer_value(const Value& value)
{
    if (const auto* v = std::get_if<Index>(&value)) return *v;
    const auto* v = std::get_if<Real>(&value);
    if (v && std::abs(*v) < 1e15 && std::trunc(*v) == *v) return static_cast<Index>(*v);
    fail(fmt::format("is {}; must be a whole number", describe(value)));
}

CheckedValue step_value(const KeyRule& rule, const Value& value, UnitSystem system)
{
    const auto* text = std::get_if<std::string>(&value);
    if (text && *text == "auto") return *text;
    try {
        return measure_value(rule, value, system);
    } catch (const std::invalid_argument& e) {
        fail(fmt::format("{}, or \"auto\"", e.what()));
    }
}

std::string one_of(const std::vector<std::string_view>& choices)
{
    return fmt::format("one of \"{}\"", fmt::join(choices, "\", \""));
}

CheckedValue choice_value(const KeyRule& rule, const Value& value)
{
    const auto* text = std::get_if<std::string>(&value);
    if (!text) fail(fmt::format("is {}; must be {}", describe(value), one_of(rule.choices)));
    for (std::string_view choice : rule.choices)
        if (*text == choice) return *text;
    fail(fmt::format("unknown name {}; {}", in_quotes(*text), suggestion(*text, rule.choices)));
}

CheckedValue counts_value(const KeyRule& rule, const Value& value)
{
    const auto* counts = std::get_if<std::vector<Index>>(&value);
    if (!counts || counts->size() != 3)
        fail(fmt::format("is {}; must be three whole numbers, as in [128, 48, 48]",
                         describe(value)));
    for (Index n : *counts)
        if (!rule.range.contains(static_cast<Real>(n)))
            fail(fmt::format("holds {}; each must be {}", n, rule.range.describe()));
    return std::array<Index, 3>{(*counts)[0], (*counts)[1], (*counts)[2]};
}

CheckedValue numbers_value(const KeyRule& rule, const Value& value)
{
    std::vector<Real> numbers;
    if (const auto* v = std::get_if<std::vector<Real>>(&value))
        numbers = *v;
    else if (const auto* counts = std::get_if<std::vector<Index>>(&value))
        numbers.assign(counts->begin(), counts->end());
    else
        fail(fmt::format("is {}; must be an array of plain numbers, as in [0.5, 1.0]",
                         describe(value)));
    if (numbers.empty()) fail("is empty; must hold at least one number");
    for (Real x : numbers)
        if (!std::isfinite(x) || !rule.range.contains(x))
            fail(fmt::format("holds {:g}; each must be {}", x, rule.range.describe()));
    return numbers;
}

std::string what_a_measure_takes(const KeyRule& rule, UnitSystem system)
{
    const std::string scale = Scaling{}.unit(rule.quantity), range = rule.range.describe();
    if (system == UnitSystem::dimensionless)
        return fmt::format("a plain number in {}, {}", scale, range);
    const bool any_scale = rule.range.min == 0 && !std::isfinite(rule.range.max);
    return fmt::format("{} with a unit, in quotes ({}), {}{}", describe(dimension(rule.quantity)),
                       usual_units(rule.quantity), range, any_scale ? "" : " " + scale);
}

} // namespace

std::string what_it_takes(const KeyRule& rule, UnitSystem system)
{
    switch (rule.kind) {
    case Kind::boolean: return "true or false";
    case Kind::integer: return "a whole number " + rule.range.describe();
    case Kind::number: return "a plain number " + rule.range.describe();
    case Kind::measure: return what_a_measure_takes(rule, system);
    case Kind::step: return what_a_measure_takes(rule, system) + ", or \"auto\"";
    case Kind::seconds: return "a number of seconds, or a time with a unit, in quotes";
    case Kind::text: return "text in quotes";
    case Kind::choice: return one_of(rule.choices);
    case Kind::counts: return "three whole numbers, each " + rule.range.describe();
    case Kind::numbers: return "an array of plain numbers, each " + rule.range.describe();
    }
    return "";
}

CheckedValue check_value(const KeyRule& rule, const Value& value, UnitSystem system)
{
    const auto* text = std::get_if<std::string>(&value);
    switch (rule.kind) {
    case Kind::boolean:
        if (const auto* v = std::get_if<bool>(&value)) return *v;
        fail(fmt::format("is {}; must be true or false, without quotes", describe(value)));
    case Kind::integer: return integer_value(value);
    case Kind::number: return number_value(value);
    case Kind::measure: return measure_value(rule, value, system);
    case Kind::step: return step_value(rule, value, system);
    case Kind::seconds: return text ? with_unit(*text, rule.quantity) : number_value(value);
    case Kind::text:
        if (text) return *text;
        fail(fmt::format("is {}; must be text in quotes", describe(value)));
    case Kind::choice: return choice_value(rule, value);
    case Kind::counts: return counts_value(rule, value);
    case Kind::numbers: return numbers_value(rule, value);
    }
    fail("cannot be read");
}

} // namespace starling
