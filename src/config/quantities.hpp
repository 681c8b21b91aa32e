#pragma once
/// The quantities of a case file: their dimensions, their usual units, and how they are written.
#include <functional>
#include <string>

#include "config/scaling.hpp"
#include "config/units.hpp"

namespace starling {

Dimension dimension(Quantity q);

/// What has this dimension: "a length", or "something in kg m^2" where it has no name here.
std::string describe(Dimension d);

/// The units a message offers for a quantity: "Pa, kPa, mmHg, cmH2O".
std::string usual_units(Quantity q);

/// The shortest text with a unit that `same` accepts when it is read back (its value in SI).
std::string format_measure(long double si, Quantity q,
                           const std::function<bool(long double)>& same);

} // namespace starling
