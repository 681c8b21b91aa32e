#include "output/xdmf.hpp"

#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/replace_file.hpp"

namespace starling::xdmf {

std::string data_item(const Array& a)
{
    return fmt::format(R"(<DataItem Dimensions="{}" NumberType="{}" Precision="{}" Format="HDF">)"
                       "{}</DataItem>",
                       fmt::join(a.shape, " "), a.integer ? "Int" : "Float", a.bytes, a.location);
}

std::string data_item_zyx(const Vec3& v)
{
    return fmt::format(R"(<DataItem Dimensions="3" NumberType="Float" Precision="8" Format="XML">)"
                       "{} {} {}</DataItem>",
                       v.z, v.y, v.x);
}

std::string attribute(const std::string& name, Centre centre, int components, const Array& array)
{
    return fmt::format(R"(<Attribute Name="{}" AttributeType="{}" Center="{}">{}</Attribute>)"
                       "\n",
                       name, components == 3 ? "Vector" : "Scalar",
                       centre == Centre::node ? "Node" : "Cell", data_item(array));
}

Series::Series(std::filesystem::path path, std::string name)
    : path_(std::move(path)), name_(std::move(name))
{
}

void Series::keep(Index frames)
{
    frames_ = first(frames).value();
    replace();
}

void Series::keep(const std::vector<Grid>& grids)
{
    frames_.clear();
    for (const Grid& grid : grids) frames_ += text_of(grid);
    replace();
}

/// The first `frames` grids of the file; nothing where it holds fewer.
std::optional<std::string> Series::first(Index frames) const
{
    std::ifstream stream(path_, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::string head = fmt::format("<Grid Name=\"{}\" GridType=\"Uniform\">", name_);
    const std::string tail = "</Grid>\n";
    const std::size_t begin = std::min(text.find(head), text.size());
    std::size_t end = begin;
    for (Index n = 0; n < frames; ++n) {
        const std::size_t next =
            text.compare(end, head.size(), head) == 0 ? text.find(tail, end) : std::string::npos;
        if (next == std::string::npos) return std::nullopt;
        end = next + tail.size();
    }
    return text.substr(begin, end - begin);
}

std::string Series::text_of(const Grid& grid) const
{
    return fmt::format("<Grid Name=\"{}\" GridType=\"Uniform\">\n<Time Value=\"{}\"/>\n{}"
                       "</Grid>\n",
                       name_, grid.t, grid.body);
}

void Series::add(const Grid& grid)
{
    const std::size_t before = frames_.size();
    frames_ += text_of(grid);
    try {
        replace();
    } catch (...) {
        frames_.resize(before);
        throw;
    }
}

void Series::replace() const
{
    replace_file(path_, fmt::format("<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
                                    "<Grid Name=\"{}\" GridType=\"Collection\" "
                                    "CollectionType=\"Temporal\">\n{}</Grid>\n</Domain>\n</Xdmf>\n",
                                    name_, frames_));
}

} // namespace starling::xdmf
