#pragma once
/// What a case file must satisfy across its keys: the tube fits the box and the grid fits the tube.
#include "config/case.hpp"
#include "config/case_values.hpp"

namespace starling {

/// Grid spacings that the parameters ask for, before counts are rounded.
Vec3 spacings(const GridParameters& grid, Real tube_length);

/// Reports every impossible combination; skips those whose keys have problems of their own.
void validate(CaseValues& values, const Case& c);

} // namespace starling
