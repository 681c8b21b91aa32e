#include "output/version.hpp"

#include "starling_git_revision.hpp" // made by tools/git_revision.cmake at every build

namespace starling {

std::string version()
{
    const std::string revision = STARLING_GIT_REVISION;
    return STARLING_RELEASE + (revision.empty() ? "" : " (git " + revision + ")");
}

} // namespace starling
