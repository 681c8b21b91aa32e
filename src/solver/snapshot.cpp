#include "solver/snapshot.hpp"

#include <algorithm>
#include <limits>

namespace starling {

namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

std::size_t place(const FluidSnapshot& s, Index i, Index j, Index k)
{
    return static_cast<std::size_t>((i * s.cells[1] + j) * s.cells[2] + k);
}

Real& along(Vec3& v, int direction) { return direction == 0 ? v.x : direction == 1 ? v.y : v.z; }

/// A snapshot of other cells, with arrays of the same names and room for them; `fill(a, from)`
/// gives the values of each.
template <class F>
FluidSnapshot on_other_cells(const FluidSnapshot& s, std::array<Index, 3> cells, F value)
{
    FluidSnapshot r = s;
    r.cells = cells;
    for (std::size_t n = 0; n < s.at_cell.size(); ++n) {
        const NamedArray& from = s.at_cell[n];
        auto& to = r.at_cell[n].values;
        to.clear();
        for (Index i = 0; i < cells[0]; ++i)
            for (Index j = 0; j < cells[1]; ++j)
                for (Index k = 0; k < cells[2]; ++k)
                    for (int c = 0; c < from.components; ++c) to.push_back(value(from, i, j, k, c));
    }
    return r;
}

Real value_at(const FluidSnapshot& s, const NamedArray& a, std::array<Index, 3> n, int c)
{
    return a.values[place(s, n[0], n[1], n[2]) * static_cast<std::size_t>(a.components) +
                    static_cast<std::size_t>(c)];
}

} // namespace

void blank_outside(FluidSnapshot& s, const Field<std::uint8_t>& inside)
{
    for (NamedArray& a : s.at_cell)
        for (Index i = 0; i < s.cells[0]; ++i)
            for (Index j = 0; j < s.cells[1]; ++j)
                for (Index k = 0; k < s.cells[2]; ++k) {
                    if (inside(i, j, k) || inside(i + 1, j, k)) continue;
                    const auto first =
                        a.values.begin() +
                        static_cast<std::ptrdiff_t>(place(s, i, j, k)) * a.components;
                    std::fill_n(first, a.components, nan);
                }
}

FluidSnapshot axial_layer(const FluidSnapshot& s, int direction)
{
    const auto d = static_cast<std::size_t>(direction);
    Vec3 origin = s.origin, spacing = s.spacing;
    const Real low = along(origin, direction), h = along(spacing, direction);
    const Index face =
        std::clamp(static_cast<Index>(std::lround(-low / h)), Index{1}, s.cells[d] - 1);
    std::array<Index, 3> cells = s.cells;
    cells[d] = 1;
    FluidSnapshot r =
        on_other_cells(s, cells, [&](const NamedArray& a, Index i, Index j, Index k, int c) {
            std::array<Index, 3> below = {i, j, k}, above = {i, j, k};
            below[d] = face - 1;
            above[d] = face;
            return (value_at(s, a, below, c) + value_at(s, a, above, c)) / 2;
        });
    along(r.origin, direction) = low + (static_cast<Real>(face) - 0.5) * h;
    return r;
}

FluidSnapshot block_means(const FluidSnapshot& s, Index n)
{
    std::array<Index, 3> edge{}, cells{};
    for (std::size_t d = 0; d < 3; ++d) {
        edge[d] = std::min(n, s.cells[d]);
        cells[d] = s.cells[d] / edge[d];
    }
    FluidSnapshot r =
        on_other_cells(s, cells, [&](const NamedArray& a, Index i, Index j, Index k, int c) {
            Real sum = 0;
            Index count = 0;
            for (Index p = i * edge[0]; p < (i + 1) * edge[0]; ++p)
                for (Index q = j * edge[1]; q < (j + 1) * edge[1]; ++q)
                    for (Index o = k * edge[2]; o < (k + 1) * edge[2]; ++o) {
                        const Real v = value_at(s, a, {p, q, o}, c);
                        if (std::isnan(v)) continue;
                        sum += v;
                        ++count;
                    }
            return count > 0 ? sum / static_cast<Real>(count) : nan;
        });
    r.spacing = {s.spacing.x * static_cast<Real>(edge[0]), s.spacing.y * static_cast<Real>(edge[1]),
                 s.spacing.z * static_cast<Real>(edge[2])};
    return r;
}

FluidSnapshot reduced(FluidSnapshot s, const SnapshotParameters& p,
                      const Field<std::uint8_t>& inside)
{
    if (p.region == FluidRegion::tube) blank_outside(s, inside);
    if (p.region == FluidRegion::plane_y) s = axial_layer(s, 1);
    if (p.region == FluidRegion::plane_z) s = axial_layer(s, 2);
    return p.stride > 1 ? block_means(s, p.stride) : s;
}

namespace {

/// The values at the places that are kept.
std::vector<NamedArray> chosen(const std::vector<NamedArray>& arrays,
                               const std::vector<std::size_t>& places)
{
    std::vector<NamedArray> all;
    for (const NamedArray& a : arrays) {
        NamedArray kept{a.name, a.quantity, a.components, {}};
        const auto width = static_cast<std::size_t>(a.components);
        for (std::size_t n : places)
            for (std::size_t c = 0; c < width; ++c) kept.values.push_back(a.values[n * width + c]);
        all.push_back(std::move(kept));
    }
    return all;
}

} // namespace

WallSnapshot slab(const WallSnapshot& s, Real x_begin, Real x_end)
{
    WallSnapshot r;
    r.t = s.t;
    r.step = s.step;
    std::vector<VertexIndex> number(s.points.size(), -1);
    std::vector<std::size_t> vertices, elements;
    const auto point = [&](VertexIndex v) { return s.points[static_cast<std::size_t>(v)]; };
    for (std::size_t e = 0; e < s.triangles.size(); ++e) {
        const auto& corners = s.triangles[e];
        if (!std::ranges::any_of(corners, [&](VertexIndex v) {
                return point(v).x >= x_begin && point(v).x <= x_end;
            }))
            continue;
        elements.push_back(e);
        std::array<VertexIndex, 3> renamed{};
        for (std::size_t k = 0; k < 3; ++k) {
            VertexIndex& n = number[static_cast<std::size_t>(corners[k])];
            if (n < 0) {
                n = static_cast<VertexIndex>(vertices.size());
                vertices.push_back(static_cast<std::size_t>(corners[k]));
                r.points.push_back(point(corners[k]));
            }
            renamed[k] = n;
        }
        r.triangles.push_back(renamed);
    }
    r.at_vertex = chosen(s.at_vertex, vertices);
    r.at_element = chosen(s.at_element, elements);
    return r;
}

FluidSnapshot slab(const FluidSnapshot& s, Real x_begin, Real x_end)
{
    const auto cell = [&](Real x) {
        return std::clamp(static_cast<Index>(std::floor((x - s.origin.x) / s.spacing.x)), Index{0},
                          s.cells[0] - 1);
    };
    const Index begin = cell(x_begin), end = cell(x_end) + 1;
    FluidSnapshot r = on_other_cells(s, {end - begin, s.cells[1], s.cells[2]},
                                     [&](const NamedArray& a, Index i, Index j, Index k, int c) {
                                         return value_at(s, a, {begin + i, j, k}, c);
                                     });
    r.origin.x += static_cast<Real>(begin) * s.spacing.x;
    return r;
}

} // namespace starling
