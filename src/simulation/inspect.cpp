#include "simulation/inspect.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "config/read_case.hpp"
#include "core/error.hpp"
#include "output/checkpoint.hpp"
#include "output/field_file.hpp"
#include "output/read_table.hpp"
#include "output/run_directory.hpp"
#include "output/series.hpp"
#include "simulation/run.hpp"

namespace starling {

namespace fs = std::filesystem;

namespace {

/// The message of an error about a file, without the file's name in front.
std::string reason_in(const std::exception& e, const fs::path& path)
{
    const std::string text = e.what(), name = path.string();
    if (!text.starts_with(name)) return text;
    const std::size_t begin = text.find_first_not_of(": ", name.size());
    return begin == std::string::npos ? text : text.substr(begin);
}

/// Reads series.csv row by row; throws std::runtime_error at the first that is wrong.
SeriesContents inspect_series(const fs::path& path)
{
    const auto columns = sample_columns();
    std::istringstream text(read_text(path));
    std::string line;
    SeriesContents found;
    if (!std::getline(text, line)) throw std::runtime_error("is empty");
    const auto titles = cells_of(line);
    bool known = titles.size() == columns.size();
    for (std::size_t n = 0; known && n < titles.size(); ++n)
        known = titles[n].starts_with(std::string(columns[n].name) + " [");
    if (!known) throw std::runtime_error("has other columns than this Starling writes");
    found.unit_of_t = titles[0].substr(3, titles[0].size() - 4);
    while (std::getline(text, line)) {
        const std::string row = fmt::format("row {}", found.rows + 1);
        const auto cells = cells_of(line);
        if (text.eof() || cells.size() != columns.size())
            throw std::runtime_error(row + " is cut off");
        for (const std::string& cell : cells)
            if (!number_in(cell)) throw std::runtime_error(row + " holds '" + cell + "'");
        const Real t = *number_in(cells[0]);
        const auto step = static_cast<Index>(*number_in(cells[1]));
        if (found.rows > 0 && (step <= found.last_step || !(t > found.last_t)))
            throw std::runtime_error(row + " goes back in time");
        if (found.rows++ == 0) found.first_step = step, found.first_t = t;
        found.last_step = step;
        found.last_t = t;
    }
    return found;
}

/// Looks into a run directory, file by file.
class Inspector {
public:
    explicit Inspector(const fs::path& directory) : directory_(directory) {}

    RunContents look()
    {
        found_.running = RunDirectory::in_use(directory_);
        look_at("case.toml", [&](const fs::path& p) {
            case_ = read_case(p);
            found_.title = case_->title;
        });
        look_at("series.csv", [&](const fs::path& p) { found_.series = inspect_series(p); });
        look_at("summary.json", [&](const fs::path& p) {
            const auto summary = nlohmann::json::parse(read_text(p));
            found_.ended = summary.at("reason").get<std::string>();
            if (case_) found_.later_end = later_end(*case_, found_.ended, summary.at("steps"));
        });
        found_.wall = look_at_frames("wall");
        found_.fluid = look_at_frames("fluid");
        for (const fs::path& path : CheckpointRing::list(directory_)) look_at_checkpoint(path);
        if (found_.running) return found_;
        list_leftovers();
        look_for_unlisted_frames();
        return found_;
    }

private:
    void note(const fs::path& path, const std::string& problem)
    {
        if (!problem.empty()) found_.findings.push_back({path, problem});
    }

    template <class F>
    void look_at(const char* name, F f)
    {
        const fs::path path = directory_ / name;
        std::error_code none;
        if (!fs::exists(path, none)) return;
        try {
            f(path);
        } catch (const std::exception& e) {
            note(path, reason_in(e, path));
        }
    }

    void look_at_checkpoint(const fs::path& path)
    {
        found_.checkpoints.push_back(inspect_checkpoint(path));
        note(path, found_.checkpoints.back().problem);
        if (!found_.checkpoints.back().problem.empty()) return;
        try {
            CheckpointFile(path).sound();
        } catch (const InputError& e) {
            const std::string text = e.what();
            const std::size_t end = text.find(": ");
            note(text.substr(0, end), text.substr(end + 2));
        }
    }

    std::vector<ListedFrame> look_at_frames(const std::string& of)
    {
        const auto frames = list_frames(directory_, of);
        for (const ListedFrame& frame : frames) note(frame.path, frame.problem);
        const std::string index = of + ".h5", xdmf = of + ".xdmf";
        look_at(index.c_str(), [](const fs::path& p) { check_seal(p, index_seal); });
        look_at(xdmf.c_str(), [&](const fs::path& p) {
            const std::string text = read_text(p);
            if (!text.ends_with("</Xdmf>\n")) throw std::runtime_error("is cut off");
            for (std::size_t at = 0; (at = text.find("frames/", at)) != std::string::npos; ++at) {
                const std::string name = text.substr(at, text.find(':', at) - at);
                if (!fs::exists(directory_ / name))
                    throw std::runtime_error("names " + name + ", which is missing");
            }
        });
        return frames;
    }

    /// Frames that belong to the checkpoint to go on from.
    void look_for_unlisted_frames()
    {
        const auto whole = std::ranges::find_if(found_.checkpoints,
                                                [](const auto& c) { return c.problem.empty(); });
        if (whole == found_.checkpoints.end()) return;
        for (const auto& [of, frames] :
             {std::pair{"wall", whole->wall_frames}, {"fluid", whole->fluid_frames}}) {
            const fs::path path = directory_ / (std::string(of) + ".xdmf");
            if (!xdmf::Series(path, of).holds(frames))
                note(path,
                     "does not list all frames up to the checkpoint; to resume makes it anew");
        }
    }

    void list_leftovers()
    {
        for (const fs::path& folder :
             {directory_, directory_ / "frames", CheckpointRing::folder(directory_)}) {
            std::error_code none;
            for (const auto& entry : fs::directory_iterator(folder, none))
                if (entry.path().extension() == ".new") found_.leftovers.push_back(entry.path());
        }
        for (const fs::path& path : CheckpointRing::orphans(directory_))
            found_.leftovers.push_back(path);
        std::ranges::sort(found_.leftovers);
    }

    fs::path directory_;
    std::optional<Case> case_; ///< where case.toml can be read
    RunContents found_;
};

} // namespace

CheckpointContents inspect_checkpoint(const fs::path& path)
{
    CheckpointContents found;
    found.path = path;
    try {
        const CheckpointFile file(path);
        const Case c = read_case_text(file.case_text(), "its case");
        found.step = file.step();
        found.t = file.t() * c.scaling.factor(Quantity::time);
        found.unit_of_t = c.scaling.unit(Quantity::time);
        found.version = file.version();
        const RunMemory memory = file.read_memory();
        found.wall_frames = memory.wall_frames;
        found.fluid_frames = memory.fluid_frames;
        found.title = c.title;
    } catch (const std::exception& e) {
        found.problem = reason_in(e, path);
    }
    return found;
}

RunContents inspect_run(const fs::path& directory)
{
    std::error_code none;
    if (!fs::is_directory(directory, none))
        throw InputError(directory.string() + ": no such directory");
    RunContents found = Inspector(directory).look();
    if (!found.series && found.wall.empty() && found.fluid.empty() && found.checkpoints.empty() &&
        found.findings.empty() && !fs::exists(directory / "case.toml", none))
        throw InputError(directory.string() + ": holds no results of a run");
    return found;
}

} // namespace starling
