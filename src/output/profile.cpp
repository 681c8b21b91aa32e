#include "output/profile.hpp"

namespace starling {

std::span<const Column<ProfileRow>> profile_columns()
{
    using enum Quantity;
    static const Column<ProfileRow> columns[] = {
        {"x", length, &ProfileRow::x, "position along the tube"},
        {"R_mean", length, &ProfileRow::R_mean, "ring-averaged radius"},
        {"R_min", length, &ProfileRow::R_min, "smallest radius of the ring"},
        {"R_max", length, &ProfileRow::R_max, "largest radius of the ring"},
        {"area", area, &ProfileRow::area, "cross-section inside the ring's polygon"},
        {"P_centre", pressure, &ProfileRow::P_centre, "pressure on the axis"},
        {"P_transmural", pressure, &ProfileRow::P_transmural, "internal - external pressure"},
        {"Q", flow_rate, &ProfileRow::Q, "flow rate inside the tube"},
    };
    return columns;
}

void write_profile(const std::filesystem::path& path, const std::vector<ProfileRow>& rows,
                   const Scaling& scaling)
{
    TableWriter<ProfileRow> table(path, profile_columns(), scaling);
    for (const ProfileRow& row : rows) table.write(row);
}

} // namespace starling
