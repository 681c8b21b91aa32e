#include <fmt/format.h>

#include "report/packed.hpp"
#include "report/page_data.hpp"

namespace starling::report {

namespace {

constexpr std::size_t most_rows = 4000;

std::vector<Real> chosen_values(const std::vector<Real>& values,
                                const std::vector<std::size_t>& rows)
{
    std::vector<Real> chosen;
    chosen.reserve(rows.size());
    for (const std::size_t row : rows) chosen.push_back(values[row]);
    return chosen;
}

} // namespace

Json table_data(const std::string& file, const TableContents& table, Notes& notes)
{
    const auto rows = spread(table.rows(), most_rows);
    if (rows.size() < table.rows())
        notes.push_back(fmt::format("{} has {} rows; the plots show {} of them, evenly spread.",
                                    file, table.rows(), rows.size()));
    Json columns = Json::array();
    for (const TableColumn& c : table.columns)
        columns.push_back({{"name", c.name},
                           {"unit", c.unit},
                           {"values", packed(chosen_values(c.values, rows))}});
    return {{"rows", rows.size()}, {"columns", columns}};
}

} // namespace starling::report
