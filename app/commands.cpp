#include "commands.hpp"

#include <fmt/format.h>
#include <omp.h>

#include "bench.hpp"
#include "config/read_case.hpp"
#include "config/shipped_cases.hpp"
#include "console.hpp"
#include "core/error.hpp"
#include "environment.hpp"
#include "output/run_directory.hpp"
#include "output/shell_word.hpp"
#include "readers.hpp"
#include "report.hpp"
#include "report/write_report.hpp"
#include "simulation/estimate.hpp"
#include "simulation/resume.hpp"
#include "simulation/run.hpp"
#include "theory/buckling_report.hpp"
#include "theory/theory_report.hpp"
#include "theory/tube_waves.hpp"

namespace starling::app {

namespace {

/// Says where the surroundings of a breakdown can be looked at.
template <class Compute>
auto with_place_to_look(const std::string& directory, Compute compute)
{
    try {
        return compute();
    } catch (const NumericalError& e) {
        if (!std::filesystem::exists(std::filesystem::path(directory) / "breakdown_wall.xdmf"))
            throw;
        throw NumericalError(
            e, fmt::format("look: starling plot {1} draws {0}/breakdown.png; ParaView opens "
                           "{0}/breakdown_wall.xdmf and breakdown_fluid.xdmf",
                           directory, shell_word(directory)));
    }
}

/// Runs `compute` with an observer; prints unless the user wants it quiet.
template <class Compute>
void observe(const CommandLine& line, const Case& c, Compute compute)
{
    catch_stop_signals();
    if (line.quiet) {
        QuietObserver observer;
        with_place_to_look(line.directory, [&] { return compute(observer); });
        return;
    }
    ConsoleObserver observer;
    const Summary summary = with_place_to_look(line.directory, [&] { return compute(observer); });
    observer.finished();
    fmt::print("{}", summary_text(summary, c, line.directory));
}

void run_command(const CommandLine& line)
{
    if (line.threads > 0) omp_set_num_threads(line.threads);
    const Case c = read_case(line.case_file, line.overrides);
    const RunOptions options{line.directory, line.force, line.case_file};
    observe(line, c, [&](RunObserver& observer) { return run(c, options, observer); });
}

void resume_command(const CommandLine& line)
{
    if (RunDirectory::in_use(line.directory))
        throw InputError(
            line.directory +
            ": the run is still going on; how far it is, tells "
            "starling info " +
            shell_word(line.directory) +
            "; Ctrl-C in its terminal, or SIGTERM, stops it so that it can be resumed");
    if (line.threads > 0) omp_set_num_threads(line.threads);
    const CheckpointFile checkpoint = line.checkpoint.empty() ? latest_checkpoint(line.directory)
                                                              : CheckpointFile(line.checkpoint);
    const Case c = resumed_case(line.directory, checkpoint, line.overrides,
                                line.accept_changes ? Changes::any : Changes::stop_and_output);
    observe(line, c,
            [&](RunObserver& observer) { return resume(c, checkpoint, line.directory, observer); });
}

void check_command(const CommandLine& line)
{
    const Case c = read_case(line.case_file, line.overrides);
    fmt::print("{}", check_text(c, estimate_run(c)));
}

bool gives_steady_pressures(const DriveParameters& drive)
{
    return drive.gives_pressures() && !drive.has_waveform();
}

/// The table that `--csv` asks for.
std::string theory_table(const std::string& name, const TubeProblem& problem, const Case& c)
{
    const Scaling& scaling = c.scaling;
    if (name == "profile") return to_csv(theory_report(problem), scaling);
    if (name == "waves") return waves_csv(problem, c.grid, scaling);
    const auto buckling = buckling_report(problem);
    if (!buckling)
        throw InputError("--csv=" + name +
                         (problem.material.support.stiffness > 0
                              ? ": the loads of a wall with support_stiffness "
                                "are not known"
                              : ": this wall does not resist bending"));
    return name == "buckling" ? to_csv(*buckling, scaling) : tube_law_csv(*buckling, scaling);
}

/// Where the steady model is not all that theory has to say.
std::string model_or_its_failure(const TubeProblem& problem, const Scaling& scaling)
{
    try {
        return to_text(theory_report(problem), scaling);
    } catch (const NumericalError& e) {
        return std::string(e.what()) + '\n';
    }
}

void theory_command(const CommandLine& line)
{
    const Case c = read_case(line.case_file, line.overrides);
    const TubeProblem problem{c.tube, c.material, c.fluid, c.drive};
    if (!line.csv.empty()) {
        if (!gives_steady_pressures(c.drive) && line.csv == "profile")
            throw InputError("--csv: the models are of steady pressures at both ends, which this "
                             "case does not give");
        fmt::print("{}", theory_table(line.csv, problem, c));
        return;
    }
    if (!gives_steady_pressures(c.drive)) {
        fmt::print("The models of inflation are of steady pressures at both ends, which this case "
                   "does not give.\n{}",
                   waves_text(problem, c.grid, c.scaling));
        return;
    }
    const auto buckling = buckling_report(problem);
    fmt::print("{}", buckling || !has_theory(c) ? model_or_its_failure(problem, c.scaling)
                                                : to_text(theory_report(problem), c.scaling));
    if (!has_theory(c))
        fmt::print("This case may be outside the model: it holds for steady inflation by a flow "
                   "slower than the waves of the wall.\n");
    fmt::print("{}", waves_text(problem, c.grid, c.scaling));
    if (buckling) fmt::print("{}", to_text(*buckling, c.scaling));
    if (c.material.bending > 0 && c.material.support.stiffness > 0)
        fmt::print("Buckling loads are left out: theory has none for a wall with "
                   "support_stiffness.\n");
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

void report_command(const CommandLine& line)
{
    const auto [path, notes] = report::write_report(line.directory);
    fmt::print("{}: open it in a browser\n", path.string());
    for (const std::string& note : notes) fmt::print("  {}\n", note);
}

void info_command(const CommandLine& line)
{
    const Info info = describe_path(line.directory);
    fmt::print("{}", info.text);
    if (!info.whole) throw InputError(line.directory + ": not everything is whole");
}

void export_command(const CommandLine& line)
{
    fmt::print("{}",
               export_frame({line.directory, line.export_file, line.what, line.time, line.force}));
}

} // namespace

void execute(const CommandLine& line)
{
    if (line.command == "run")
        run_command(line);
    else if (line.command == "resume")
        resume_command(line);
    else if (line.command == "check")
        check_command(line);
    else if (line.command == "theory")
        theory_command(line);
    else if (line.command == "cases")
        cases_command(line);
    else if (line.command == "info")
        info_command(line);
    else if (line.command == "export")
        export_command(line);
    else if (line.command == "plot")
        plot_command(line);
    else if (line.command == "report")
        report_command(line);
    else if (line.command == "bench")
        bench_command(line);
}

} // namespace starling::app
