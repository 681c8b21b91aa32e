#include "output/summary.hpp"

#include <fstream>
#include <limits>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "output/replace_file.hpp"

namespace starling {

namespace {

using Json = nlohmann::ordered_json;

/// A number of the summary that has a unit.
struct Entry {
    const char* key;
    Quantity quantity;
    Real value;
};

/// Puts the entries into `json` in the case's units and their units into json["units"].
void put(Json& json, Json& units, const Scaling& scaling, const std::vector<Entry>& entries)
{
    for (const Entry& e : entries) {
        json[e.key] = e.value * scaling.factor(e.quantity);
        units[e.key] = scaling.unit(e.quantity);
    }
}

void put_sample(Json& json, Json& units, const Scaling& scaling, const Summary& s)
{
    using enum Quantity;
    const Sample& last = s.last;
    put(json, units, scaling,
        {{"t", time, last.t},
         {"dt", time, last.dt},
         {"Q_in", flow_rate, last.Q_in},
         {"Q_mid", flow_rate, last.Q_mid},
         {"Q_out", flow_rate, last.Q_out},
         {"Q_mid_over_Q0", none, s.Q_mid_over_Q0()},
         {"leak_over_Q", none, s.leak_over_Q()},
         {"mean_leak_over_Q", none, s.mean_leak_over_Q},
         {"R_max", length, last.R_max},
         {"x_R_max", length, last.x_R_max},
         {"R_min", length, last.R_min},
         {"smallest_gap", length, last.smallest_gap},
         {"min_gap_over_spacing", none, last.smallest_gap / s.spacing},
         {"min_area_ratio", none, last.min_area_ratio},
         {"x_min_area", length, last.x_min_area},
         {"volume", volume, last.volume},
         {"max_strain", none, last.max_strain},
         {"elastic_energy", energy, last.elastic_energy},
         {"bending_energy", energy, last.bending_energy}});
}

Json theory_json(const Summary& s, const Scaling& scaling)
{
    if (!s.theory) return nullptr;
    const TheoryValues& theory = *s.theory;
    Json json;
    json["Q_1d"] = theory.Q * scaling.factor(Quantity::flow_rate);
    json["R_max_1d"] = theory.R_max * scaling.factor(Quantity::length);
    json["Q_relative_difference"] = relative_difference(s.last.Q_mid, theory.Q);
    json["R_max_relative_difference"] = relative_difference(s.last.R_max, theory.R_max);
    if (std::abs(theory.R_max - 1) > 1e-9)
        json["displacement_relative_difference"] =
            relative_difference(s.last.R_max - 1, theory.R_max - 1);
    return json;
}

Json cycle_json(const Summary& s, Json& units, const Scaling& scaling)
{
    if (!s.cycle) return nullptr;
    Json json;
    json["cycles"] = s.cycle->cycles;
    json["period"] = s.cycle->period * scaling.factor(Quantity::time);
    units["cycle.period"] = scaling.unit(Quantity::time);
    json["change"] = s.cycle->change;
    for (const CycleQuantity& q : cycle_quantities()) {
        const CycleValues v = values_over(s.cycle->last, q.member);
        const Real factor = scaling.factor(q.quantity);
        json[q.name] = {{"mean", v.mean * factor},
                        {"min", v.min * factor},
                        {"max", v.max * factor},
                        {"amplitude", v.amplitude() * factor}};
        units[std::string("cycle.") + q.name] = scaling.unit(q.quantity);
    }
    return json;
}

Json place_json(const std::optional<Vec3>& place, const Scaling& scaling)
{
    if (!place) return nullptr;
    const Vec3 p = scaling.factor(Quantity::length) * *place;
    return {{"x", p.x}, {"y", p.y}, {"z", p.z}};
}

void put_cost(Json& json, Json& units, const Summary& s)
{
    json["wall_seconds"] = s.wall_seconds;
    json["cell_steps_per_second"] = s.cell_steps_per_second;
    json["threads"] = s.threads;
    json["peak_memory_bytes"] = s.peak_memory_bytes;
    json["cells"] = s.cells;
    json["vertices"] = s.vertices;
    json["elements"] = s.elements;
    json["phase_seconds"] = Json::object();
    for (const auto& [name, seconds] : s.phase_seconds) json["phase_seconds"][name] = seconds;
    units["wall_seconds"] = "s";
    units["cell_steps_per_second"] = "1/s";
    units["peak_memory_bytes"] = "B";
    units["phase_seconds"] = "s";
}

} // namespace

Real leak_over_Q(const Sample& s)
{
    constexpr Real least_flow = 1e-6;
    const Real Q = std::max(std::abs(s.Q_in), std::abs(s.Q_out));
    return Q < least_flow ? std::numeric_limits<Real>::quiet_NaN() : s.leak / Q;
}

std::string summary_json(const Summary& summary, const Scaling& scaling)
{
    Json json, units;
    json["title"] = summary.title;
    json["converged"] = summary.converged;
    json["reason"] = summary.reason;
    json["steps"] = summary.last.step;
    put_sample(json, units, scaling, summary);
    json["mode"] = summary.last.lobes;
    json["theory"] = theory_json(summary, scaling);
    units["theory.Q_1d"] = scaling.unit(Quantity::flow_rate);
    units["theory.R_max_1d"] = scaling.unit(Quantity::length);
    json["cycle"] = cycle_json(summary, units, scaling);
    json["breakdown"] = place_json(summary.breakdown, scaling);
    units["breakdown"] = scaling.unit(Quantity::length);
    json["warnings"] = summary.warnings;
    put_cost(json, units, summary);
    json["version"] = summary.version;
    json["units"] = units;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_summary(const std::filesystem::path& path, const Summary& summary,
                   const Scaling& scaling)
{
    replace_file(path, summary_json(summary, scaling));
}

Index peak_memory_bytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return Index{usage.ru_maxrss} * 1024;
}

namespace {

/// The number behind `key` in a file of lines "key number"; huge where there is none.
Index number_in(const char* path, const std::string& key)
{
    std::ifstream stream(path);
    for (std::string word; stream >> word;)
        if (Index value = 0; word == key && stream >> value) return value;
    return std::numeric_limits<Index>::max() / 4096;
}

/// The single number in a file; huge where it holds none ("max").
Index only_number_in(const char* path)
{
    std::ifstream stream(path);
    Index value = 0;
    return stream >> value ? value : std::numeric_limits<Index>::max();
}

} // namespace

Index available_memory_bytes()
{
    const char* meminfo = "/proc/meminfo";
    const Index machine =
        1024 * (number_in(meminfo, "MemAvailable:") + number_in(meminfo, "SwapFree:") / 2);
    const Index limit = only_number_in("/sys/fs/cgroup/memory.max");
    if (limit == std::numeric_limits<Index>::max()) return machine;
    const Index used = only_number_in("/sys/fs/cgroup/memory.current") -
                       number_in("/sys/fs/cgroup/memory.stat", "inactive_file");
    return std::min(machine, std::max(limit - used, Index{0}));
}

} // namespace starling
