#include "command_line.hpp"

#include <CLI/CLI.hpp>

#include "config/nearest_name.hpp"
#include "core/error.hpp"
#include "output/version.hpp"

namespace starling::app {

namespace {

constexpr int most_threads = 1024, most_repeats = 1000;

void add_overrides(CLI::App& command, CommandLine& line)
{
    command
        .add_option("--set", line.overrides,
                    "Use VALUE instead of what the case file says; may be repeated")
        ->option_text("SECTION.KEY=VALUE")
        ->allow_extra_args(false);
}

void add_case(CLI::App& command, CommandLine& line)
{
    command.add_option("case", line.case_file, "Case file (docs/case_file.md)")
        ->option_text("CASE.toml")
        ->required();
    add_overrides(command, line);
}

void add_threads(CLI::App& command, CommandLine& line)
{
    command.add_option("--threads", line.threads, "Number of threads [all]")
        ->option_text("N")
        ->check(CLI::Range(1, most_threads));
    command.add_flag("--quiet", line.quiet, "Print errors and warnings only");
}

void add_run(CLI::App& app, CommandLine& line)
{
    CLI::App* run = app.add_subcommand("run", "Run a case and write results to a directory");
    add_case(*run, line);
    run->add_option("--out", line.directory, "Directory for the results (docs/results.md)")
        ->option_text("DIR")
        ->required();
    add_threads(*run, line);
    run->add_flag("--force", line.force, "Replace the results of an earlier run in DIR");
    run->footer("Ctrl-C finishes the step, writes everything and ends with exit code 0.");
}

void add_resume(CLI::App& app, CommandLine& line)
{
    CLI::App* resume = app.add_subcommand(
        "resume", "Go on with a run from its latest checkpoint as if it had never stopped");
    resume->add_option("directory", line.directory, "Directory that a run has written")
        ->option_text("DIR")
        ->required();
    resume->add_option("--from", line.checkpoint, "Go on from this checkpoint [the latest]")
        ->option_text("FILE");
    add_overrides(*resume, line);
    resume->add_flag("--accept-changes", line.accept_changes,
                     "Go on even where --set or case.toml changes the physics");
    add_threads(*resume, line);
    resume->footer("Stop criteria and output may be changed: --set stop.end_time=20.");
}

/// What reads results.
void add_readers(CLI::App& app, CommandLine& line)
{
    CLI::App* info = app.add_subcommand(
        "info", "Print what a run directory or one of its files holds, and whether it is whole");
    info->add_option("path", line.directory, "Directory of a run, a checkpoint or a frame")
        ->option_text("DIR|FILE")
        ->required();
    info->footer("Exit code 2 where a file is damaged.");
    CLI::App* exports = app.add_subcommand(
        "export", "Write the wall or the fluid at one time as .vtp, .vti or .csv");
    exports->add_option("path", line.directory, "Directory of a run, or a frame")
        ->option_text("DIR|FILE")
        ->required();
    exports
        ->add_option("--out", line.export_file,
                     "File to write: the wall to .vtp, the fluid to .vti, either to .csv")
        ->option_text("FILE")
        ->required();
    exports
        ->add_option("--time", line.time,
                     "Time in the units of the results; the frame nearest to it is taken [last]")
        ->option_text("T");
    exports->add_option("--what", line.what, "wall or fluid [by FILE; wall for .csv]")
        ->check(CLI::IsMember({"wall", "fluid"}));
    exports->add_flag("--force", line.force, "Replace FILE");
}

/// What shows results.
void add_pictures(CLI::App& app, CommandLine& line)
{
    CLI::App* report = app.add_subcommand(
        "report", "Write the results of a run to one page for the browser, DIR/report.html");
    CLI::App* plot = app.add_subcommand("plot", "Draw the results of a run as PNG pictures");
    for (CLI::App* command : {report, plot})
        command->add_option("directory", line.directory, "Directory that a run has written")
            ->option_text("DIR")
            ->required();
    report->footer("The page is complete in itself: it opens offline and can be sent to others.");
}

void add_bench(CLI::App& app, CommandLine& line)
{
    CLI::App* bench = app.add_subcommand(
        "bench", "Time whole steps and hold them against the machine's bandwidth of memory");
    bench
        ->add_option("--grid", line.grids,
                     "Cells along x, y, z; may be repeated [256x96x96 and 512x240x240]")
        ->option_text("NXxNYxNZ")
        ->allow_extra_args(false);
    bench
        ->add_option("--wall", line.walls,
                     "Vertices of the wall, or none; may be repeated [none and 17k, or 250k]")
        ->option_text("none|17k|250k|N")
        ->allow_extra_args(false);
    bench->add_option("--threads", line.thread_counts, "Number of threads; may be repeated [1, 2]")
        ->option_text("N")
        ->allow_extra_args(false)
        ->check(CLI::Range(1, most_threads));
    bench->add_option("--repeats", line.repeats, "Repeats of each measurement [5]")
        ->option_text("N")
        ->check(CLI::Range(1, most_repeats));
    bench->add_option("--json", line.json_file, "Write all numbers to FILE (docs/performance.md)")
        ->option_text("FILE");
    bench->add_flag("--quick", line.quick,
                    "A small grid and little work, to see that it runs; the numbers say nothing");
    bench->add_flag("--quiet", line.quiet, "Print the table only");
    bench->footer("tools/compare_bench compares two such files.");
}

void add_others(CLI::App& app, CommandLine& line)
{
    CLI::App* check = app.add_subcommand(
        "check", "Validate a case and print its numbers, limits and cost; runs nothing");
    add_case(*check, line);
    CLI::App* theory = app.add_subcommand(
        "theory", "Print what theory predicts for a case: R(x), P(x), Q, waves, buckling");
    add_case(*theory, line);
    theory
        ->add_flag(
            "--csv{profile}", line.csv,
            "Print a table instead: the profile (--csv), waves of given frequency (--csv=waves), "
            "buckling loads (--csv=buckling) or the tube law of the buckled ring "
            "(--csv=tube-law)")
        ->check(CLI::IsMember({"profile", "waves", "buckling", "tube-law"}));
    CLI::App* cases = app.add_subcommand("cases", "List the shipped cases, or print one");
    cases->add_option("name", line.name, "Case to print")->option_text("NAME");
    add_readers(app, line);
    add_pictures(app, line);
    add_bench(app, line);
}

std::vector<std::string> subcommand_names(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::App* s : app.get_subcommands({})) names.push_back(s->get_name());
    return names;
}

std::vector<std::string> option_names(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::Option* o : app.get_options())
        if (!o->get_positional()) names.push_back("--" + o->get_lnames().front());
    return names;
}

