#pragma once
/// A parsed TOML file, flattened to section, key, value and place; overrides already applied.
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/error.hpp"

namespace starling {

/// Where something was written: a file and a line, or "--set".
struct Place {
    std::string file;
    int line = 0;
};

/// A value of a type that no key takes; `type` as a message names it: "a date".
struct OtherValue {
    std::string type;
};

using Value =
    std::variant<bool, Index, Real, std::string, std::vector<Index>, std::vector<Real>, OtherValue>;

struct Entry {
    std::string section; ///< empty for keys above the first section
    std::string key;
    Value value;
    Place place;
};

struct Document {
    std::string file;
    std::vector<Entry> entries;
    std::map<std::string, Place, std::less<>> sections;
    std::vector<Problem> problems; ///< malformed overrides
};

/// Parses the text and applies overrides "section.key=value"; an empty value removes the key.
/// Throws InputError with file, line and column where the text is no TOML.
Document parse_document(std::string_view text, const std::string& file,
                        const std::vector<std::string>& overrides);

} // namespace starling
