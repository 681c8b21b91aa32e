#include "config/read_columns.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "config/input_file.hpp"
#include "config/nearest_name.hpp"

namespace starling {

namespace {

constexpr std::size_t most_rows = 100000;

std::optional<Real> number_of(std::string_view cell)
{
    const auto first = cell.find_first_not_of(" \t"), last = cell.find_last_not_of(" \t");
    if (first == std::string_view::npos) return std::nullopt;
    cell = cell.substr(first, last - first + 1);
    if (cell.front() == '+') cell.remove_prefix(1);
    Real x = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), x);
    if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(x))
        return std::nullopt;
    return x;
}

} // namespace

Columns read_columns(const std::filesystem::path& file, std::string_view names)
{
    const std::string contents = input_text(file);
    std::string_view text = contents;
    Columns columns;
    for (int line = 1; !text.empty(); ++line) {
        const auto end = text.find('\n');
        std::string_view row = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (!row.empty() && row.back() == '\r') row.remove_suffix(1);
        const auto comma = row.find(',');
        if (line == 1 && !number_of(row.substr(0, comma))) continue; // the header
        if (row.find_first_not_of(" \t") == std::string_view::npos) continue;
        const bool two = comma != std::string_view::npos;
        const auto t = number_of(row.substr(0, comma));
        const auto value = two ? number_of(row.substr(comma + 1)) : std::nullopt;
        if (!t || !value)
            throw std::invalid_argument(fmt::format("line {} is {}; it must hold two numbers: {}",
                                                    line, in_quotes(std::string(row.substr(0, 40))),
                                                    names));
        columns.first.push_back(*t);
        columns.second.push_back(*value);
        if (columns.first.size() > most_rows)
            throw std::invalid_argument(fmt::format("has more than {} rows", most_rows));
    }
    if (columns.first.empty()) throw std::invalid_argument("has no rows of numbers");
    return columns;
}

} // namespace starling
