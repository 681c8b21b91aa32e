#include "commands.hpp"

#include <fmt/format.h>
#include <omp.h>

#include "config/read_case.hpp"
#include "config/shipped_cases.hpp"
#include "console.hpp"
#include "core/error.hpp"
#include "environment.hpp"
#include "report.hpp"
#include "simulation/estimate.hpp"
#include "simulation/run.hpp"
#include "theory/theory_report.hpp"

namespace starling::app {

namespace {

void run_command(const CommandLine& line)
{
    if (line.threads > 0) omp_set_num_threads(line.threads);
    const Case c = read_case(line.case_file, line.overrides);
    catch_stop_signals();
    const RunOptions options{line.directory, line.force, line.case_file};
    if (line.quiet) {
        QuietObserver observer;
        run(c, options, observer);
        return;
    }
    ConsoleObserver observer;
    const Summary summary = run(c, options, observer);
    observer.finished();
    fmt::print("{}", summary_text(summary, c, line.directory));
}

void check_command(const CommandLine& line)
{
    const Case c = read_case(line.case_file, line.overrides);
    fmt::print("{}", check_text(c, estimate_run(c)));
}

void theory_command(const CommandLine& line)
{
    const Case c = read_case(line.case_file, line.overrides);
    const TheoryReport report = theory_report({c.tube, c.material, c.fluid, c.drive});
    fmt::print("{}", line.csv ? to_csv(report, c.scaling) : to_text(report, c.scaling));
    if (!has_theory(c) && !line.csv)
        fmt::print("This case is outside the model: it holds for steady inflation at Re <= 1.\n");
}

void cases_command(const CommandLine& line)
{
    fmt::print("{}", line.name.empty() ? case_list_text() : shipped_case_text(line.name));
}

void plot_command(const CommandLine& line)
{
    if (!std::filesystem::exists(std::filesystem::path(line.directory) / "series.csv"))
        throw InputError(line.directory + ": holds no results (no series.csv)");
    run_python_tool("plot_run.py", {line.directory});
}

} // namespace

void execute(const CommandLine& line)
{
    if (line.command == "run")
        run_command(line);
    else if (line.command == "check")
        check_command(line);
    else if (line.command == "theory")
        theory_command(line);
    else if (line.command == "cases")
        cases_command(line);
    else if (line.command == "plot")
        plot_command(line);
}

} // namespace starling::app
