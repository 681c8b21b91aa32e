#pragma once
/// CSV tables whose columns are described once, as data.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "config/scaling.hpp"
#include "core/types.hpp"

namespace starling {

/// One column: its name, what it measures and the member of `Row` it prints.
template <class Row>
struct Column {
    const char* name;
    Quantity quantity;
    std::variant<Real Row::*, Index Row::*> member;
    const char* meaning;
};

/// A text file of which every completed line is on disk; throws std::runtime_error when it is not.
class LineFile {
public:
    /// Creates or empties the file, or goes on behind its first `keep` bytes.
    explicit LineFile(std::filesystem::path path, std::optional<std::uintmax_t> keep = {});
    /// Writes one line and hands it to the operating system; a line that does not fit on the disk
    /// leaves nothing behind and may be written again.
    void write(const std::string& line);

    LineFile() = default;

private:
    std::filesystem::path path_;
    std::uintmax_t length_ = 0; ///< of the complete lines
    std::ofstream stream_;
};

/// "name [unit]" as it stands in a header row.
std::string column_title(const char* name, Quantity quantity, const Scaling& scaling);

/// Bytes of a table up to and including the row whose entry in column number `column` is `last`.
std::uintmax_t length_up_to(const std::filesystem::path& path, const std::string& header,
                            std::ptrdiff_t column, Index last);

/// Shortest decimal number that reads back to the same double.
std::string number_text(Real value);

/// Rows of type `Row` as CSV with a header row "name [unit]", numbers in the case's units.
template <class Row>
class TableWriter {
public:
    TableWriter(const std::filesystem::path& path, std::span<const Column<Row>> columns,
                const Scaling& scaling)
        : file_(path), columns_(columns), scaling_(scaling)
    {
        file_.write(header(columns, scaling));
    }
    /// Goes on behind the last row whose entry of the column `key` is `last`; throws InputError
    /// where the file has another header or no such row.
    TableWriter(const std::filesystem::path& path, std::span<const Column<Row>> columns,
                const Scaling& scaling, const char* key, Index last)
        : file_(path, length_up_to(path, columns, scaling, key, last)), columns_(columns),
          scaling_(scaling)
    {
    }
    /// Bytes up to the row that such a writer goes on behind; throws as it does.
    static std::uintmax_t length_up_to(const std::filesystem::path& path,
                                       std::span<const Column<Row>> columns, const Scaling& scaling,
                                       const char* key, Index last)
    {
        const auto at = std::find_if(columns.begin(), columns.end(), [&](const auto& c) {
            return std::string_view(c.name) == key;
        });
        return starling::length_up_to(path, header(columns, scaling), at - columns.begin(), last);
    }

    void write(const Row& row)
    {
        std::string line;
        for (const Column<Row>& c : columns_) line += separator(line) + cell(row, c);
        file_.write(line);
    }

private:
    static std::string header(std::span<const Column<Row>> columns, const Scaling& scaling)
    {
        std::string line;
        for (const Column<Row>& c : columns)
            line += separator(line) + column_title(c.name, c.quantity, scaling);
        return line;
    }
    static std::string separator(const std::string& line) { return line.empty() ? "" : ","; }

    std::string cell(const Row& row, const Column<Row>& c) const
    {
        if (const auto* count = std::get_if<Index Row::*>(&c.member))
            return std::to_string(row.**count);
        return number_text(row.*std::get<Real Row::*>(c.member) * scaling_.factor(c.quantity));
    }

    LineFile file_;
    std::span<const Column<Row>> columns_;
    Scaling scaling_;
};

/// Writes a whole table under another name and renames it; throws std::runtime_error where that
/// fails, with `path` as it was.
template <class Row>
void write_table(const std::filesystem::path& path, std::span<const Column<Row>> columns,
                 const Scaling& scaling, const std::vector<Row>& rows)
{
    const std::filesystem::path temporary = path.string() + ".new";
    try {
        {
            TableWriter<Row> table(temporary, columns, scaling);
            for (const Row& row : rows) table.write(row);
        }
        std::filesystem::rename(temporary, path);
    } catch (...) {
        std::error_code none;
        std::filesystem::remove(temporary, none);
        throw;
    }
}

} // namespace starling
