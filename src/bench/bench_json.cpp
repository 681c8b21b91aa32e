#include <nlohmann/json.hpp>

#include "bench/bench.hpp"
#include "bench/traffic.hpp"
#include "output/version.hpp"

namespace starling::bench {

namespace {

using Json = nlohmann::ordered_json;

Json timing_json(const Timing& t)
{
    return {{"min", t.least()}, {"median", t.median()}, {"repeats", t.seconds}};
}

Json machine_json(const Report& report)
{
    Json triad = Json::array();
    for (const BandwidthRow& b : report.bandwidth)
        triad.push_back({{"threads", b.threads},
                         {"array_bytes", b.array_bytes},
                         {"bytes_per_item", Triad::bytes_per_item},
                         {"bytes_per_second", {{"max", b.best}, {"median", b.median}}}});
    return {{"processors", report.processors},
            {"load_before", report.load_before},
            {"load_after", report.load_after},
            {"triad", triad}};
}

Json traffic_json()
{
    Json kernels = Json::array();
    for (const KernelTraffic& k : separate_kernels())
        kernels.push_back({{"name", k.name}, {"reads", k.reads}, {"writes", k.writes}});
    return {{"bytes_per_cell_step", bytes_per_cell_step()}, {"kernels", kernels}};
}

Json row_json(const StepRow& row)
{
    Json phases = Json::object();
    for (const auto& [name, timing] : row.phases) phases[name] = timing_json(timing);
    Json json = {{"grid", row.problem.cells},
                 {"wall", wall_text(row.problem.vertices)},
                 {"threads", row.threads},
                 {"cells", row.problem.cell_count()},
                 {"vertices", row.vertices},
                 {"steps_per_repeat", row.steps_per_repeat},
                 {"seconds_per_step", timing_json(row.step)},
                 {"phase_seconds_per_step", phases}};
    json["cell_steps_per_second"] = {{"max", row.rate(row.step.least())},
                                     {"median", row.rate(row.step.median())}};
    json["share_of_bandwidth_bound"] = row.share_of_bound();
    json["allocated_bytes"] = row.footprint.bytes;
    json["bytes_per_cell"] = row.footprint.bytes_per_cell;
    json["bytes_per_vertex"] =
        row.vertices == 0 ? Json(nullptr) : Json(row.footprint.bytes_per_vertex);
    return json;
}

} // namespace

std::string to_json(const Report& report)
{
    Json json = {{"format", "starling bench 1"},
                 {"version", version()},
                 {"machine", machine_json(report)},
                 {"traffic", traffic_json()},
                 {"rows", Json::array()}};
    for (const StepRow& row : report.rows) json["rows"].push_back(row_json(row));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace starling::bench
