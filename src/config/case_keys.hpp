#pragma once
/// Every section and key that a case file may hold, with type, unit and range: the one list that
/// the reader, its messages and docs/case_file.md follow.
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/scaling.hpp"

namespace starling {

/// How the numbers of a file are meant.
enum class UnitSystem {
    dimensionless, ///< plain numbers in the paper's scaling
    si             ///< strings with units
};

/// What a key takes.
enum class Kind {
    boolean,
    integer,
    number,  ///< a plain number in both unit systems
    measure, ///< a plain number when dimensionless, a string with a unit in SI
    step,    ///< a measure or "auto"
    seconds, ///< seconds of real time: a plain number or a string with a unit
    text,
    choice,  ///< one of a list of names
    counts,  ///< three whole numbers
    numbers, ///< an array of plain numbers in both unit systems
};

/// Allowed values; an open end excludes the bound itself.
struct Range {
    Real min = -std::numeric_limits<Real>::infinity();
    Real max = std::numeric_limits<Real>::infinity();
    bool open_min = false;
    bool open_max = false;

    /// False for a value that is not a number.
    bool contains(Real value) const;
    /// Words for messages and documents: "greater than 0 and at most 0.34".
    std::string describe() const;
    /// The range of the value times a positive factor.
    Range times(Real factor) const { return {min * factor, max * factor, open_min, open_max}; }
};

struct KeyRule {
    std::string_view section; ///< empty for keys above the first section
    std::string_view key;
    Kind kind;
    std::string_view meaning;
    Quantity quantity = Quantity::none;
    Range range = {}; ///< of the dimensionless value
    std::vector<std::string_view> choices = {};
    std::optional<UnitSystem> only = {}; ///< the unit system that has this key; empty: both
    std::string_view instead = {};       ///< what to write in the other unit system

    /// "section.key"
    std::string name() const;
};

const std::vector<KeyRule>& case_keys();

/// The rule of a key, or null.
const KeyRule* find_key(std::string_view section, std::string_view key);
/// The rule of "section.key", which must exist.
const KeyRule& case_key(std::string_view name);

std::vector<std::string_view> case_sections();
/// The keys of a section that a unit system has; all of them without one.
std::vector<std::string_view> keys_of(std::string_view section, std::optional<UnitSystem> system);

} // namespace starling
