#pragma once
/// summary.json: the key numbers of a run.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/cycle.hpp"

namespace starling {

/// Prediction of the one-dimensional model for the same case (solver units).
struct TheoryValues {
    Real Q = 0;
    Real R_max = 0;
};

/// leak over the larger of |Q_in| and |Q_out|; NaN without flow (both below 1e-6 R_0^2 U_c).
Real leak_over_Q(const Sample& s);

/// What a run came to. Numbers are in solver units.
struct Summary {
    std::string title;
    bool converged = false;    ///< the steady or the periodic criterion was met
    std::string reason;        ///< why the run ended
    Sample last;               ///< final sample
    Real mean_leak_over_Q = 0; ///< over the last half of the time; see mean_leak_over_Q
    Real spacing = 0;          ///< of the grid
    Real Q_0 = pi / 2;         ///< flow rate through the undeformed tube at U_c
    double wall_seconds = 0;
    double cell_steps_per_second = 0;
    int threads = 1;
    Index peak_memory_bytes = 0;
    Index cells = 0, vertices = 0, elements = 0;
    std::string version;
    std::vector<std::pair<std::string, double>> phase_seconds;
    std::optional<TheoryValues> theory;
    std::optional<CycleMemory> cycle;  ///< with one complete cycle at least
    std::optional<Vec3> breakdown;     ///< where the computation broke down
    std::vector<std::string> warnings; ///< what to know before the numbers are used

    Real Q_mid_over_Q0() const { return last.Q_mid / Q_0; }
    Real leak_over_Q() const { return starling::leak_over_Q(last); }
};

/// (value - reference) / reference.
inline Real relative_difference(Real value, Real reference) { return value / reference - 1; }

/// summary.json as text: numbers in the case's units, `units` names them; docs/results.md lists
/// the keys. Non-finite numbers become null.
std::string summary_json(const Summary& summary, const Scaling& scaling);

/// Writes `summary_json` to `path`, replacing the file as a whole.
void write_summary(const std::filesystem::path& path, const Summary& summary,
                   const Scaling& scaling);

/// Largest resident memory of this process so far.
Index peak_memory_bytes();

/// Memory that this process may still take: what the kernel reckons available, with swap, or what
/// its control group leaves if that is less.
Index available_memory_bytes();

} // namespace starling
