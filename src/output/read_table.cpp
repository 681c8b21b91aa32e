#include "output/read_table.hpp"

#include <charconv>
#include <fstream>
#include <sstream>

#include "core/error.hpp"

namespace starling {

namespace {

TableColumn column_titled(const std::string& title)
{
    const std::size_t unit = title.find(" [");
    if (unit == std::string::npos || !title.ends_with("]")) return {title, "", {}};
    return {title.substr(0, unit), title.substr(unit + 2, title.size() - unit - 3), {}};
}

/// The numbers of a row; nothing where it is not whole.
std::optional<std::vector<Real>> row_of(const std::string& line, std::size_t columns)
{
    std::vector<Real> row;
    for (const std::string& cell : cells_of(line)) {
        const auto number = number_in(cell);
        if (!number) return std::nullopt;
        row.push_back(*number);
    }
    if (row.size() != columns) return std::nullopt;
    return row;
}

} // namespace

std::string read_text(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::vector<std::string> cells_of(const std::string& line)
{
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

std::optional<Real> number_in(const std::string& text)
{
    Real value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

const TableColumn* TableContents::find(const std::string& name) const
{
    for (const TableColumn& c : columns)
        if (c.name == name) return &c;
    return nullptr;
}

TableContents read_table(const std::filesystem::path& path)
{
    std::istringstream text(read_text(path));
    std::string line;
    if (!std::getline(text, line)) throw InputError(path.string() + ": is missing or empty");
    TableContents table;
    table.cut = text.eof();
    for (const std::string& title : cells_of(line)) table.columns.push_back(column_titled(title));
    while (!table.cut && std::getline(text, line)) {
        const auto row = row_of(line, table.columns.size());
        table.cut = !row || text.eof();
        if (table.cut) break;
        for (std::size_t n = 0; n < row->size(); ++n) table.columns[n].values.push_back((*row)[n]);
    }
    return table;
}

} // namespace starling
