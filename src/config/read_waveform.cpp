#include "config/read_waveform.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "config/nearest_name.hpp"
#include "config/read_columns.hpp"

namespace starling {

namespace {

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
            Columns columns = read_columns(file, "time,value");
            w.times = std::move(columns.first);
            w.values = std::move(columns.second);
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
