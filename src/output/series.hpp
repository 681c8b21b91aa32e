#pragma once
/// series.csv: one row per sample in time.
#include <limits>

#include "output/table.hpp"
#include "solver/monitor_data.hpp"

namespace starling {

/// The columns of series.csv in their order.
std::span<const Column<Sample>> sample_columns();

/// Writes series.csv; each row is on disk when `write` returns.
class SeriesWriter : public TableWriter<Sample> {
public:
    SeriesWriter(const std::filesystem::path& path, const Scaling& scaling)
        : TableWriter(path, sample_columns(), scaling)
    {
    }
    /// Goes on behind the row of step `last_row`; throws InputError where there is none.
    SeriesWriter(const std::filesystem::path& path, const Scaling& scaling, Index last_row)
        : TableWriter(path, sample_columns(), scaling, "step", last_row)
    {
    }
    /// Throws InputError where the file lacks the row of `step`.
    static void check_row(const std::filesystem::path& path, const Scaling& scaling, Index step)
    {
        length_up_to(path, sample_columns(), scaling, "step", step);
    }
    /// Whether the file has the row of `step`.
    static bool has_row(const std::filesystem::path& path, const Scaling& scaling, Index step);
};

/// What stands in a series.csv.
struct SeriesContents {
    Index rows = 0;
    Index first_step = 0, last_step = 0;
    Real first_t = 0, last_t = 0;
    std::string unit_of_t;
};

/// Reads a series.csv row by row, up to that of step `last` if there is one; throws
/// std::runtime_error, without the file's name, at the first that is wrong.
SeriesContents inspect_series(const std::filesystem::path& path,
                              Index last = std::numeric_limits<Index>::max());

/// Mean of |leak| over the mean of the larger of |Q_in| and |Q_out|, of the rows of a series.csv in
/// the last half of the time up to a step; NaN without flow, or where a row up to there is not
/// whole. Throws as read_table does.
Real mean_leak_over_Q(const std::filesystem::path& path, Index last_step);

} // namespace starling
