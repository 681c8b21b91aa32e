#include "simulation/run_warnings.hpp"

#include <fmt/format.h>

namespace starling {

namespace {

constexpr Real least_resolved_gap = 2; ///< in grid spacings
constexpr Real leak_to_warn_of = 0.02; ///< share of the flow

/// What lets less through, most likely (docs/numerics.md, "Leak").
std::string remedy_of_leak(const Case& c, const Summary& s)
{
    if (c.coupling.scheme != CouplingScheme::conserving)
        return "the scheme that leaks least is coupling.scheme = \"conserving\"";
    if (c.drive.has_waveform())
        return "the rigid parts follow a load that changes with a lag: take shorter ones or a "
               "smaller time step (time.safety)";
    if (!s.converged)
        return "the rigid parts follow a load that changes with a lag: wait for the steady state, "
               "or for the course in time take shorter rigid parts or a smaller time step";
    return "take a finer grid";
}

} // namespace

std::vector<std::string> run_warnings(const Case& c, const Summary& s, Real step_factor)
{
    std::vector<std::string> found;
    if (std::abs(s.leak_over_Q()) > leak_to_warn_of)
        found.push_back(fmt::format("the leak through the wall is {:.3g} % of the flow: {}",
                                    100 * s.leak_over_Q(), remedy_of_leak(c, s)));
    else if (s.mean_leak_over_Q > leak_to_warn_of)
        found.push_back(fmt::format("the leak through the wall was {:.3g} % of the flow on the "
                                    "mean of the last half of the time: {}",
                                    100 * s.mean_leak_over_Q, remedy_of_leak(c, s)));
    if (s.last.smallest_gap < least_resolved_gap * s.spacing)
        found.push_back(fmt::format("opposite walls are {:.2g} grid spacings apart: the flow "
                                    "between them is not resolved below 2",
                                    s.last.smallest_gap / s.spacing));
    if (s.theory && !s.converged)
        found.push_back("the run ended before it was found steady; the one-dimensional model "
                        "is steady");
    if (c.stop.periodic_tolerance && !s.converged)
        found.push_back("the run ended before its cycles agreed to the tolerance");
    if (step_factor < 1)
        found.push_back(fmt::format("the run broke down and went on with {:.3g} % of the automatic "
                                    "time step",
                                    100 * step_factor));
    return found;
}

} // namespace starling
