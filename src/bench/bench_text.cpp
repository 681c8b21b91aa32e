#include <iterator>

#include <fmt/format.h>

#include "bench/bench.hpp"
#include "bench/traffic.hpp"

namespace starling::bench {

namespace {

/// The fluid's row with the same grid and threads; null if there is none.
const StepRow* fluid_row(const Report& report, const StepRow& like)
{
    for (const StepRow& row : report.rows)
        if (row.problem.vertices == 0 && row.problem.cells == like.problem.cells &&
            row.threads == like.threads)
            return &row;
    return nullptr;
}

std::string threads_text(int threads)
{
    return fmt::format("{} thread{}", threads, threads == 1 ? "" : "s");
}

std::string machine_text(const Report& report)
{
    std::string text = fmt::format("Machine: {} processors, load {:.1f} before and {:.1f} after\n",
                                   report.processors, report.load_before, report.load_after);
    for (const BandwidthRow& b : report.bandwidth)
        text += fmt::format("  in-place triad, {:<26}{:>6.1f} GB/s (median {:.1f})\n",
                            threads_text(b.threads), b.best / 1e9, b.median / 1e9);
    return text + fmt::format("  a step in separate kernels moves {:.0f} bytes per cell\n",
                              bytes_per_cell_step());
}

std::string row_text(const Report& report, const StepRow& row)
{
    const Footprint& f = row.footprint;
    std::string text = fmt::format(
        "{}, {}, {}\n", grid_text(row.problem.cells),
        row.vertices == 0 ? "fluid alone" : fmt::format("wall of {} vertices", row.vertices),
        threads_text(row.threads));
    const auto line = [&](const std::string& label, double least, double median,
                          const std::string& rest) {
        fmt::format_to(std::back_inserter(text), "  {:<16}{:>11.3f} ms  median {:>11.3f} ms  {}\n",
                       label, 1e3 * least, 1e3 * median, rest);
    };
    line("step", row.step.least(), row.step.median(),
         fmt::format("{:.1f} M cell-steps/s (median {:.1f} M cell-steps/s)",
                     row.rate(row.step.least()) / 1e6, row.rate(row.step.median()) / 1e6));
    for (const auto& [name, timing] : row.phases)
        line(name, timing.least(), timing.median(),
             fmt::format("{:5.1f} %", 100 * timing.median() / row.step.median()));
    fmt::format_to(std::back_inserter(text),
                   "  {:.0f} % of the bandwidth bound; {:.0f} bytes per cell",
                   100 * row.share_of_bound(), f.bytes_per_cell);
    if (row.vertices > 0)
        fmt::format_to(std::back_inserter(text), ", {:.0f} bytes per vertex", f.bytes_per_vertex);
    if (const StepRow* fluid = fluid_row(report, row); row.vertices > 0 && fluid)
        fmt::format_to(std::back_inserter(text), "; {:.0f} % of the rate of fluid alone",
                       100 * fluid->step.least() / row.step.least());
    return text + "\n";
}

} // namespace

std::string to_text(const Report& report)
{
    std::string text = machine_text(report);
    for (const StepRow& row : report.rows) text += row_text(report, row);
    return text;
}

} // namespace starling::bench
