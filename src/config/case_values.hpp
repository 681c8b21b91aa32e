#pragma once
/// The values of a case file, each checked on its own against its rule; problems are collected.
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "config/case_keys.hpp"
#include "config/document.hpp"
#include "config/value_check.hpp"

namespace starling {

/// Names of keys are dotted ("wall.law"). A value is "good" when its own rule accepts it.
class CaseValues {
public:
    /// Checks names, types, units and signs. Where the unit system is misspelt, the nearest name is
    /// taken as meant; where it is unclear, throws InputError with all that does not depend on it.
    explicit CaseValues(const Document& document);

    UnitSystem system() const { return *system_; }

    /// From here on measures are divided by these scales; a scale that is not finite is unknown.
    void set_scaling(const Scaling& scaling);

    /// Whether the file gives the key, good or not.
    bool given(std::string_view name) const;
    bool has_section(std::string_view section) const { return sections_.contains(section); }
    /// Whether the key has a good value.
    bool has(std::string_view name) const;
    /// Whether a problem has been reported for none of the keys.
    bool sound(std::initializer_list<std::string_view> names) const;
    /// has(), after reporting the key as missing where the file does not give it.
    bool require(std::string_view name);
    /// Reports the key as missing: what it means, what it takes, and what else would do.
    void missing(std::string_view name, std::string_view otherwise = "");
    /// A dimensionless value for messages: "2.6 R_0"; in SI "1.3 mm (2.6 R_0)", in the unit in
    /// which the file gives the key, or else a handy one.
    std::string in_units(std::string_view name, Real value) const;

    /// The dimensionless number of a number, measure, step or seconds; the key must have one.
    Real number(std::string_view name) const;
    /// The measure in SI units; the key must have one.
    long double si(std::string_view name) const;
    /// The name or text of a choice or text, with `otherwise` where the key is absent.
    std::string text(std::string_view name, std::string_view otherwise) const;

    /// Assigns where the key has a good value (numbers dimensionless; not for "auto"); the target
    /// keeps its default otherwise. T is bool, Index, Real, three counts, numbers, or optional of
    /// these.
    template <class T>
    void fill(std::string_view name, T& target) const
    {
        if (!has(name)) return;
        const CheckedValue& value = values_.find(name)->second;
        using Held = typename Unwrap<T>::type;
        if constexpr (!std::is_same_v<Held, Real>)
            target = std::get<Held>(value);
        else if (std::holds_alternative<long double>(value))
            target = number(name);
    }

    /// Takes a number that the file implies if the rule of `key` allows it; reports it at
    /// `culprit` otherwise.
    void accept(std::string_view culprit, std::string_view key, Real value, Real& target);
    /// Reports a problem where the key stands, or where its section starts.
    void problem(std::string_view name, const std::string& message);
    /// Throws InputError with all problems, in the order of their lines, if there are any.
    void throw_problems();

private:
    template <class T>
    struct Unwrap {
        using type = T;
    };
    template <class T>
    struct Unwrap<std::optional<T>> {
        using type = T;
    };

    struct WrittenUnit {
        std::string name;
        Real factor; ///< of dimensionless numbers, to this unit
    };

    void read_system(const Document& document);
    void check_name(const Entry& entry, std::optional<UnitSystem> system);
    void check(const KeyRule& rule, const Value& value);
    void note_unit(const KeyRule& rule, const Value& value);
    void check_range(const KeyRule& rule);
    std::string scales_set() const;
    std::optional<WrittenUnit> written_unit_of(const KeyRule& rule) const;
    Real scale(const KeyRule& rule) const;

    std::string file_;
    std::map<std::string, Place, std::less<>> sections_;
    std::map<std::string, Place, std::less<>> places_; ///< of every key that is given
    std::map<std::string, CheckedValue, std::less<>> values_;
    std::map<std::string, std::string, std::less<>> units_; ///< as written, of SI measures
    std::set<std::string, std::less<>> bad_;
    std::vector<Problem> problems_;
    std::optional<UnitSystem> system_; ///< empty: unclear
    Scaling scaling_;
};

} // namespace starling
