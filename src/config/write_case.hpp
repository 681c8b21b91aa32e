#pragma once
/// From a Case to a case file.
#include <string>

#include "config/case.hpp"

namespace starling {

/// The case as TOML in its own units, every default filled in; reading it gives the same Case to
/// the bit.
std::string write_case(const Case& c);

} // namespace starling
