#include "report.hpp"

#include <cmath>
#include <iterator>
#include <tuple>

#include <fmt/format.h>

#include "config/shipped_cases.hpp"
#include "console.hpp"
#include "output/shell_word.hpp"
#include "output/summary.hpp"
#include "simulation/run.hpp"

namespace starling::app {

namespace {

/// Lines "  label   value unit", with numbers in the case's units.
class Table {
public:
    explicit Table(const Scaling& scaling) : scaling_(scaling) {}

    void heading(const std::string& text) { text_ += text + "\n"; }
    void line(const std::string& label, const std::string& value)
    {
        fmt::format_to(std::back_inserter(text_), "  {:<34}{}\n", label, value);
    }
    void line(const std::string& label, Real value, Quantity quantity = Quantity::none)
    {
        line(label, number(value, quantity));
    }
    std::string number(Real value, Quantity quantity) const
    {
        const std::string unit = quantity == Quantity::none ? "" : " " + scaling_.unit(quantity);
        return bare_number(value, quantity) + unit;
    }
    std::string bare_number(Real value, Quantity quantity) const
    {
        return fmt::format("{:.5g}", value * scaling_.factor(quantity));
    }
    const std::string& text() const { return text_; }

private:
    Scaling scaling_;
    std::string text_;
};

std::string memory_text(Index bytes)
{
    const double mega = static_cast<double>(bytes) / 1e6;
    return mega < 1000 ? fmt::format("{:.0f} MB", mega) : fmt::format("{:.1f} GB", mega / 1000);
}

void add_speed(Table& table, const Summary& s)
{
    table.line("time", fmt::format("{} on {} thread{}, {:.3g} million cell-steps/s",
                                   duration_text(s.wall_seconds), s.threads,
                                   s.threads == 1 ? "" : "s", s.cell_steps_per_second / 1e6));
    table.line("peak memory", memory_text(s.peak_memory_bytes));
}

void add_results(Table& table, const Summary& s)
{
    const Sample& last = s.last;
    table.line("flow rate in, middle, out",
               fmt::format("{}, {}, {}", table.bare_number(last.Q_in, Quantity::flow_rate),
                           table.bare_number(last.Q_mid, Quantity::flow_rate),
                           table.number(last.Q_out, Quantity::flow_rate)));
    table.line("flow rate over undeformed tube's", s.Q_mid_over_Q0());
    if (std::isfinite(s.leak_over_Q()))
        table.line("leak through the wall",
                   fmt::format("{:.2f} % of the flow", 100 * s.leak_over_Q()));
    table.line("largest radius", table.number(last.R_max, Quantity::length) +
                                     " at x = " + table.number(last.x_R_max, Quantity::length));
    table.line("largest strain", fmt::format("{:.2f} %", 100 * last.max_strain));
}

void add_cycle(Table& table, const CycleMemory& cycle)
{
    const std::string change =
        std::isfinite(cycle.change)
            ? fmt::format(", the last within {:.2g} of the one before", cycle.change)
            : "";
    table.line("cycles", fmt::format("{} of {}{}", cycle.cycles,
                                     table.number(cycle.period, Quantity::time), change));
    for (const auto& [label, member, quantity] :
         {std::tuple{"flow rate half way", &Sample::Q_mid, Quantity::flow_rate},
          {"inlet pressure", &Sample::P_in, Quantity::pressure},
          {"outlet pressure", &Sample::P_out, Quantity::pressure},
          {"largest radius", &Sample::R_max, Quantity::length}}) {
        const CycleValues v = values_over(cycle.last, member);
        table.line(fmt::format("{} over a cycle", label),
                   fmt::format("{} to {}, mean {}", table.bare_number(v.min, quantity),
                               table.bare_number(v.max, quantity), table.number(v.mean, quantity)));
    }
}

std::string comparison(const char* what, Real found, Real expected)
{
    return fmt::format("  {:<34}{:>12.5g}{:>12.5g}{:>+11.2f} %\n", what, found, expected,
                       100 * relative_difference(found, expected));
}

std::string theory_text(const Summary& s)
{
    if (!s.theory) return "";
    std::string text =
        fmt::format("{:<36}{:>12}{:>12}{:>13}\n", "Against the one-dimensional model", "run",
                    "model", "difference");
    if (s.theory->Q != 0)
        text += comparison("flow rate Q/Q_0", s.Q_mid_over_Q0(), s.theory->Q / s.Q_0);
    if (std::abs(s.theory->R_max - 1) > 1e-9)
        text +=
            comparison("largest displacement R_max/R_0 - 1", s.last.R_max - 1, s.theory->R_max - 1);
    return text;
}

std::string warning_text(const std::vector<std::string>& warnings)
{
    std::string text;
    for (const std::string& w : warnings) text += "Warning: " + w + "\n";
    return text;
}

std::string phase_text(const Summary& s)
{
    double total = 0;
    for (const auto& phase : s.phase_seconds) total += phase.second;
    if (total == 0) return "";
    std::string text = "Time per phase of the step\n";
    for (const auto& [name, seconds] : s.phase_seconds)
        fmt::format_to(std::back_inserter(text), "  {:<34}{:>10.2f} s{:>8.1f} %\n", name, seconds,
                       100 * seconds / total);
    return text;
}

std::string way_on(const Summary& s, const Case& c, const std::string& directory)
{
    const std::string later = later_end(c, s.reason, s.last.step);
    const std::string resume = "starling resume " + shell_word(directory);
    return later.empty() ? "  go on: " + resume + "\n"
                         : "  go further: " + resume + " --set " + later + "\n";
}

std::string files_text(const Summary& s, const Case& c, const std::filesystem::path& directory)
{
    std::string text = "Files in " + directory.string() + " (docs/results.md)\n";
    text += "  summary.json, series.csv, profile.csv, sections.csv, case.toml\n";
    if (c.output.wall || c.output.fluid) {
        text += std::string("  ") + (c.output.wall ? "wall.xdmf" : "") +
                (c.output.wall && c.output.fluid ? ", " : "") +
                (c.output.fluid ? "fluid.xdmf" : "") + ": open with ParaView\n";
    }
    if (c.checkpoint.keep > 0) text += way_on(s, c, directory.string());
    text += "  pictures: starling plot " + shell_word(directory) + "\n";
    return text + "  a page for the browser: starling report " + directory.string() + "\n";
}

void add_numbers(Table& table, const Case& c, const RunEstimate& e)
{
    table.line("Re", c.fluid.reynolds);
    if (!c.tube.rigid) {
        table.line("eps", c.material.eps);
        table.line("B", c.material.bending);
    }
    table.line("Delta P / Delta P_0", c.pressure_ratio());
    table.line("length of the tube", c.tube.length, Quantity::length);
    if (!c.tube.rigid)
        table.line("Moens-Korteweg wave speed",
                   table.number(e.wave_speed, Quantity::velocity) + ", with E/(1 - nu^2)");
}

void add_discretisation(Table& table, const RunEstimate& e, Index available)
{
    table.line("cells", fmt::format("{} x {} x {} = {}", e.cells_xyz[0], e.cells_xyz[1],
                                    e.cells_xyz[2], e.cells));
    table.line("spacing x, y, z",
               fmt::format("{}, {}, {}", table.number(e.spacing.x, Quantity::none),
                           table.number(e.spacing.y, Quantity::none),
                           table.number(e.spacing.z, Quantity::none)) +
                   " (R_0)");
    table.line("wall", fmt::format("about {} vertices, {} triangles", e.vertices, e.elements));
    table.line("memory", "about " + memory_text(e.memory_bytes) + " (" + memory_text(available) +
                             " are free)");
}

void add_limits(Table& table, const Case& c, const RunEstimate& e)
{
    for (const TimeStepLimit& limit : e.limits)
        table.line(limit.name, table.number(limit.dt, Quantity::time) +
                                   (limit.name == e.binding.name ? "   <- binds" : ""));
    if (c.time.step)
        table.line(e.binding.name, e.binding.dt, Quantity::time);
    else if (c.time.safety != 1)
        table.line("safety factor", c.time.safety);
    table.line("step taken", e.dt, Quantity::time);
}

void add_cost(Table& table, const Case& c, const RunEstimate& e)
{
    if (c.stop.steady_tolerance)
        table.line("relaxation time of the tube", e.relaxation_time, Quantity::time);
    const char* about = e.at_least ? "more than" : "about";
    if (std::isfinite(e.duration)) {
        table.line("simulated time",
                   fmt::format("{} {}", about, table.number(e.duration, Quantity::time)));
        table.line("steps", fmt::format("{} {:.0f}", about, e.steps));
    }
    if (std::isfinite(e.seconds))
        table.line("wall-clock time",
                   fmt::format("{} {} at {:.0f} million cell-steps/s", about,
                               duration_text(e.seconds), assumed_cell_steps_per_second / 1e6));
}

} // namespace

std::string summary_text(const Summary& summary, const Case& c,
                         const std::filesystem::path& directory)
{
    Table table(c.scaling);
    table.heading(fmt::format("Ended ({}) after {} steps at t = {}", summary.reason,
                              summary.last.step, table.number(summary.last.t, Quantity::time)));
    add_speed(table, summary);
    add_results(table, summary);
    if (summary.cycle) add_cycle(table, *summary.cycle);
    return table.text() + theory_text(summary) + warning_text(summary.warnings) +
           phase_text(summary) + files_text(summary, c, directory);
}

std::string check_text(const Case& c, const RunEstimate& estimate)
{
    const Index available = available_memory_bytes();
    Table table(c.scaling);
    table.heading(c.title.empty() ? "Case" : c.title);
    add_numbers(table, c, estimate);
    table.heading("Grid and wall");
    add_discretisation(table, estimate, available);
    table.heading("Limits of the time step");
    add_limits(table, c, estimate);
    table.heading("Expected cost");
    add_cost(table, c, estimate);
    std::vector<std::string> warnings = estimate.warnings;
    const bool fits = estimate.memory_bytes <= available;
    if (!fits)
        warnings.push_back(fmt::format("this machine would refuse to run it: it needs about {} of "
                                       "memory and {} are free",
                                       memory_text(estimate.memory_bytes), memory_text(available)));
    return table.text() + warning_text(warnings) +
           (fits ? "The case is valid.\n" : "The case is valid, but not for this machine.\n");
}

std::string case_list_text()
{
    std::string text;
    for (const ShippedCase& c : shipped_cases())
        fmt::format_to(std::back_inserter(text), "{:<24}{}\n", c.name, c.description);
    return text + "Print one with: starling cases NAME > my_case.toml\n";
}

std::string shipped_case_text(const std::string& name)
{
    return std::string(shipped_case(name).text);
}

} // namespace starling::app
