#pragma once
/// Helpful answers to misspelt names, and safe quoting of what the user wrote.
#include <string>
#include <string_view>
#include <vector>

namespace starling {

/// Edits (insert, delete, replace, swap neighbours; case ignored) that turn `a` into `b`.
/// Both are cut to 64 characters, so that the cost is bounded.
int edit_distance(std::string_view a, std::string_view b);

/// The name nearest to `wrong` in edits, its words in any order ("inlet_pressure" is near
/// "pressure_inlet"), or an empty one where none is near enough to be meant.
std::string_view nearest_name(std::string_view wrong, const std::vector<std::string_view>& names);

/// `did you mean "x"? Allowed: a, b, x`; the question only where a name is near.
std::string suggestion(std::string_view wrong, const std::vector<std::string_view>& names);

/// The text in quotes, shortened and without control characters, fit for a terminal.
std::string in_quotes(std::string_view text);

} // namespace starling
