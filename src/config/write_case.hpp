#pragma once
/// From a Case to a case file.
#include <string>
#include <string_view>

#include "config/case.hpp"

namespace starling {

/// The case as TOML in its own units, every default filled in; reading it gives the same Case to
/// the bit.
std::string write_case(const Case& c);

/// The same as a file that can tell whether it is whole: behind the line `head`, which goes on to
/// say how the last line reads.
std::string write_case_with_end(const std::string& head, const Case& c);

/// Whether the text of a file begins as one of those and lacks the last line.
bool lacks_end(std::string_view text);

} // namespace starling
