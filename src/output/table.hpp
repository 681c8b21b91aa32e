#pragma once
/// CSV tables whose columns are described once, as data.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <variant>

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
    /// Writes one line and hands it to the operating system.
    void write(const std::string& line);

    LineFile() = default;

private:
    std::filesystem::path path_;
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
        file_.write(header());
    }
    /// Goes on behind the last row whose entry of the column `key` is `last`; throws InputError
    /// where the file has another header or no such row.
    TableWriter(const std::filesystem::path& path, std::span<const Column<Row>> columns,
                const Scaling& scaling, const char* key, Index last)
        : columns_(columns), scaling_(scaling)
    {
        const auto at = std::find_if(columns.begin(), columns.end(), [&](const auto& c) {
            return std::string_view(c.name) == key;
        });
        file_ = LineFile(path, length_up_to(path, header(), at - columns.begin(), last));
    }

    void write(const Row& row)
    {
        std::string line;
        for (const Column<Row>& c : columns_) line += separator(line) + cell(row, c);
        file_.write(line);
    }

private:
    std::string header() const
    {
        std::string line;
        for (const Column<Row>& c : columns_)
            line += separator(line) + column_title(c.name, c.quantity, scaling_);
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

} // namespace starling
