#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "report/flow_plane.hpp"
#include "report/packed.hpp"
#include "report/page_data.hpp"

namespace starling::report {

namespace {

constexpr std::size_t most_bytes = 4'000'000; ///< of base64 that the flow may take

struct Field {
    const char *name, *label;
    std::vector<Real> FlowPlane::*values;
    std::string FlowPlane::*unit;
};
const Field fields[] = {
    {"axial_velocity", "axial velocity", &FlowPlane::axial_velocity, &FlowPlane::unit_of_velocity},
    {"speed", "speed", &FlowPlane::speed, &FlowPlane::unit_of_velocity},
    {"pressure", "pressure", &FlowPlane::pressure, &FlowPlane::unit_of_pressure}};

/// The frame nearest in time to t.
const ListedFrame& nearest(const std::vector<ListedFrame>& frames, Real t)
{
    return *std::ranges::min_element(
        frames, {}, [t](const ListedFrame& frame) { return std::abs(frame.head.t - t); });
}

FlowPlane read_plane(const ListedFrame& fluid, const std::vector<ListedFrame>& wall)
{
    const FluidFrame frame = FrameFile(fluid.path).read_fluid();
    if (wall.empty()) return plane_through_axis(frame, nullptr);
    const FrameArray points = FrameFile(nearest(wall, frame.head.t).path).read("points");
    return plane_through_axis(frame, &points);
}

Json field_json(const Field& field, const std::vector<FlowPlane>& planes)
{
    std::vector<std::vector<Real>> values;
    for (const FlowPlane& plane : planes) values.push_back(plane.*field.values);
    const Range range = range_of(values);
    Json frames = Json::array();
    for (const auto& v : values) frames.push_back(packed16(v, range));
    return {{"name", field.name}, {"label", field.label}, {"unit", planes.front().*field.unit},
            {"low", range.low},   {"high", range.high},   {"values", frames}};
}

Json planes_json(const std::vector<FlowPlane>& planes, const Json& times)
{
    const FlowPlane& first = planes.front();
    Json all = Json::array();
    for (const Field& field : fields) all.push_back(field_json(field, planes));
    return {{"normal", first.normal == 1 ? "y" : "z"},
            {"cells", first.cells},
            {"origin", {first.origin.x, first.origin.y, first.origin.z}},
            {"spacing", {first.spacing.x, first.spacing.y, first.spacing.z}},
            {"frames", times},
            {"fields", all}};
}

} // namespace

Json flow_data(const std::vector<ListedFrame>& fluid, const std::vector<ListedFrame>& wall,
               Notes& notes)
{
    if (fluid.empty()) return nullptr;
    const FlowPlane last = read_plane(fluid.back(), wall);
    const std::size_t size = base64_size(last.speed.size() * std::size(fields) * 2);
    const auto chosen = spread(fluid.size(), most_bytes / std::max<std::size_t>(size, 1));
    if (chosen.size() < fluid.size())
        notes.push_back(fmt::format("Of {} frames of the flow {} are shown, to keep this page "
                                    "small; fluid.xdmf has them all.",
                                    fluid.size(), chosen.size()));
    std::vector<FlowPlane> planes;
    Json times = Json::array();
    for (const std::size_t n : chosen) {
        planes.push_back(read_plane(fluid[n], wall));
        if (planes.back().cells != last.cells)
            throw InputError("the frames of the fluid are on different grids");
        times.push_back({{"t", fluid[n].head.t}, {"step", fluid[n].head.step}});
    }
    return planes.empty() ? Json() : planes_json(planes, times);
}

} // namespace starling::report
