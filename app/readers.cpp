#include "readers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "output/export.hpp"
#include "output/field_file.hpp"
#include "output/shell_word.hpp"
#include "simulation/inspect.hpp"

namespace starling::app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_times = 8; ///< listed in full

std::string line(const std::string& label, const std::string& value)
{
    return fmt::format("  {:<14}{}\n", label, value);
}

std::string plural(std::size_t count, const std::string& noun)
{
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// "3 frames, t = 0, 0.5, 1 R_0/U_c".
std::string frames_text(const std::vector<ListedFrame>& frames)
{
    if (frames.empty()) return "no frames";
    std::vector<const FrameHead*> whole;
    for (const ListedFrame& frame : frames)
        if (frame.problem.empty()) whole.push_back(&frame.head);
    std::string text = plural(frames.size(), "frame");
    if (whole.empty()) return text;
    text += ", t = ";
    for (std::size_t n = 0; n < whole.size(); ++n) {
        const bool middle = whole.size() > most_times && n >= 3 && n + 2 < whole.size();
        if (!middle)
            fmt::format_to(std::back_inserter(text), "{}{:.6g}", n > 0 ? ", " : "", whole[n]->t);
        if (middle && n == 3) text += ", ...";
    }
    return text + " " + whole.front()->unit_of_t;
}

std::string state_text(const RunContents& run)
{
    if (run.running) return "a run is writing to it now";
    if (!run.ended.empty()) return "ended (" + run.ended.substr(0, run.ended.find('\n')) + ")";
    return "has not ended: killed, or out of disk";
}

std::string checkpoints_text(const std::vector<CheckpointContents>& all)
{
    std::string text = all.empty() ? "none" : fmt::format("{}", all.size());
    for (const CheckpointContents& c : all)
        if (c.problem.empty())
            return text + fmt::format(", the latest whole one of step {}, t = {:.6g} {}", c.step,
                                      c.t, c.unit_of_t);
    return text;
}

/// The command that goes on with the run, from the latest checkpoint that allows it.
std::string advice(const RunContents& run, const fs::path& directory)
{
    if (run.running || run.checkpoints.empty()) return "";
    const fs::path case_file = directory / "case.toml";
    const std::string resume =
        (run.case_is_damaged ? "mv " + shell_word(case_file) + " " +
                                   shell_word(case_file.string() + ".damaged") + "; "
                             : "") +
        "starling resume " + shell_word(directory);
    std::string obstacle;
    for (const CheckpointContents& c : run.checkpoints) {
        const bool latest = &c == &run.checkpoints.front();
        if (obstacle.empty()) obstacle = c.obstacle;
        if (!c.problem.empty() || !c.obstacle.empty()) continue;
        if (latest && !run.later_end.empty())
            return "Go further: " + resume + " --set " + run.later_end + "\n";
        return "Go on: " + resume + (latest ? "" : " --from " + shell_word(c.path)) + "\n";
    }
    return obstacle.empty() ? "" : "To resume is not possible: " + obstacle + "\n";
}

std::string findings_text(const RunContents& run, const fs::path& directory)
{
    if (run.findings.empty()) return "All files are whole.\n";
    std::string text = plural(run.findings.size(), "damaged or missing file") + ":\n";
    for (const Finding& f : run.findings)
        text += "  " + f.path.lexically_relative(directory).string() + ": " + f.problem + "\n";
    return text;
}

Info describe_run(const fs::path& directory)
{
    const RunContents run = inspect_run(directory);
    std::string text = directory.string() + (run.title.empty() ? "" : ": " + run.title) + "\n";
    text += line("run", state_text(run));
    if (run.series)
        text += line("series.csv",
                     fmt::format("{}, steps {} to {}, t = {:.6g} to {:.6g} {}",
                                 plural(static_cast<std::size_t>(run.series->rows), "row"),
                                 run.series->first_step, run.series->last_step, run.series->first_t,
                                 run.series->last_t, run.series->unit_of_t));
    text += line("wall", frames_text(run.wall)) + line("fluid", frames_text(run.fluid));
    text += line("checkpoints", checkpoints_text(run.checkpoints));
    for (const fs::path& path : run.leftovers)
        text += line("left over", path.lexically_relative(directory).string() +
                                      ": unfinished when the run was killed; to resume removes it");
    return {text + findings_text(run, directory) + advice(run, directory), run.findings.empty()};
}

Info describe_checkpoint(const fs::path& path)
{
    const CheckpointContents c = inspect_checkpoint(path);
    if (!c.problem.empty())
        return {path.string() + ": a checkpoint that " + c.problem + "\n", false};
    std::string text = path.string() + ": a checkpoint\n";
    text += line("case", c.title) + line("written by", "starling " + c.version);
    text += line("state", fmt::format("step {}, t = {:.6g} {}", c.step, c.t, c.unit_of_t));
    text += line("size", fmt::format("{:.3g} MB", static_cast<double>(fs::file_size(path)) / 1e6));
    return {text + "The file is whole.\n"};
}

/// "1680 x 3, -0.2 to 0.7 R_0".
std::string array_text(const FrameArray& a)
{
    std::string text;
    for (std::size_t n : a.shape) text += (text.empty() ? "" : " x ") + std::to_string(n);
    if (a.components == 3) text += " vectors";
    Real low = std::numeric_limits<Real>::infinity(), high = -low;
    std::size_t strange = 0;
    for (Real v : a.values) {
        low = std::min(low, v), high = std::max(high, v);
        strange += !std::isfinite(v);
    }
    if (low <= high) text += fmt::format(", {:.6g} to {:.6g} {}", low, high, a.unit);
    if (strange > 0) text += fmt::format(", {} not finite", strange);
    return text;
}

Info describe_frame(const fs::path& path)
{
    try {
        const FrameFile frame(path);
        const FrameHead& head = frame.head();
        std::string text = path.string() + ": a frame of the " + head.of + "\n";
        text +=
            line("state", fmt::format("step {}, t = {:.6g} {}", head.step, head.t, head.unit_of_t));
        for (const std::string& name : frame.arrays())
            text += fmt::format("  {:<22}{}\n", name, array_text(frame.read(name)));
        return {text + "The file is whole.\n"};
    } catch (const InputError& e) {
        return {std::string(e.what()) + "\n", false};
    }
}

/// wall.h5 or fluid.h5, which shows the frames beside it.
Info describe_index(const fs::path& path)
{
    try {
        check_seal(path, index_seal);
    } catch (const InputError& e) {
        return {std::string(e.what()) + "\n", false};
    }
    const auto frames = list_frames(path.parent_path(), path.stem());
    std::string text =
        path.string() + ": shows the frames beside it\n" + line("frames", frames_text(frames));
    std::size_t damaged = 0;
    for (const ListedFrame& frame : frames) {
        damaged += !frame.problem.empty();
        if (!frame.problem.empty())
            text += "  " + frame.path.string() + ": " + frame.problem + "\n";
    }
    return {text + (damaged == 0 ? "All files are whole.\n" : ""), damaged == 0};
}

Real time_in(const std::string& text)
{
    Real t = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, t);
    if (error != std::errc() || stop != end || !std::isfinite(t))
        throw InputError("--time " + text + ": must be a number, in the units of the results");
    return t;
}

