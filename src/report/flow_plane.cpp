#include "report/flow_plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/error.hpp"

namespace starling::report {

namespace {

const FrameArray& array_named(const FluidFrame& frame, const std::string& name)
{
    const auto found = std::ranges::find(frame.at_cell, name, &FrameArray::name);
    if (found == frame.at_cell.end())
        throw InputError("a frame of the fluid has no array \"" + name + "\"");
    return *found;
}

/// The layers of cells whose mean is the plane, and where that lies.
struct Layers {
    std::size_t first = 0, last = 0;
    Real place = 0;
};

Layers layers_at_axis(std::size_t cells, Real origin, Real spacing)
{
    if (cells < 2) return {0, 0, origin + spacing / 2};
    const auto face = static_cast<std::size_t>(
        std::clamp(std::round(-origin / spacing), 1.0, static_cast<Real>(cells - 1)));
    return {face - 1, face, origin + spacing * static_cast<Real>(face)};
}

/// Means over two layers of a component, over those that are numbers.
class LayerMean {
public:
    LayerMean(const FluidFrame& frame, int normal, Layers layers)
        : cells_(frame.cells), normal_(normal), layers_(layers)
    {
    }
    Real operator()(const FrameArray& a, std::size_t i, std::size_t j, int component) const
    {
        const Real first = a.at(index(i, j, layers_.first), component);
        const Real last = a.at(index(i, j, layers_.last), component);
        if (std::isnan(first)) return last;
        return std::isnan(last) ? first : (first + last) / 2;
    }

private:
    std::size_t index(std::size_t i, std::size_t j, std::size_t layer) const
    {
        const std::size_t y = normal_ == 1 ? layer : j, z = normal_ == 1 ? j : layer;
        return (z * cells_[1] + y) * cells_[0] + i;
    }

    std::array<std::size_t, 3> cells_;
    int normal_;
    Layers layers_;
};

Vec3 centre_of(const FlowPlane& plane, std::size_t i, std::size_t j)
{
    Vec3 at = plane.origin;
    at.x += plane.spacing.x * (static_cast<Real>(i) + 0.5);
    Real& across = plane.normal == 1 ? at.z : at.y;
    across +=
        (plane.normal == 1 ? plane.spacing.z : plane.spacing.y) * (static_cast<Real>(j) + 0.5);
    return at;
}

void fill(FlowPlane& plane, const FluidFrame& frame, const LayerMean& mean, const Rings* tube)
{
    const FrameArray &u = array_named(frame, "velocity"), &p = array_named(frame, "pressure");
    plane.unit_of_velocity = u.unit;
    plane.unit_of_pressure = p.unit;
    for (std::size_t j = 0; j < plane.cells[1]; ++j)
        for (std::size_t i = 0; i < plane.cells[0]; ++i) {
            const bool out = tube && !tube->contains(centre_of(plane, i, j));
            const Real blank = out ? std::numeric_limits<Real>::quiet_NaN() : 0;
            const Vec3 v = {mean(u, i, j, 0), mean(u, i, j, 1), mean(u, i, j, 2)};
            plane.axial_velocity.push_back(v.x + blank);
            plane.speed.push_back(std::hypot(v.x, v.y, v.z) + blank);
            plane.pressure.push_back(mean(p, i, j, 0) + blank);
        }
}

} // namespace

FlowPlane plane_through_axis(const FluidFrame& frame, const FrameArray* wall_points)
{
    FlowPlane plane;
    plane.normal = frame.cells[1] == 1 && frame.cells[2] > 1 ? 1 : 2;
    const bool y = plane.normal == 1;
    const Layers layers = y ? layers_at_axis(frame.cells[1], frame.origin.y, frame.spacing.y)
                            : layers_at_axis(frame.cells[2], frame.origin.z, frame.spacing.z);
    plane.cells = {frame.cells[0], frame.cells[y ? 2 : 1]};
    plane.origin = frame.origin;
    plane.spacing = frame.spacing;
    (y ? plane.origin.y : plane.origin.z) = layers.place;
    std::optional<Rings> tube;
    if (wall_points) tube.emplace(*wall_points);
    fill(plane, frame, LayerMean(frame, plane.normal, layers), tube ? &*tube : nullptr);
    return plane;
}

} // namespace starling::report
