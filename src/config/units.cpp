#include "config/units.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "config/nearest_name.hpp"

namespace starling {

namespace {

struct Unit {
    std::string_view symbol;
    long double factor;
    Dimension dimension;
    bool prefixable;
};

constexpr Dimension pressure_dimension{1, -1, -2};

constexpr std::array unit_table = {
    Unit{"m", 1, {0, 1, 0}, true},
    Unit{"g", 1e-3L, {1, 0, 0}, true},
    Unit{"s", 1, {0, 0, 1}, true},
    Unit{"min", 60, {0, 0, 1}, false},
    Unit{"h", 3600, {0, 0, 1}, false},
    Unit{"Hz", 1, {0, 0, -1}, true},
    Unit{"N", 1, {1, 1, -2}, true},
    Unit{"dyn", 1e-5L, {1, 1, -2}, false},
    Unit{"J", 1, {1, 2, -2}, true},
    Unit{"W", 1, {1, 2, -3}, true},
    Unit{"Pa", 1, pressure_dimension, true},
    Unit{"bar", 1e5L, pressure_dimension, true},
    Unit{"atm", 101325, pressure_dimension, false},
    Unit{"mmHg", 133.322387415L, pressure_dimension, false},
    Unit{"Torr", 101325.0L / 760, pressure_dimension, false},
    Unit{"cmH2O", 98.0665L, pressure_dimension, false},
    Unit{"P", 0.1L, {1, -1, -1}, true},
    Unit{"l", 1e-3L, {0, 3, 0}, true},
    Unit{"L", 1e-3L, {0, 3, 0}, true},
};

long double prefix_factor(char prefix)
{
    switch (prefix) {
    case 'n': return 1e-9L;
    case 'u': return 1e-6L;
    case 'm': return 1e-3L;
    case 'c': return 1e-2L;
    case 'd': return 1e-1L;
    case 'k': return 1e3L;
    case 'M': return 1e6L;
    case 'G': return 1e9L;
    default: return 0;
    }
}

std::optional<Unit> find_unit(std::string_view symbol)
{
    for (const Unit& u : unit_table)
        if (u.symbol == symbol) return u;
    if (symbol.size() < 2 || prefix_factor(symbol[0]) == 0) return std::nullopt;
    for (Unit u : unit_table) {
        if (!u.prefixable || u.symbol != symbol.substr(1)) continue;
        u.factor *= prefix_factor(symbol[0]);
        return u;
    }
    return std::nullopt;
}

[[noreturn]] void fail(const std::string& message) { throw std::invalid_argument(message); }

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Typographic forms (micro sign, superscripts, middle dot, no-break space) in plain ASCII.
std::string plain(std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, std::string_view>, 7> forms = {
        {{"\xC2\xB5", "u"},
         {"\xCE\xBC", "u"},
         {"\xC2\xB2", "^2"},
         {"\xC2\xB3", "^3"},
         {"\xC2\xB7", "*"},
         {"\xE2\x8B\x85", "*"},
         {"\xC2\xA0", " "}}};
    std::string out(text);
    for (const auto& [from, to] : forms)
        for (std::size_t at = 0; (at = out.find(from, at)) != std::string::npos;)
            out.replace(at, from.size(), to);
    return out;
}

/// Reads products and quotients of units; the text is plain ASCII.
class UnitReader {
public:
    explicit UnitReader(std::string_view text) : rest_(text) {}

    Measure read()
    {
        Measure total{1, {}};
        bool below = false; // behind a "/"
        for (skip_spaces();; skip_spaces()) {
            multiply(total, below ? -1 : 1);
            skip_spaces();
            if (rest_.empty()) return total;
            const bool divide = take('/');
            if (!divide && below) fail("write each unit below the line with its own \"/\"");
            if (!divide && !take('*')) static_cast<void>(take('.'));
            below = divide;
        }
    }

private:
    void skip_spaces()
    {
        while (take(' ')) {
        }
    }

    bool take(char c)
    {
        if (rest_.empty() || rest_.front() != c) return false;
        rest_.remove_prefix(1);
        return true;
    }

    void multiply(Measure& total, int sign)
    {
        if (take('1')) return; // as in "1/s"
        std::size_t length = 0;
        while (length < rest_.size() && (is_letter(rest_[length]) || is_digit(rest_[length])))
            ++length;
        std::string_view symbol = rest_.substr(0, length);
        if (symbol.empty()) fail("a unit is missing");
        rest_.remove_prefix(length);
        int power = take('^') ? exponent() : 1;
        std::optional<Unit> unit = find_unit(symbol);
        if (!unit && power == 1 && is_digit(symbol.back())) { // "m3" for "m^3"
            power = symbol.back() - '0';
            unit = find_unit(symbol.substr(0, symbol.size() - 1));
        }
        if (!unit) fail(fmt::format("unknown unit {}", in_quotes(symbol)));
        power *= sign;
        total.value *= std::pow(unit->factor, static_cast<long double>(power));
        total.dimension.mass += power * unit->dimension.mass;
        total.dimension.length += power * unit->dimension.length;
        total.dimension.time += power * unit->dimension.time;
    }

    int exponent()
    {
        const int sign = take('-') ? -1 : 1;
        if (rest_.empty() || !is_digit(rest_.front())) fail("a whole exponent must follow \"^\"");
        const int digit = rest_.front() - '0';
        rest_.remove_prefix(1);
        return sign * digit;
    }

    std::string_view rest_;
};

/// The number in front, and what follows it.
long double take_number(std::string_view& text)
{
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
    long double number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc::result_out_of_range) fail("the number is too large or too small");
    if (error != std::errc{}) fail("must start with a number, as in \"5 mm\"");
    if (!std::isfinite(number)) fail("the number must be finite");
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    return number;
}

} // namespace

Measure parse_measure(std::string_view text)
{
    if (text.size() > 100) fail("too long for a value with a unit");
    const std::string ascii = plain(text);
    std::string_view rest = ascii;
    const long double number = take_number(rest);
    if (rest.find_first_not_of(' ') == std::string_view::npos) return {number, {}};
    Measure measure = UnitReader(rest).read();
    measure.value *= number;
    if (!std::isfinite(measure.value)) fail("the number is too large");
    return measure;
}

std::string_view written_unit(std::string_view text)
{
    take_number(text);
    const auto first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return "";
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

} // namespace starling
