#include "output/export.hpp"

#include <bit>
#include <cstring>
#include <iterator>

#include <fmt/format.h>

#include "output/replace_file.hpp"

namespace starling {

namespace {

static_assert(std::endian::native == std::endian::little, "VTK files are written as they lie");

/// A VTK XML file whose arrays follow the text as they lie in memory.
class VtkFile {
public:
    /// An array in the text: its values are kept for the end.
    template <class T>
    std::string array(const char* type, const std::string& name, int components,
                      const std::vector<T>& values)
    {
        const std::string tag =
            fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                        "format=\"appended\" offset=\"{}\"/>\n",
                        type, name, components, data_.size());
        const std::uint64_t bytes = values.size() * sizeof(T);
        append(&bytes, sizeof(bytes));
        append(values.data(), bytes);
        return tag;
    }
    /// 32 bits do for what frames hold by default; values that need more keep 64.
    std::string array(const FrameArray& a)
    {
        bool single = true;
        for (Real v : a.values)
            single = single && (std::isnan(v) || static_cast<Real>(static_cast<float>(v)) == v);
        if (!single) return array("Float64", a.name, a.components, a.values);
        return array("Float32", a.name, a.components,
                     std::vector<float>(a.values.begin(), a.values.end()));
    }
    std::string arrays(const std::vector<FrameArray>& all)
    {
        std::string text;
        for (const FrameArray& a : all) text += array(a);
        return text;
    }
    void save(const std::filesystem::path& path, const char* kind, const std::string& body) const
    {
        replace_file(path,
                     fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" "
                                 "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n{1}"
                                 "<AppendedData encoding=\"raw\">\n_",
                                 kind, body) +
                         data_ + "\n</AppendedData>\n</VTKFile>\n");
    }

private:
    void append(const void* bytes, std::size_t count)
    {
        data_.append(static_cast<const char*>(bytes), count);
    }

    std::string data_;
};

/// Text as VTK has it in XML: the codes of its bytes.
std::string text_array(const std::string& name, const std::string& text)
{
    std::string codes;
    for (char c : text) codes += fmt::format("{} ", static_cast<unsigned char>(c));
    return fmt::format("<Array type=\"String\" Name=\"{}\" NumberOfTuples=\"1\" format=\"ascii\">"
                       "{}0</Array>\n",
                       name, codes);
}

std::string units_text(const std::vector<FrameArray>& arrays)
{
    std::string text;
    for (const FrameArray& a : arrays) text += fmt::format("; {} [{}]", a.name, a.unit);
    return text;
}

/// Time, step and units.
std::string field_data(const FrameHead& head, const std::string& units)
{
    return fmt::format("<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" "
                       "NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n"
                       "<DataArray type=\"Int64\" Name=\"step\" NumberOfTuples=\"1\" "
                       "format=\"ascii\">{}</DataArray>\n{}</FieldData>\n",
                       head.t, head.step,
                       text_array("units", fmt::format("t [{}]{}", head.unit_of_t, units)));
}

std::string triangles_of(VtkFile& file, const WallFrame& frame)
{
    std::vector<std::int32_t> corners, ends;
    for (const auto& triangle : frame.triangles) {
        corners.insert(corners.end(), triangle.begin(), triangle.end());
        ends.push_back(static_cast<std::int32_t>(corners.size()));
    }
    return file.array("Int32", "connectivity", 1, corners) +
           file.array("Int32", "offsets", 1, ends);
}

/// One line of a table.
void add_line(std::string& text, const std::vector<std::string>& cells)
{
    for (std::size_t n = 0; n < cells.size(); ++n) {
        if (n > 0) text += ',';
        text += cells[n];
    }
    text += '\n';
}

void add_titles(std::vector<std::string>& titles, const FrameArray& a)
{
    constexpr const char* ends[] = {"_x", "_y", "_z"};
    for (int c = 0; c < a.components; ++c)
        titles.push_back(
            fmt::format("{}{} [{}]", a.name, a.components == 1 ? "" : ends[c], a.unit));
}

