#include "output/field_file.hpp"

#include <fmt/format.h>

namespace starling {

namespace {

std::vector<Index> as_index(const std::vector<hsize_t>& shape)
{
    return {shape.begin(), shape.end()};
}

std::vector<hsize_t> list_shape(std::size_t count, int components)
{
    if (components == 1) return {count};
    return {count, static_cast<hsize_t>(components)};
}

std::vector<Real> coordinates(const std::vector<Vec3>& points)
{
    std::vector<Real> xyz;
    xyz.reserve(3 * points.size());
    for (const Vec3& p : points) xyz.insert(xyz.end(), {p.x, p.y, p.z});
    return xyz;
}

std::vector<Real> as_real(const NamedArray& a) { return {a.values.begin(), a.values.end()}; }

/// [x][y][z][component] -> [z][y][x][component].
std::vector<Real> transposed(const NamedArray& a, const std::array<Index, 3>& n)
{
    const auto components = static_cast<Index>(a.components);
    std::vector<Real> out(a.values.size());
    auto to = out.begin();
    for (Index k = 0; k < n[2]; ++k)
        for (Index j = 0; j < n[1]; ++j)
            for (Index i = 0; i < n[0]; ++i) {
                const auto from = a.values.begin() + ((i * n[1] + j) * n[2] + k) * components;
                to = std::copy(from, from + components, to);
            }
    return out;
}

} // namespace

FrameWriter::FrameWriter(FieldFileOptions options, std::string name)
    : options_(std::move(options)), name_(std::move(name)),
      series_(options_.directory / (name_ + ".xdmf"), name_)
{
    hdf5::File file = hdf5::File::create(options_.directory / (name_ + ".h5"));
    file.attribute("/", "format", "starling " + name_);
    file.attribute("/", "format_version", Index{1});
    file.attribute("/", "units", options_.scaling.si ? "si" : "dimensionless");
    file.attribute("/", "unit_of_t", options_.scaling.unit(Quantity::time));
    file.make_group("/frames");
    file.flush();
}

std::string FrameWriter::location(const std::string& path) const { return name_ + ".h5:" + path; }

FrameWriter::Frame FrameWriter::begin(Real t, Index step)
{
    Frame frame{hdf5::File::append(options_.directory / (name_ + ".h5")),
                fmt::format("/frames/{:06}", frames_), ""};
    frame.file.make_group(frame.group);
    frame.file.attribute(frame.group, "t", t * options_.scaling.factor(Quantity::time));
    frame.file.attribute(frame.group, "step", step);
    return frame;
}

xdmf::Array FrameWriter::write(Frame& frame, const std::string& name,
                               const std::vector<hsize_t>& shape, std::vector<Real> values,
                               Quantity quantity)
{
    const Real factor = options_.scaling.factor(quantity);
    for (Real& v : values) v *= factor;
    const std::string path = frame.group + "/" + name;
    frame.file.write(path, shape, values, options_.precision);
    frame.file.attribute(path, "unit", options_.scaling.unit(quantity));
    const int bytes = options_.precision == hdf5::Precision::single ? 4 : 8;
    return {location(path), as_index(shape), false, bytes};
}

void FrameWriter::end(Frame& frame, Real t)
{
    frame.file.flush();
    series_.add(t * options_.scaling.factor(Quantity::time), frame.xdmf);
    ++frames_;
}

void WallFile::write(const WallSnapshot& s)
{
    auto frame = writer_.begin(s.t, s.step);
    const hsize_t vertices = s.points.size(), elements = s.triangles.size();
    if (writer_.frames() == 0) {
        const auto* first = elements > 0 ? s.triangles.front().data() : nullptr;
        frame.file.write("/triangles", {elements, 3}, std::span(first, 3 * elements));
    }
    const xdmf::Array triangles{writer_.location("/triangles"), as_index({elements, 3}), true, 4};
    const auto points =
        writer_.write(frame, "points", {vertices, 3}, coordinates(s.points), Quantity::length);
    frame.xdmf = fmt::format("<Topology TopologyType=\"Triangle\" NumberOfElements=\"{}\">{}"
                             "</Topology>\n<Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
                             elements, xdmf::data_item(triangles), xdmf::data_item(points));
    const auto add = [&](const NamedArray& a, std::size_t count, xdmf::Centre centre) {
        const auto array =
            writer_.write(frame, a.name, list_shape(count, a.components), as_real(a), a.quantity);
        frame.xdmf += xdmf::attribute(a.name, centre, a.components, array);
    };
    for (const NamedArray& a : s.at_vertex) add(a, vertices, xdmf::Centre::node);
    for (const NamedArray& a : s.at_element) add(a, elements, xdmf::Centre::cell);
    writer_.end(frame, s.t);
}

void FluidFile::write(const FluidSnapshot& s)
{
    auto frame = writer_.begin(s.t, s.step);
    const auto [nx, ny, nz] = s.cells;
    const Real l = writer_.scaling().factor(Quantity::length);
    const Vec3 origin = l * s.origin, spacing = l * s.spacing;
    frame.file.attribute(frame.group, "origin", origin);
    frame.file.attribute(frame.group, "spacing", spacing);
    frame.xdmf = fmt::format("<Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"{} {} {}\"/>\n"
                             "<Geometry GeometryType=\"ORIGIN_DXDYDZ\">{}{}</Geometry>\n",
                             nz + 1, ny + 1, nx + 1, xdmf::data_item_zyx(origin),
                             xdmf::data_item_zyx(spacing));
    for (const NamedArray& a : s.at_cell) {
        std::vector<hsize_t> shape = {static_cast<hsize_t>(nz), static_cast<hsize_t>(ny),
                                      static_cast<hsize_t>(nx)};
        if (a.components > 1) shape.push_back(static_cast<hsize_t>(a.components));
        const auto array = writer_.write(frame, a.name, shape, transposed(a, s.cells), a.quantity);
        frame.xdmf += xdmf::attribute(a.name, xdmf::Centre::cell, a.components, array);
    }
    writer_.end(frame, s.t);
}

} // namespace starling
