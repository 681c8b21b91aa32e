#include "output/field_file.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "output/file_name.hpp"
#include "output/frame_file.hpp"
#include "output/replace_file.hpp"

namespace starling {

namespace fs = std::filesystem;

namespace {

/// What all frames of the wall share; it stands in the first.
constexpr const char* shared_array = "/triangles";

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

constexpr const char* xdmf_attribute = "xdmf"; ///< of a frame: its part of NAME.xdmf

/// What the first frames say about themselves.
std::vector<xdmf::Grid> grids_of(const FieldFileOptions& options, const std::string& name)
{
    std::vector<xdmf::Grid> grids;
    for (Index n = 0; n < options.keep; ++n) {
        const fs::path path = options.directory / frame_name(name, n);
        try {
            const FrameFile frame(path);
            grids.push_back(
                {frame.head().t, hdf5::File::open(path).text_attribute("/", xdmf_attribute)});
        } catch (const std::exception& e) {
            throw InputError(fmt::format("{}: is missing or ends before the checkpoint, and cannot "
                                         "be made anew: {}",
                                         (options.directory / (name + ".xdmf")).string(),
                                         e.what()));
        }
    }
    return grids;
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

std::string frame_name(const std::string& name, Index frame)
{
    return fmt::format("frames/{}_{:06}.h5", name, frame);
}

FrameWriter::FrameWriter(FieldFileOptions options, std::string what)
    : options_(std::move(options)), what_(std::move(what)), name_(options_.prefix + what_),
      series_(options_.directory / (name_ + ".xdmf"), name_), frames_(options_.keep),
      synced_(options_.keep)
{
    fs::create_directory(options_.directory / "frames");
    if (frames_ > 0) {
        if (series_.holds(frames_))
            series_.keep(frames_);
        else
            series_.keep(grids_of(options_, name_));
        write_index(frames_);
    } else {
        fs::remove(options_.directory / (name_ + ".xdmf"));
        fs::remove(options_.directory / (name_ + ".h5"));
    }
    remove_later_frames();
}

bool FrameWriter::lists_frames(const FieldFileOptions& options, const std::string& what)
{
    const std::string name = options.prefix + what;
    if (xdmf::Series(options.directory / (name + ".xdmf"), name).holds(options.keep)) return true;
    grids_of(options, name);
    return false;
}

/// Frames from number `frames_` on and those that a kill left unfinished.
void FrameWriter::remove_later_frames() const
{
    const std::string first = fs::path(frame_name(name_, frames_)).filename();
    std::vector<fs::path> later;
    for (const auto& entry : fs::directory_iterator(options_.directory / "frames")) {
        const std::string name = entry.path().filename();
        const bool ours = is_numbered_or_unfinished(name, name_ + "_", 6, ".h5");
        if (ours && (name >= first || name.ends_with(".new"))) later.push_back(entry.path());
    }
    for (const fs::path& path : later) fs::remove(path);
}

FrameWriter::Frame FrameWriter::begin(Real t, Index step)
{
    const std::string name = frame_name(name_, frames_);
    Frame frame{hdf5::File::create(options_.directory / (name + ".new"), hdf5::Layout::compressed,
                                   seal_size),
                name, ""};
    frame.file.attribute("/", "of", what_);
    frame.file.attribute("/", "t", t * options_.scaling.factor(Quantity::time));
    frame.file.attribute("/", "step", step);
    frame.file.attribute("/", "unit_of_t", options_.scaling.unit(Quantity::time));
    frame.file.attribute("/", "unit_of_length", options_.scaling.unit(Quantity::length));
    return frame;
}

xdmf::Array FrameWriter::write(Frame& frame, const std::string& name,
                               const std::vector<hsize_t>& shape, std::vector<Real> values,
                               Quantity quantity)
{
    const Real factor = options_.scaling.factor(quantity);
    for (Real& v : values) v *= factor;
    const std::string path = "/" + name;
    frame.file.write(path, shape, values, options_.precision);
    frame.file.attribute(path, "unit", options_.scaling.unit(quantity));
    const int bytes = options_.precision == hdf5::Precision::single ? 4 : 8;
    return {frame.name + ":" + path, as_index(shape), false, bytes};
}

void FrameWriter::end(Frame frame, Real t)
{
    const fs::path path = options_.directory / frame.name;
    frame.file.attribute("/", xdmf_attribute, frame.xdmf);
    save_sealed(frame.file, frame_seal, false);
    fs::rename(path.string() + ".new", path);
    write_index(frames_ + 1);
    series_.add({t * options_.scaling.factor(Quantity::time), frame.xdmf});
    ++frames_; // last: where one of these fails the frame may be written again
}

// NAME.h5 and NAME.xdmf can be made anew from the frames.
void FrameWriter::sync()
{
    if (synced_ == frames_) return;
    for (; synced_ < frames_; ++synced_)
        sync_to_disk(options_.directory / frame_name(name_, synced_));
    sync_to_disk(options_.directory / "frames");
}

void FrameWriter::write_index(Index frames) const
{
    const fs::path path = options_.directory / (name_ + ".h5"), temporary = path.string() + ".new";
    {
        hdf5::File file = hdf5::File::create(temporary, hdf5::Layout::compressed, seal_size);
        file.attribute("/", "format", "starling " + name_);
        file.attribute("/", "format_version", Index{index_seal.version});
        file.attribute("/", "units", options_.scaling.si ? "si" : "dimensionless");
        file.attribute("/", "unit_of_t", options_.scaling.unit(Quantity::time));
        file.make_group("/frames");
        for (Index n = 0; n < frames; ++n)
            file.link(fmt::format("/frames/{:06}", n), frame_name(name_, n));
        if (what_ == "wall") file.link(shared_array, frame_name(name_, 0), shared_array);
        save_sealed(file, index_seal, false);
    }
    fs::rename(temporary, path);
}

void WallFile::write(const WallSnapshot& s)
{
    auto frame = writer_.begin(s.t, s.step);
    const hsize_t vertices = s.points.size(), elements = s.triangles.size();
    if (writer_.frames() == 0) {
        const auto* first = elements > 0 ? s.triangles.front().data() : nullptr;
        frame.file.write(shared_array, {elements, 3}, std::span(first, 3 * elements));
    }
    const xdmf::Array triangles{frame_name(writer_.name(), 0) + ":" + shared_array,
                                as_index({elements, 3}), true, 4};
    const auto points =
        writer_.write(frame, "points", {vertices, 3}, coordinates(s.points), Quantity::length);
    frame.xdmf = fmt::format("<Topology TopologyType=\"Triangle\" NumberOfElements=\"{}\">{}"
                             "</Topology>\n<Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
                             elements, xdmf::data_item(triangles), xdmf::data_item(points));
    const auto add = [&](const NamedArray& a, std::size_t count, xdmf::Centre centre) {
        const auto array =
            writer_.write(frame, a.name, list_shape(count, a.components), as_real(a), a.quantity);
        const std::string at = centre == xdmf::Centre::node ? "vertex" : "element";
        frame.file.attribute("/" + a.name, "at", at);
        frame.xdmf += xdmf::attribute(a.name, centre, a.components, array);
    };
    for (const NamedArray& a : s.at_vertex) add(a, vertices, xdmf::Centre::node);
    for (const NamedArray& a : s.at_element) add(a, elements, xdmf::Centre::cell);
    writer_.end(std::move(frame), s.t);
}

void FluidFile::write(const FluidSnapshot& s)
{
    auto frame = writer_.begin(s.t, s.step);
    const auto [nx, ny, nz] = s.cells;
    const Real l = writer_.scaling().factor(Quantity::length);
    const Vec3 origin = l * s.origin, spacing = l * s.spacing;
    frame.file.attribute("/", "origin", origin);
    frame.file.attribute("/", "spacing", spacing);
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
    writer_.end(std::move(frame), s.t);
}

} // namespace starling