/// What is to be exported, from the name of the file that is asked for.
std::string what_to_export(const ExportRequest& request)
{
    const std::string end = request.to.extension();
    if (end != ".vtp" && end != ".vti" && end != ".csv")
        throw InputError("--out " + request.to.string() +
                         ": must end in .vtp (the wall), .vti (the fluid) or .csv");
    std::error_code none;
    const bool one_frame = fs::is_regular_file(request.from, none);
    const std::string fits = end == ".vti" ? "fluid" : "wall";
    if (request.what.empty())
        return end == ".csv" && one_frame ? FrameFile(request.from).head().of : fits;
    if (end != ".csv" && request.what != fits)
        throw InputError("--what " + request.what + ": " + end + " files hold the " + fits);
    return request.what;
}

/// The frame nearest to the time asked for, or the last.
ListedFrame choose_frame(const ExportRequest& request, const std::string& what)
{
    if (!fs::is_directory(request.from)) return {request.from, FrameFile(request.from).head(), ""};
    const auto frames = list_frames(request.from, what);
    if (frames.empty())
        throw InputError(request.from.string() + ": holds no frames of the " + what);
    const Real t =
        request.time.empty() ? std::numeric_limits<Real>::infinity() : time_in(request.time);
    ListedFrame best; // times increase: the last of those up to t, or the one after it
    for (const ListedFrame& frame : frames) {
        if (!frame.problem.empty()) continue;
        const bool nearer = best.path.empty() || frame.head.t <= t ||
                            (best.head.t < t && frame.head.t - t < t - best.head.t);
        if (nearer) best = frame;
    }
    if (best.path.empty())
        throw InputError(frames.back().path.string() + ": " + frames.back().problem +
                         "; no other frame is whole");
    return best;
}

