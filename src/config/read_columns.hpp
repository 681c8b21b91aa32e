#pragma once
/// Two columns of numbers from a CSV file.
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace starling {

struct Columns {
    std::vector<Real> first, second;
};

/// The rows below a header, which may be missing. Throws std::invalid_argument with what is wrong
/// with the file or the line that is; `names` says what the columns are: "time,value".
Columns read_columns(const std::filesystem::path& file, std::string_view names);

} // namespace starling