void add_values(std::vector<std::string>& cells, const FrameArray& a, std::size_t n)
{
    for (int c = 0; c < a.components; ++c) cells.push_back(fmt::format("{}", a.at(n, c)));
}

std::vector<std::string> titles_of(const std::string& unit_of_length,
                                   const std::vector<FrameArray>& arrays)
{
    std::vector<std::string> titles;
    for (const char* name : {"x", "y", "z"})
        titles.push_back(fmt::format("{} [{}]", name, unit_of_length));
    for (const FrameArray& a : arrays) add_titles(titles, a);
    return titles;
}

} // namespace

void write_vtp(const std::filesystem::path& path, const WallFrame& frame)
{
    VtkFile file;
    const std::string units =
        units_text({frame.points}) + units_text(frame.at_vertex) + units_text(frame.at_element);
    std::string body =
        fmt::format("<PolyData>\n{}<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n",
                    field_data(frame.head, units), frame.points.count(), frame.triangles.size());
    body += "<Points>\n" + file.array(frame.points) + "</Points>\n";
    body += "<Polys>\n" + triangles_of(file, frame) + "</Polys>\n";
    body += "<PointData>\n" + file.arrays(frame.at_vertex) + "</PointData>\n";
    body += "<CellData>\n" + file.arrays(frame.at_element) + "</CellData>\n";
    file.save(path, "PolyData", body + "</Piece>\n</PolyData>\n");
}

void write_vti(const std::filesystem::path& path, const FluidFrame& frame)
{
    VtkFile file;
    const auto [nx, ny, nz] = frame.cells;
    const std::string extent = fmt::format("0 {} 0 {} 0 {}", nx, ny, nz);
    const Vec3 &o = frame.origin, &h = frame.spacing;
    std::string body = fmt::format(
        "<ImageData WholeExtent=\"{}\" Origin=\"{} {} {}\" Spacing=\"{} {} {}\">\n"
        "{}<Piece Extent=\"{}\">\n",
        extent, o.x, o.y, o.z, h.x, h.y, h.z,
        field_data(frame.head, fmt::format("; origin, spacing [{}]", frame.unit_of_length) +
                                   units_text(frame.at_cell)),
        extent);
    body += "<CellData>\n" + file.arrays(frame.at_cell) + "</CellData>\n";
    file.save(path, "ImageData", body + "</Piece>\n</ImageData>\n");
}

void write_csv(const std::filesystem::path& path, const WallFrame& frame)
{
    std::vector<FrameArray> arrays = frame.at_vertex;
    for (const FrameArray& a : frame.at_element) arrays.push_back(at_vertices(a, frame));
    std::string text;
    add_line(text, titles_of(frame.points.unit, arrays));
    for (std::size_t v = 0; v < frame.points.count(); ++v) {
        std::vector<std::string> cells;
        add_values(cells, frame.points, v);
        for (const FrameArray& a : arrays) add_values(cells, a, v);
        add_line(text, cells);
    }
    replace_file(path, text);
}

void write_csv(const std::filesystem::path& path, const FluidFrame& frame)
{
    std::string text;
    add_line(text, titles_of(frame.unit_of_length, frame.at_cell));
    const auto [nx, ny, nz] = frame.cells;
    const auto centre = [](Real origin, Real spacing, std::size_t n) {
        return fmt::format("{}", origin + spacing * (static_cast<Real>(n) + 0.5));
    };
    const Vec3 &o = frame.origin, &h = frame.spacing;
    for (std::size_t n = 0; n < nx * ny * nz; ++n) {
        std::vector<std::string> cells = {centre(o.x, h.x, n % nx), centre(o.y, h.y, n / nx % ny),
                                          centre(o.z, h.z, n / (nx * ny))};
        for (const FrameArray& a : frame.at_cell) add_values(cells, a, n);
        add_line(text, cells);
    }
    replace_file(path, text);
}

} // namespace starling
