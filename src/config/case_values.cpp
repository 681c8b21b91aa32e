#include "config/case_values.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "config/nearest_name.hpp"
#include "config/quantities.hpp"

namespace starling {

namespace {

bool is_scaled(const KeyRule& rule)
{
    return rule.kind == Kind::measure || rule.kind == Kind::step;
}

std::string dotted(const Entry& e)
{
    return e.section.empty() ? e.key : fmt::format("{}.{}", e.section, e.key);
}

/// The name for a message: as it is where it is plain, in safe quotes where it is not.
std::string safe_name(const std::string& name)
{
    const std::string safe = in_quotes(name);
    return safe.substr(1, safe.size() - 2);
}

std::string misplaced_key(const Entry& e, std::optional<UnitSystem> system)
{
    for (std::string_view section : case_sections()) {
        if (e.section.empty() && e.key == section)
            return fmt::format("is a section: write [{}]", section);
        if (find_key(section, e.key))
            return fmt::format("unknown key here; it belongs in [{}]", section);
    }
    return fmt::format("unknown key; {}", suggestion(e.key, keys_of(e.section, system)));
}

} // namespace

CaseValues::CaseValues(const Document& document)
    : file_(document.file), sections_(document.sections), problems_(document.problems)
{
    for (const auto& [section, place] : document.sections) {
        const auto known = case_sections();
        if (std::find(known.begin(), known.end(), section) == known.end())
            problems_.push_back({place.file, place.line, safe_name(section),
                                 fmt::format("unknown section; {}", suggestion(section, known))});
    }
    for (const Entry& e : document.entries)
        if (const KeyRule* rule = find_key(e.section, e.key)) places_[rule->name()] = e.place;
    read_system(document);
    for (const Entry& e : document.entries) check_name(e, system_);
    for (const Entry& e : document.entries)
        if (const KeyRule* rule = find_key(e.section, e.key); rule && rule->key != "units")
            check(*rule, e.value);
    if (!system_) throw_problems();
}

void CaseValues::read_system(const Document& document)
{
    const KeyRule& rule = case_key("units");
    std::string_view meant = "dimensionless";
    for (const Entry& e : document.entries) {
        if (!e.section.empty() || e.key != "units") continue;
        check(rule, e.value);
        const auto* given = std::get_if<std::string>(&e.value);
        meant = given ? nearest_name(*given, rule.choices) : "";
    }
    if (!meant.empty()) system_ = meant == "si" ? UnitSystem::si : UnitSystem::dimensionless;
}

void CaseValues::check_name(const Entry& e, std::optional<UnitSystem> system)
{
    const auto known = case_sections();
    const bool in_known_section =
        e.section.empty() || std::find(known.begin(), known.end(), e.section) != known.end();
    if (in_known_section && !find_key(e.section, e.key))
        problems_.push_back(
            {e.place.file, e.place.line, safe_name(dotted(e)), misplaced_key(e, system)});
}

void CaseValues::check(const KeyRule& rule, const Value& value)
{
    if (!system_ && is_scaled(rule)) return; // cannot be judged
    if (rule.only && system_ && rule.only != system_)
        return problem(rule.name(),
                       fmt::format("belongs to units = \"{}\"; {}",
                                   rule.only == UnitSystem::si ? "si" : "dimensionless",
                                   rule.instead));
    try {
        values_[rule.name()] =
            check_value(rule, value, system_.value_or(UnitSystem::dimensionless));
    } catch (const std::invalid_argument& e) {
        return problem(rule.name(), e.what());
    }
    if (system_ == UnitSystem::si && is_scaled(rule))
        note_unit(rule, value);
    else
        check_range(rule);
}

void CaseValues::note_unit(const KeyRule& rule, const Value& value)
{
    const auto* text = std::get_if<std::string>(&value);
    if (!text || *text == "auto") return;
    const std::string unit(written_unit(*text));
    if (!unit.empty()) units_[rule.name()] = unit;
}

void CaseValues::check_range(const KeyRule& rule)
{
    const std::string name = rule.name();
    if (!has(name)) return;
    const CheckedValue& value = values_.at(name);
    Real x = 0;
    if (std::holds_alternative<long double>(value))
        x = number(name);
    else if (const auto* count = std::get_if<Index>(&value))
        x = static_cast<Real>(*count);
    else
        return;
    if (std::isfinite(x) && rule.range.contains(x)) return;
    std::string allowed = rule.range.describe();
    if (system_ != UnitSystem::si || !is_scaled(rule))
        return problem(name, fmt::format("is {:g}; must be {}", x, allowed));
    allowed += " " + Scaling{}.unit(rule.quantity);
    if (const auto unit = written_unit_of(rule))
        allowed = fmt::format("{} {} ({})", rule.range.times(unit->factor).describe(), unit->name,
                              allowed);
    problem(name, fmt::format("is {}; must be {}{}", in_units(name, x), allowed, scales_set()));
}

/// Where --set has changed a scale, keys that it does not name may be out of range.
std::string CaseValues::scales_set() const
{
    for (const char* name : {"vessel.radius", "fluid.density", "drive.velocity_scale"})
        if (const auto place = places_.find(name);
            place != places_.end() && place->second.file == "--set")
            return fmt::format(" (--set {} has changed the scale)", name);
    return "";
}

std::optional<CaseValues::WrittenUnit> CaseValues::written_unit_of(const KeyRule& rule) const
{
    const auto unit = units_.find(rule.name());
    if (unit == units_.end()) return std::nullopt;
    const long double size = parse_measure("1 " + unit->second).value;
    return WrittenUnit{unit->second,
                       static_cast<Real>(static_cast<long double>(scale(rule)) / size)};
}

std::string CaseValues::in_units(std::string_view name, Real value) const
{
    const KeyRule& rule = case_key(name);
    std::string scaled = fmt::format("{:.4g} {}", value, Scaling{}.unit(rule.quantity));
    if (system_ != UnitSystem::si || !std::isfinite(scale(rule))) return scaled;
    if (const auto unit = written_unit_of(rule))
        return fmt::format("{:.4g} {} ({})", value * unit->factor, unit->name, scaled);
    const long double si = static_cast<long double>(value * scale(rule));
    const auto close = [=](long double other) {
        return std::abs(other - si) <= 5e-4 * std::abs(si);
    };
    return fmt::format("{} ({})", format_measure(si, rule.quantity, close), scaled);
}

void CaseValues::set_scaling(const Scaling& scaling)
{
    scaling_ = scaling;
    for (const KeyRule& rule : case_keys())
        if (is_scaled(rule)) check_range(rule);
}

Real CaseValues::scale(const KeyRule& rule) const
{
    return is_scaled(rule) ? scaling_.factor(rule.quantity) : 1;
}

bool CaseValues::given(std::string_view name) const { return places_.contains(name); }

bool CaseValues::has(std::string_view name) const
{
    return values_.contains(name) && !bad_.contains(name) && std::isfinite(scale(case_key(name)));
}

bool CaseValues::sound(std::initializer_list<std::string_view> names) const
{
    return std::all_of(names.begin(), names.end(), [&](std::string_view name) {
        return !bad_.contains(name) && (!given(name) || has(name));
    });
}

bool CaseValues::require(std::string_view name)
{
    if (!given(name) && !bad_.contains(name)) missing(name);
    return has(name);
}

void CaseValues::missing(std::string_view name, std::string_view otherwise)
{
    const KeyRule& rule = case_key(name);
    problem(name, fmt::format("is missing: {}, {}{}{}", rule.meaning, what_it_takes(rule, system()),
                              otherwise.empty() ? "" : "; ", otherwise));
}

long double CaseValues::si(std::string_view name) const
{
    return std::get<long double>(values_.find(name)->second);
}

Real CaseValues::number(std::string_view name) const
{
    return static_cast<Real>(si(name) / static_cast<long double>(scale(case_key(name))));
}

std::string CaseValues::text(std::string_view name, std::string_view otherwise) const
{
    return has(name) ? std::get<std::string>(values_.find(name)->second) : std::string(otherwise);
}

void CaseValues::accept(std::string_view culprit, std::string_view key, Real value, Real& target)
{
    const KeyRule& rule = case_key(key);
    if (std::isfinite(value) && rule.range.contains(value))
        target = value;
    else
        problem(culprit, fmt::format("gives a {} of {:g}; it must be {}", rule.meaning, value,
                                     rule.range.describe()));
}

void CaseValues::problem(std::string_view name, const std::string& message)
{
    const std::string_view section = name.substr(0, name.rfind('.'));
    Place place{file_, 0};
    if (const auto s = sections_.find(section); s != sections_.end()) place = s->second;
    if (const auto p = places_.find(name); p != places_.end()) place = p->second;
    problems_.push_back({place.file, place.line, std::string(name), message});
    bad_.emplace(name);
}

void CaseValues::throw_problems()
{
    if (problems_.empty()) return;
    std::stable_sort(problems_.begin(), problems_.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    throw InputError(problems_);
}

} // namespace starling
