#pragma once
/// report.html: a run on one page that opens in any browser, without a network.
#include <filesystem>
#include <string>
#include <vector>

namespace starling::report {

/// Name of the page in the directory of a run.
inline constexpr const char* file_name = "report.html";

/// What was written, and what the page leaves out and says so.
struct Written {
    std::filesystem::path path;
    std::vector<std::string> notes;
};

/// Writes the page of a run, finished or not, replacing an earlier one. Throws InputError where
/// the directory holds no results to show, std::runtime_error where the page cannot be written or
/// this Starling was built without it.
Written write_report(const std::filesystem::path& run_directory);

} // namespace starling::report
