#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "report/packed.hpp"
#include "report/page_data.hpp"

namespace starling::report {

namespace {

constexpr std::size_t most_bytes = 12'000'000; ///< of base64 that the wall may take

/// A field that the wall can be coloured by.
struct Field {
    const char* name;  ///< of the array in the frames
    const char* label; ///< for people
};
constexpr Field fields[] = {{"displacement", "displacement"},
                            {"tau1", "tension \u03c4\u2081 (largest)"},
                            {"transmural_pressure", "internal \u2212 external pressure"},
                            {"wall_shear_stress", "wall shear stress"}};

/// One number per vertex: lengths of vectors, means of what belongs to elements.
FrameArray scalar_at_vertices(const FrameArray& a, bool of_elements, const WallFrame& frame)
{
    const FrameArray at = of_elements ? at_vertices(a, frame) : a;
    if (at.components == 1) return at;
    FrameArray lengths{at.name, at.unit, at.shape, 1, {}};
    for (std::size_t v = 0; v < at.count(); ++v)
        lengths.values.push_back(std::hypot(at.at(v, 0), at.at(v, 1), at.at(v, 2)));
    return lengths;
}

std::optional<FrameArray> field_of(const WallFrame& frame, const std::string& name)
{
    for (const auto* arrays : {&frame.at_vertex, &frame.at_element})
        for (const FrameArray& a : *arrays)
            if (a.name == name) return scalar_at_vertices(a, arrays == &frame.at_element, frame);
    return std::nullopt;
}

/// Frames of the wall as they go into the page.
class Movie {
public:
    void add(const WallFrame& frame)
    {
        if (times_.empty()) {
            triangles_ = packed(frame.triangles);
            vertices_ = frame.points.count();
            unit_ = frame.points.unit;
        }
        if (frame.points.count() != vertices_)
            throw InputError("a frame of the wall has another number of vertices");
        times_.push_back({{"t", frame.head.t}, {"step", frame.head.step}});
        points_.push_back(packed(frame.points.values));
        for (std::size_t n = 0; n < std::size(fields); ++n)
            if (const auto field = field_of(frame, fields[n].name)) {
                units_[n] = field->unit;
                values_[n].push_back(field->values);
            }
    }
    Json json() const
    {
        Json all = Json::array();
        for (std::size_t n = 0; n < std::size(fields); ++n)
            if (values_[n].size() == times_.size()) all.push_back(field_json(n));
        return {{"unit", unit_},    {"vertices", vertices_}, {"triangles", triangles_},
                {"frames", times_}, {"points", points_},     {"fields", all}};
    }
    bool empty() const { return times_.empty(); }

private:
    Json field_json(std::size_t n) const
    {
        const Range range = range_of(values_[n]);
        Json frames = Json::array();
        for (const auto& values : values_[n]) frames.push_back(packed16(values, range));
        return {{"name", fields[n].name}, {"label", fields[n].label}, {"unit", units_[n]},
                {"low", range.low},       {"high", range.high},       {"values", frames}};
    }

    std::string unit_, triangles_;
    std::size_t vertices_ = 0;
    Json times_ = Json::array(), points_ = Json::array();
    std::string units_[std::size(fields)];
    std::vector<std::vector<Real>> values_[std::size(fields)];
};

/// Bytes that a frame takes in the page: points in 32 bits, fields in 16.
std::size_t size_of_frame(const WallFrame& frame)
{
    return base64_size(frame.points.count() * (3 * 4 + std::size(fields) * 2));
}

/// How many frames fit beside the triangles.
std::size_t frames_that_fit(const WallFrame& frame)
{
    const std::size_t mesh = base64_size(frame.triangles.size() * 12);
    return mesh < most_bytes ? (most_bytes - mesh) / size_of_frame(frame) : 0;
}

void note_what_is_left_out(std::size_t count, std::size_t kept, const WallFrame& frame,
                           Notes& notes)
{
    if (kept == count) return;
    notes.push_back(
        kept == 0 ? fmt::format("The wall is not shown: {} vertices are too many for this page. "
                                "ParaView opens wall.xdmf.",
                                frame.points.count())
                  : fmt::format("Of {} frames of the wall {} are shown, to keep this page small; "
                                "wall.xdmf has them all.",
                                count, kept));
}

} // namespace

Json wall_data(const std::vector<ListedFrame>& frames, Notes& notes)
{
    if (frames.empty()) return nullptr;
    const WallFrame last = FrameFile(frames.back().path).read_wall();
    const auto chosen = spread(frames.size(), frames_that_fit(last));
    note_what_is_left_out(frames.size(), chosen.size(), last, notes);
    Movie movie;
    for (const std::size_t n : chosen) movie.add(FrameFile(frames[n].path).read_wall());
    return movie.empty() ? Json() : movie.json();
}

} // namespace starling::report
