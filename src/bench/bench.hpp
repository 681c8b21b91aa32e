#pragma once
/// Times whole steps and holds them against the machine's bandwidth (`starling bench`).
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/bandwidth.hpp"
#include "bench/stepped_problem.hpp"

namespace starling::bench {

/// What is measured.
struct Plan {
    std::vector<Problem> problems;
    std::vector<int> threads;
    int repeats = 5;
    Index triad_size = Index{1} << 25; ///< items of each of its two arrays (256 MiB)
};

/// The triad on so many threads, before and after the steps.
struct BandwidthRow {
    int threads = 1;
    Index array_bytes = 0;
    double best = 0, median = 0; ///< bytes per second
};

/// One problem on so many threads.
struct StepRow {
    Problem problem;
    int threads = 1;
    Index vertices = 0; ///< that the wall has
    Index steps_per_repeat = 0;
    Timing step; ///< mean over the steps of each repeat, in seconds, as are the phases
    std::vector<std::pair<std::string, Timing>> phases;
    Footprint footprint;
    double bandwidth = 0; ///< the best of the triad on as many threads

    /// Cell-steps per second where a step takes so many seconds.
    double rate(double seconds) const
    {
        return static_cast<double>(problem.cell_count()) / seconds;
    }
    /// The fastest rate over that at which separate kernels would use all of the bandwidth.
    double share_of_bound() const;
};

struct Report {
    int processors = 0;
    double load_before = 0, load_after = 0; ///< of the machine, mean over a minute
    std::vector<BandwidthRow> bandwidth;
    std::vector<StepRow> rows;
};

/// Throws InputError where a problem of the plan needs more than `available` bytes.
void check_memory(const Plan& plan, Index available);

/// Runs the plan; says what it is about to do, line by line, through `progress`. Numbers of threads
/// take turns repeat by repeat, so that what else the machine does meets all of them. Throws
/// NumericalError where a problem breaks down.
Report run(const Plan& plan, const std::function<void(const std::string&)>& progress);

/// The report as JSON; docs/performance.md lists the keys.
std::string to_json(const Report& report);
/// The report as a table for people.
std::string to_text(const Report& report);

} // namespace starling::bench
