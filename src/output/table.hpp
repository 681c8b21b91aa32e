#pragma once
/// CSV tables whose columns are described once, as data.
#include <filesystem>
#include <fstream>
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
    /// Creates or empties the file.
    explicit LineFile(std::filesystem::path path);
    /// Writes one line and hands it to the operating system.
    void write(const std::string& line);

private:
    std::filesystem::path path_;
    std::ofstream stream_;
};

/// "name [unit]" as it stands in a header row.
std::string column_title(const char* name, Quantity quantity, const Scaling& scaling);

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
        std::string line;
        for (const Column<Row>& c : columns_)
            line += separator(line) + column_title(c.name, c.quantity, scaling_);
        file_.write(line);
    }

    void write(const Row& row)
    {
        std::string line;
        for (const Column<Row>& c : columns_) line += separator(line) + cell(row, c);
        file_.write(line);
    }

private:
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