std::string with_suggestion(const std::string& what, const std::string& wrong,
                            const std::vector<std::string>& names)
{
    return what + " " + in_quotes(wrong) + ": " + suggestion(wrong, {names.begin(), names.end()});
}

/// What is wrong, in words that help; arguments nobody expected come first, because a misspelt
/// option also makes a required one look missing.
std::string describe(const CLI::App& app, const CLI::ParseError& error)
{
    const auto chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    const std::string help =
        "\n  see starling " + (chosen.empty() ? "" : command.get_name() + " ") + "--help";
    const auto unexpected = app.remaining(true);
    if (unexpected.empty()) return error.what() + help;
    const std::string& first = unexpected.front();
    if (first.starts_with("-"))
        return with_suggestion("unknown option", first, option_names(command)) + help;
    if (chosen.empty())
        return with_suggestion("unknown command", first, subcommand_names(app)) + help;
    return "unexpected argument " + in_quotes(first) + help;
}

} // namespace

CommandLine parse(int argc, char** argv)
{
    CommandLine line;
    CLI::App app("Flow through thin-walled compliant tubes (immersed boundary)", "starling");
    app.set_version_flag("--version", "starling " + version());
    app.require_subcommand(1);
    add_run(app, line);
    add_resume(app, line);
    add_others(app, line);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& answered) { // --help, --version
        app.exit(answered);
        throw Done{};
    } catch (const CLI::ParseError& error) {
        throw InputError(describe(app, error));
    }
    line.command = app.get_subcommands().front()->get_name();
    return line;
}

} // namespace starling::app
