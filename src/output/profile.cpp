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
        {"leak", flow_rate, &ProfileRow::leak, "flow in through the wall from the inlet to here"},
        {"gap", length, &ProfileRow::gap, "smallest distance of opposite walls"},
        {"lobes", none, &ProfileRow::lobes, "number of lobes, 0 where round"},
        {"mode_2", length, &ProfileRow::mode_2, "amplitude of two lobes in the radius"},
        {"mode_3", length, &ProfileRow::mode_3, "of three"},
        {"mode_4", length, &ProfileRow::mode_4, "of four"},
        {"mode_5", length, &ProfileRow::mode_5, "of five"},
        {"mode_6", length, &ProfileRow::mode_6, "of six"},
        {"mode_7", length, &ProfileRow::mode_7, "of seven"},
        {"mode_8", length, &ProfileRow::mode_8, "of eight"},
        {"TAWSS", shear_stress, &ProfileRow::TAWSS, "time-averaged wall shear stress"},
        {"OSI", none, &ProfileRow::OSI, "oscillatory shear index"},
    };
    return columns;
}

void write_profile(const std::filesystem::path& path, const std::vector<ProfileRow>& rows,
                   const Scaling& scaling)
{
    write_table(path, profile_columns(), scaling, rows);
}

} // namespace starling
