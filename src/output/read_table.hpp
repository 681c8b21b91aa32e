#pragma once
/// Text files of a run, read back: tables with a header row "name [unit]".
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace starling {

/// The whole of a file; empty where it cannot be read.
std::string read_text(const std::filesystem::path& path);

/// The cells of one line, separated by commas.
std::vector<std::string> cells_of(const std::string& line);

/// The number that the text is, "nan" included; nothing where it is none.
std::optional<Real> number_in(const std::string& text);

/// A column of a table, in the units of the file.
struct TableColumn {
    std::string name, unit;
    std::vector<Real> values;
};

/// Columns of equal length.
struct TableContents {
    std::vector<TableColumn> columns;
    bool cut = false; ///< the file goes on with a row that is not whole

    std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
    /// The column of that name, or null.
    const TableColumn* find(const std::string& name) const;
};

/// Reads the rows of a CSV file up to the first that is not whole, as a kill may leave the last.
/// Throws InputError where the file is missing or has no header row.
TableContents read_table(const std::filesystem::path& path);

} // namespace starling
