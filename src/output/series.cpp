#include "output/series.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "core/error.hpp"
#include "output/read_table.hpp"

namespace starling {

std::span<const Column<Sample>> sample_columns()
{
    using enum Quantity;
    static const Column<Sample> columns[] = {
        {"t", time, &Sample::t, "time"},
        {"step", none, &Sample::step, "steps taken"},
        {"dt", time, &Sample::dt, "time step"},
        {"Q_in", flow_rate, &Sample::Q_in, "flow rate inside the tube at x = 0"},
        {"Q_mid", flow_rate, &Sample::Q_mid, "flow rate inside the tube half way"},
        {"Q_out", flow_rate, &Sample::Q_out, "flow rate inside the tube at x = L"},
        {"Q_exterior", flow_rate, &Sample::Q_exterior, "flow rate outside the tube half way"},
        {"P_in", pressure, &Sample::P_in, "pressure at the inlet inside the tube"},
        {"P_out", pressure, &Sample::P_out, "pressure at the outlet inside the tube"},
        {"dV_dt", flow_rate, &Sample::dV_dt, "rate of change of the enclosed volume"},
        {"leak", flow_rate, &Sample::leak, "flow through the wall: dV_dt - (Q_in - Q_out)"},
        {"volume", volume, &Sample::volume, "volume enclosed by the wall"},
        {"R_max", length, &Sample::R_max, "largest ring-averaged radius"},
        {"x_R_max", length, &Sample::x_R_max, "where it is"},
        {"R_min", length, &Sample::R_min, "smallest distance of the wall from the axis"},
        {"smallest_gap", length, &Sample::smallest_gap, "smallest distance of opposite walls"},
        {"min_area_ratio", none, &Sample::min_area_ratio, "smallest cross-section / undeformed"},
        {"x_min_area", length, &Sample::x_min_area, "where it is"},
        {"lobes", none, &Sample::lobes, "of that cross-section"},
        {"kinetic_energy", energy, &Sample::kinetic_energy, "of the fluid"},
        {"elastic_energy", energy, &Sample::elastic_energy, "of the wall"},
        {"bending_energy", energy, &Sample::bending_energy, "of the wall"},
        {"power_in", power, &Sample::power_in, "work of the inlet and kinetic energy that enters"},
        {"power_out", power, &Sample::power_out, "the same that leaves through the outlet"},
        {"power_exterior", power, &Sample::power_exterior, "that enters outside the tube"},
        {"power_viscous", power, &Sample::power_viscous, "dissipated by the fluid's viscosity"},
        {"power_kinetic", power, &Sample::power_kinetic, "rate of change of kinetic_energy"},
        {"power_wall", power, &Sample::power_wall, "work on the wall"},
        {"power_residual", power, &Sample::power_residual, "that the balance leaves over"},
        {"largest_displacement", length, &Sample::largest_displacement, "of a wall vertex"},
        {"max_strain", none, &Sample::max_strain, "largest principal stretch - 1"},
        {"cfl", none, &Sample::cfl, "largest speed times dt over the spacing"},
    };
    return columns;
}

bool SeriesWriter::has_row(const std::filesystem::path& path, const Scaling& scaling, Index step)
{
    try {
        check_row(path, scaling, step);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

SeriesContents inspect_series(const std::filesystem::path& path, Index last)
{
    const auto columns = sample_columns();
    std::istringstream text(read_text(path));
    std::string line;
    SeriesContents found;
    if (!std::getline(text, line)) throw std::runtime_error("is empty");
    const auto titles = cells_of(line);
    bool known = titles.size() == columns.size();
    for (std::size_t n = 0; known && n < titles.size(); ++n)
        known = titles[n].starts_with(std::string(columns[n].name) + " [");
    if (!known) throw std::runtime_error("has other columns than this Starling writes");
    found.unit_of_t = titles[0].substr(3, titles[0].size() - 4);
    while (found.last_step < last && std::getline(text, line)) {
        const std::string row = fmt::format("row {}", found.rows + 1);
        const auto cells = cells_of(line);
        if (text.eof() || cells.size() != columns.size())
            throw std::runtime_error(row + " is cut off");
        for (const std::string& cell : cells)
            if (!number_in(cell)) throw std::runtime_error(row + " holds '" + cell + "'");
        const Real t = *number_in(cells[0]);
        const auto step = static_cast<Index>(*number_in(cells[1]));
        if (found.rows > 0 && (step <= found.last_step || !(t > found.last_t)))
            throw std::runtime_error(row + " goes back in time");
        if (found.rows++ == 0) found.first_step = step, found.first_t = t;
        found.last_step = step;
        found.last_t = t;
    }
    return found;
}

Real mean_leak_over_Q(const std::filesystem::path& path, Index last_step)
{
    const TableContents table = read_table(path);
    const auto values = [&](const char* name) {
        const TableColumn* column = table.find(name);
        if (column == nullptr) throw InputError(path.string() + ": has no column " + name);
        return std::span(column->values);
    };
    const auto t = values("t"), step = values("step"), leak = values("leak"), in = values("Q_in"),
               out = values("Q_out");
    const auto rows = static_cast<std::size_t>(
        std::ranges::upper_bound(step, static_cast<Real>(last_step)) - step.begin());
    if (table.cut && (rows == 0 || step[rows - 1] < static_cast<Real>(last_step)))
        return std::numeric_limits<Real>::quiet_NaN();
    Real leaks = 0, flows = 0;
    for (std::size_t n = 0; n < rows; ++n) {
        if (t[n] < (t[0] + t[rows - 1]) / 2) continue;
        leaks += std::abs(leak[n]);
        flows += std::max(std::abs(in[n]), std::abs(out[n]));
    }
    return leaks / flows;
}

} // namespace starling
