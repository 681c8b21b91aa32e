#pragma once
/// The page without its data: made from web/ by CMake and carried inside the program.
#include <string_view>

namespace starling::report {

/// Where the data go: a comment of the page's script of type application/json.
inline constexpr std::string_view data_mark = "/*STARLING-RUN*/";

/// Empty where Starling was built without npm.
extern const std::string_view page_template;

} // namespace starling::report