std::string told(const ExportRequest& request, const ListedFrame& frame, const std::string& what)
{
    const FrameHead& head = frame.head;
    std::string text = fmt::format("{}: the {} at t = {} {}, step {}", request.to.string(), what,
                                   head.t, head.unit_of_t, head.step);
    if (!request.time.empty())
        text += time_in(request.time) == head.t
                    ? ", exactly the time asked for"
                    : fmt::format(", the frame nearest to the {} asked for", request.time);
    if (fs::is_directory(request.from))
        for (const ListedFrame& other : list_frames(request.from, what))
            if (!other.problem.empty())
                text += fmt::format("\n  passed over: {}: {}", other.path.string(), other.problem);
    return text + "\n";
}

std::string units_told(const std::vector<const FrameArray*>& arrays, const std::string& length)
{
    std::string text = "  x, y, z [" + length + "]";
    for (const FrameArray* a : arrays) text += ", " + a->name + " [" + a->unit + "]";
    return text + "\n";
}

std::vector<const FrameArray*> pointers(const std::vector<FrameArray>& arrays)
{
    std::vector<const FrameArray*> all;
    for (const FrameArray& a : arrays) all.push_back(&a);
    return all;
}

} // namespace

Info describe_path(const fs::path& path)
{
    std::error_code none;
    if (fs::is_directory(path, none)) return describe_run(path);
    if (!fs::exists(path, none)) throw InputError(path.string() + ": no such file or directory");
    const std::string kind = sealed_kind(path), folder = path.parent_path().filename();
    if (kind == "checkpoint" || folder == "checkpoints") return describe_checkpoint(path);
    if (kind == "frame" || folder == "frames") return describe_frame(path);
    if (kind == "index") return describe_index(path);
    throw InputError(path.string() + ": is none of the HDF5 files of Starling; the directory of a "
                                     "run is told about by: starling info DIR");
}

std::string export_frame(const ExportRequest& request)
{
    const std::string what = what_to_export(request);
    std::error_code none;
    if (!fs::exists(request.from, none))
        throw InputError(request.from.string() + ": no such file or directory");
    if (fs::exists(request.to, none) && !request.force)
        throw InputError(request.to.string() + ": exists; --force replaces it");
    const ListedFrame frame = choose_frame(request, what);
    const bool csv = request.to.extension() == ".csv";
    const FrameFile file(frame.path);
    if (what == "wall") {
        const WallFrame wall = file.read_wall();
        csv ? write_csv(request.to, wall) : write_vtp(request.to, wall);
        auto arrays = pointers(wall.at_vertex);
        for (const FrameArray& a : wall.at_element) arrays.push_back(&a);
        return told(request, frame, what) + units_told(arrays, wall.points.unit);
    }
    const FluidFrame fluid = file.read_fluid();
    csv ? write_csv(request.to, fluid) : write_vti(request.to, fluid);
    return told(request, frame, what) + units_told(pointers(fluid.at_cell), fluid.unit_of_length);
}

} // namespace starling::app
