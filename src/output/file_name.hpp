#pragma once
/// Names of files that carry a number, told from those that a user has put beside them.
#include <algorithm>
#include <string>
#include <string_view>

namespace starling {

/// Whether `name` is `before`, a number of at least `digits` digits and `after`, no more no less.
inline bool is_numbered_name(std::string_view name, std::string_view before, std::size_t digits,
                             std::string_view after)
{
    if (!name.starts_with(before) || !name.ends_with(after) ||
        name.size() < before.size() + digits + after.size())
        return false;
    name.remove_prefix(before.size());
    name.remove_suffix(after.size());
    return std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
}

/// The same for what a kill left of such a file too: NAME.new.
inline bool is_numbered_or_unfinished(std::string_view name, std::string_view before,
                                      std::size_t digits, const std::string& after)
{
    return is_numbered_name(name, before, digits, after) ||
           is_numbered_name(name, before, digits, after + ".new");
}

} // namespace starling
