#include "config/read_waveform.hpp"

#include <charconv>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "config/input_file.hpp"
#include "config/nearest_name.hpp"

namespace starling {

namespace {

constexpr std::size_t most_rows = 100000;

struct Columns {
    std::vector<Real> times, values;
};

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

/// The rows below a header. Throws std::invalid_argument with the line that is wrong.
Columns parse_columns(std::string_view text)
{
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
            throw std::invalid_argument(
                fmt::format("line {} is {}; it must hold two numbers: time,value", line,
                            in_quotes(std::string(row.substr(0, 40)))));
        columns.times.push_back(*t);
        columns.values.push_back(*value);
        if (columns.times.size() > most_rows)
            throw std::invalid_argument(fmt::format("has more than {} rows", most_rows));
    }
    if (columns.times.empty()) throw std::invalid_argument("has no rows of numbers");
    return columns;
}

/// A section and its keys.
class WaveformReader {
public:
    WaveformReader(CaseValues& values, std::string section, const std::filesystem::path& folder)
        : values_(values), section_(std::move(section)), folder_(folder)
    {
    }

    Waveform read()
    {
        Waveform w;
        if (!given_any()) return w;
        values_.require(key("amplitude"));
        values_.fill(key("amplitude"), w.amplitude);
        values_.fill(key("period"), w.period);
        const bool series = given("cosine") || given("sine");
        const bool table = given("times") || given("values"), file = given("file");
        if (series + table + file != 1)
            problem("amplitude", "needs one shape: cosine and sine terms, times and values, or a "
                                 "file");
        else if (series)
            read_series(w);
        else
            read_table(w);
        return w;
    }

private:
    bool given_any() const
    {
        return given("amplitude") || given("period") || given("cosine") || given("sine") ||
               given("times") || given("values") || given("file") || given("time_scale");
    }
    std::string key(std::string_view name) const { return fmt::format("{}.{}", section_, name); }
    bool given(std::string_view name) const { return values_.given(key(name)); }
    void problem(std::string_view name, const std::string& what)
    {
        values_.problem(key(name), what);
    }

    void read_series(Waveform& w)
    {
        values_.fill(key("cosine"), w.cosine);
        values_.fill(key("sine"), w.sine);
        if (!given("period")) values_.missing(key("period"));
        if (given("time_scale")) problem("time_scale", "belongs to a table of times and values");
    }

    void read_table(Waveform& w)
    {
        const bool from_file = given("file");
        const std::string place = from_file ? "file" : "times";
        if (from_file)
            read_file(w);
        else if (values_.require(key("times")) && values_.require(key("values"))) {
            values_.fill(key("times"), w.times);
            values_.fill(key("values"), w.values);
            if (w.times.size() != w.values.size())
                return problem("values", fmt::format("holds {} numbers for {} times",
                                                     w.values.size(), w.times.size()));
        }
        if (!values_.sound({key(place), key("period"), key("time_scale")})) return;
        Real scale = w.period;
        if (given("time_scale"))
            values_.fill(key("time_scale"), scale);
        else if (!given("period"))
            return values_.missing(key("time_scale"), "or give a period, which is the unit then");
        scale_times(w, scale, place);
    }

    void scale_times(Waveform& w, Real scale, const std::string& place)
    {
        for (Real& t : w.times) t *= scale;
        for (std::size_t n = 0; n < w.times.size(); ++n) {
            if (w.times[n] < 0 || (n > 0 && w.times[n] <= w.times[n - 1]))
                return problem(
                    place, fmt::format("has times that do not increase from 0 at row {}", n + 1));
        }
        if (w.period == 0 || w.times.empty()) return;
        // A table that ends where it begins again may say so.
        constexpr Real round_off = 1e-9;
        const Real last = w.times.back();
        if (w.times.size() > 1 && w.times.front() == 0 &&
            std::abs(last - w.period) < round_off * w.period) {
            if (w.values.back() != w.values.front())
                return problem(place,
                               "has other values at the end of the period than at its start");
            w.times.pop_back();
            w.values.pop_back();
        } else if (last >= w.period)
            problem(place, "has times past the period");
    }

    void read_file(Waveform& w)
    {
        if (!values_.has(key("file"))) return;
        const std::filesystem::path file = folder_ / values_.text(key("file"), "");
        try {
            Columns columns = parse_columns(input_text(file));
            w.times = std::move(columns.times);
            w.values = std::move(columns.values);
        } catch (const std::invalid_argument& e) {
            problem("file", fmt::format("{}: {}", in_quotes(file.string()), e.what()));
        }
    }

    CaseValues& values_;
    std::string section_;
    const std::filesystem::path& folder_;
};

} // namespace

Waveform read_waveform(CaseValues& values, const std::string& section,
                       const std::filesystem::path& folder)
{
    return WaveformReader(values, section, folder).read();
}

} // namespace starling
