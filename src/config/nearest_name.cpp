#include "config/nearest_name.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace starling {

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// The words of a name ("a_b", "a-b", "a b") in alphabetical order, joined by "_".
std::string sorted_words(std::string_view name)
{
    std::vector<std::string> words(1);
    for (char c : name.substr(0, 64))
        if (c == '_' || c == '-' || c == ' ')
            words.emplace_back();
        else
            words.back() += lower(c);
    std::sort(words.begin(), words.end());
    return fmt::format("{}", fmt::join(words, "_"));
}

/// Edits from a to b; words in another order count as one more.
int distance(std::string_view a, std::string_view b)
{
    return std::min(edit_distance(a, b), 1 + edit_distance(sorted_words(a), sorted_words(b)));
}

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

} // namespace

int edit_distance(std::string_view a, std::string_view b)
{
    a = a.substr(0, 64), b = b.substr(0, 64);
    std::vector<int> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int replace = last[j - 1] + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, replace});
            const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                                 lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = last;
        last = row;
    }
    return last[b.size()];
}

std::string_view nearest_name(std::string_view wrong, const std::vector<std::string_view>& names)
{
    std::string_view best;
    int fewest = 1 + static_cast<int>(std::max<std::size_t>(2, wrong.size() / 3));
    for (std::string_view name : names) {
        const int edits = distance(wrong, name);
        if (edits < fewest && edits < static_cast<int>(name.size())) best = name, fewest = edits;
    }
    return best;
}

std::string suggestion(std::string_view wrong, const std::vector<std::string_view>& names)
{
    const std::string_view near = nearest_name(wrong, names);
    const std::string allowed = fmt::format("allowed: {}", fmt::join(names, ", "));
    return near.empty() ? allowed : fmt::format("did you mean \"{}\"? ({})", near, allowed);
}

std::string in_quotes(std::string_view text)
{
    constexpr std::size_t longest = 60;
    std::size_t end = std::min(text.size(), longest);
    while (end < text.size() && end > 0 && is_continuation(text[end])) --end;
    std::string out = "\"";
    for (char c : text.substr(0, end)) {
        const auto code = static_cast<unsigned char>(c);
        out += code < 0x20 || code == 0x7F ? '?' : c;
    }
    return out + (end < text.size() ? "...\"" : "\"");
}

} // namespace starling
