#include "bench/bench.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "bench/traffic.hpp"
#include "core/error.hpp"
#include "core/for_each.hpp"

namespace starling::bench {

namespace {

constexpr int warm_up_steps = 3;
constexpr double cell_steps_per_repeat = 30e6;

double load_average()
{
    double load = 0;
    return getloadavg(&load, 1) == 1 ? load : 0;
}

Index steps_per_repeat(const Problem& p)
{
    const double steps = cell_steps_per_repeat / static_cast<double>(p.cell_count());
    return std::clamp<Index>(static_cast<Index>(steps), 2, 100);
}

/// Sets the number of threads for as long as it lives.
class Threads {
public:
    explicit Threads(int threads) : before_(max_threads()) { omp_set_num_threads(threads); }
    ~Threads() { omp_set_num_threads(before_); }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

private:
    int before_;
};

/// Adds one repeat to a row.
void repeat(SteppedProblem& problem, StepRow& row)
{
    const Threads threads(row.threads);
    problem.step(); // these threads' caches
    const std::vector<double> before = problem.timer().seconds();
    for (Index n = 0; n < row.steps_per_repeat; ++n) problem.step();
    double sum = 0;
    for (std::size_t p = 0; p < before.size(); ++p) {
        const double seconds =
            (problem.timer().seconds()[p] - before[p]) / static_cast<double>(row.steps_per_repeat);
        row.phases[p].second.seconds.push_back(seconds);
        sum += seconds;
    }
    row.step.seconds.push_back(sum);
}

StepRow empty_row(const Problem& p, const BuiltProblem& built, int threads)
{
    StepRow row{p, threads, built.steps->vertices(), steps_per_repeat(p), {}, {}, built.footprint};
    for (const std::string& name : built.steps->timer().names())
        row.phases.emplace_back(name, Timing{});
    return row;
}

/// The rows of one problem, one for each number of threads.
std::vector<StepRow> measure(const Problem& p, const Plan& plan)
{
    const Threads most(*std::max_element(plan.threads.begin(), plan.threads.end()));
    const BuiltProblem built = build(p);
    std::vector<StepRow> rows;
    for (int threads : plan.threads) rows.push_back(empty_row(p, built, threads));
    for (int n = 0; n < warm_up_steps; ++n) built.steps->step();
    for (int n = 0; n < plan.repeats; ++n)
        for (StepRow& row : rows) repeat(*built.steps, row);
    if (!built.steps->sound())
        throw NumericalError("the steps broke down", "take another grid or wall");
    return rows;
}

std::string describe(const Problem& p)
{
    return grid_text(p.cells) +
           (p.vertices == 0 ? ", fluid alone" : ", wall of " + wall_text(p.vertices));
}

/// Times of the triad for each number of threads of the plan.
std::vector<Timing> run_triad(const Plan& plan, std::vector<Timing> timings)
{
    Triad triad(plan.triad_size);
    for (std::size_t n = 0; n < plan.threads.size(); ++n)
        for (double seconds : triad.run(plan.threads[n], plan.repeats).seconds)
            timings[n].seconds.push_back(seconds);
    return timings;
}

double best_bandwidth(const Report& report, int threads)
{
    for (const BandwidthRow& row : report.bandwidth)
        if (row.threads == threads) return row.best;
    return 0;
}

} // namespace

double StepRow::share_of_bound() const
{
    return rate(step.least()) * bytes_per_cell_step() / bandwidth;
}

void check_memory(const Plan& plan, Index available)
{
    for (const Problem& p : plan.problems) {
        const double needed = expected_bytes(p);
        if (needed > static_cast<double>(available))
            throw InputError(fmt::format("{}: needs about {:.2g} GB of memory and {:.2g} GB are "
                                         "free: take a smaller --grid",
                                         describe(p), needed / 1e9,
                                         static_cast<double>(available) / 1e9));
    }
}

Report run(const Plan& plan, const std::function<void(const std::string&)>& progress)
{
    Report report;
    report.processors = omp_get_num_procs();
    report.load_before = load_average();
    progress("bandwidth of memory");
    std::vector<Timing> triad = run_triad(plan, std::vector<Timing>(plan.threads.size()));
    for (std::size_t n = 0; n < plan.problems.size(); ++n) {
        progress(
            fmt::format("{} of {}: {}", n + 1, plan.problems.size(), describe(plan.problems[n])));
        for (StepRow& row : measure(plan.problems[n], plan)) report.rows.push_back(std::move(row));
    }
    progress("bandwidth of memory again");
    triad = run_triad(plan, std::move(triad));
    const double bytes = Triad::bytes_per_item * static_cast<double>(plan.triad_size);
    for (std::size_t n = 0; n < triad.size(); ++n)
        report.bandwidth.push_back({plan.threads[n],
                                    plan.triad_size * static_cast<Index>(sizeof(Real)),
                                    bytes / triad[n].least(), bytes / triad[n].median()});
    for (StepRow& row : report.rows) row.bandwidth = best_bandwidth(report, row.threads);
    report.load_after = load_average();
    return report;
}

} // namespace starling::bench
