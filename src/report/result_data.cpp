#include <cmath>

#include <fmt/format.h>

#include "report/page_data.hpp"
#include "theory/buckling_report.hpp"

namespace starling::report {

namespace {

constexpr Real round_enough = 0.995;      ///< area ratios above it are no collapse
constexpr Real least_displacement = 1e-6; ///< in R_0: less is round-off

/// The key numbers of a run, by the names of summary.json.
class Numbers {
public:
    Numbers(const Json& summary, const TableContents& series) : summary_(summary), series_(series)
    {
        if (!summary.is_object()) return;
        units_ = summary.value("units", Json::object());
        theory_ = summary.value("theory", Json());
        cycle_ = summary.value("cycle", Json());
    }
    /// NaN where there is no such number.
    Real value(const std::string& name) const
    {
        if (summary_.is_object()) return number(summary_, name);
        const TableColumn* column = series_.find(name);
        return column && !column->values.empty() ? column->values.back() : std::nan("");
    }
    /// "mean", "min" or "max" of a number over the last cycle of the drive.
    Real over_cycle(const std::string& name, const char* which) const
    {
        return cycle_.contains(name) ? number(cycle_[name], which) : std::nan("");
    }
    Real theory(const std::string& name) const { return number(theory_, name); }
    std::string unit(const std::string& name) const
    {
        const TableColumn* column = series_.find(name);
        return units_.value(name, column ? column->unit : std::string("1"));
    }

private:
    static Real number(const Json& from, const std::string& name)
    {
        const bool is = from.is_object() && from.contains(name) && from[name].is_number();
        return is ? from[name].get<Real>() : std::nan("");
    }

    const Json& summary_;
    const TableContents& series_;
    Json units_ = Json::object(), theory_, cycle_;
};

/// Rows of the table of results; numbers that do not exist make none.
class Rows {
public:
    explicit Rows(const Numbers& numbers) : numbers_(numbers) {}

    void add(const char* label, Real value, const std::string& unit)
    {
        if (std::isfinite(value))
            rows_.push_back({{"label", label}, {"value", value}, {"unit", unit}});
    }
    void add(const char* label, const std::string& name)
    {
        add(label, numbers_.value(name), numbers_.unit(name));
    }
    /// Sets theory and the relative difference beside the last row.
    void beside(Real theory, Real difference)
    {
        if (!std::isfinite(theory) || rows_.empty()) return;
        rows_.back()["theory"] = theory;
        if (std::isfinite(difference)) rows_.back()["difference"] = difference;
    }
    const Json& json() const { return rows_; }

private:
    const Numbers& numbers_;
    Json rows_ = Json::array();
};

void add_flow(Rows& rows, const Numbers& n)
{
    rows.add("Flow rate half way, Q", "Q_mid");
    rows.beside(n.theory("Q_1d"), n.theory("Q_relative_difference"));
    rows.add("Flow rate over that of the undeformed tube at U_c, Q/Q\u2080", "Q_mid_over_Q0");
    rows.add("Flow through the wall (leak) over Q", 100 * n.value("leak_over_Q"), "%");
}

void add_displacement(Rows& rows, const Numbers& n, Real R_0)
{
    const Real displacement = n.value("R_max") - R_0;
    if (!(std::abs(displacement) > least_displacement * R_0)) return;
    rows.add("Largest mean displacement, R_max\u00a0\u2212\u00a0R\u2080", displacement,
             n.unit("R_max"));
    rows.beside(n.theory("R_max_1d") - R_0, n.theory("displacement_relative_difference"));
}

void add_radius(Rows& rows, const Numbers& n, const Case& c)
{
    rows.add("Largest ring-averaged radius, R_max", "R_max");
    rows.beside(n.theory("R_max_1d"), n.theory("R_max_relative_difference"));
    if (c.tube.rigid) return;
    add_displacement(rows, n, c.scaling.factor(Quantity::length));
    rows.add("Largest strain of the wall", 100 * n.value("max_strain"), "%");
}

struct CycleRow {
    const char *name, *mean, *min, *max; ///< of the number, labels
};

/// Means and extremes over the last cycle of the drive.
void add_cycle(Rows& rows, const Numbers& n)
{
    static const CycleRow all[] = {
        {"Q_mid", "Flow rate half way, mean over the last cycle", "Least flow rate in it",
         "Largest flow rate in it"},
        {"P_in", "Pressure at the inlet, mean over the cycle", "Least pressure in it",
         "Largest pressure in it"},
        {"P_out", "Pressure at the outlet, mean over the cycle", "Least pressure in it",
         "Largest pressure in it"},
        {"R_max", "Largest radius, mean over the cycle", "Least in it", "Largest in it"}};
    for (const CycleRow& row : all) {
        const std::string unit = n.unit(row.name);
        rows.add(row.mean, n.over_cycle(row.name, "mean"), unit);
        rows.add(row.min, n.over_cycle(row.name, "min"), unit);
        rows.add(row.max, n.over_cycle(row.name, "max"), unit);
    }
}

/// What linear theory says of the load, and what the run made of it.
void add_collapse(Rows& rows, const Numbers& n, const Case& c)
{
    if (!(n.value("min_area_ratio") < round_enough)) return;
    rows.add("Smallest cross-section over the undeformed one", "min_area_ratio");
    rows.add("Smallest gap between opposite walls", "smallest_gap");
    rows.add("The same over the grid spacing", "min_gap_over_spacing");
    rows.add("Lobes", std::isfinite(n.value("mode")) ? n.value("mode") : n.value("lobes"), "1");
    const auto buckling = buckling_report({c.tube, c.material, c.fluid, c.drive});
    if (!buckling || !buckling->under_own_pressure) return;
    rows.beside(buckling->under_own_pressure->n, std::nan(""));
    rows.add("Load over the one that buckles the tube by linear theory",
             1 / buckling->under_own_pressure->factor, "1");
}

} // namespace

Json result_data(const Json& summary, const TableContents& series, const Case& c)
{
    const Numbers numbers(summary, series);
    Rows rows(numbers);
    add_flow(rows, numbers);
    add_radius(rows, numbers, c);
    add_cycle(rows, numbers);
    add_collapse(rows, numbers, c);
    rows.add("Volume enclosed by the wall", "volume");
    rows.add("Elastic energy of the wall", "elastic_energy");
    if (c.material.bending > 0) rows.add("Bending energy of the wall", "bending_energy");
    return rows.json();
}

} // namespace starling::report
