#include "output/sections.hpp"

#include "output/table.hpp"

namespace starling {

void write_sections(const std::filesystem::path& path, const std::vector<SectionPoint>& points,
                    const Scaling& scaling)
{
    using enum Quantity;
    static const Column<SectionPoint> columns[] = {
        {"x", length, &SectionPoint::x, "position of the section"},
        {"theta", none, &SectionPoint::theta, "undeformed angle of the vertex"},
        {"y", length, &SectionPoint::y, "position of the vertex"},
        {"z", length, &SectionPoint::z, "position of the vertex"},
    };
    write_table<SectionPoint>(path, columns, scaling, points);
}

} // namespace starling
