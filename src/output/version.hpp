#pragma once
/// Which Starling this is.
#include <string>

namespace starling {

/// Release and revision, as in "0.1.0 (git 0123456789ab)"; the revision is that of the checkout at
/// build time, with "+" for uncommitted changes, and is left out without git.
std::string version();

} // namespace starling
