#include "simulation/inspect.hpp"

#include <algorithm>

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

/// Looks into a run directory, file by file.
class Inspector {
public:
    explicit Inspector(const fs::path& directory) : directory_(directory) {}

    RunContents look()
    {
        found_.running = RunDirectory::in_use(directory_);
        look_at("case.toml", [&](const fs::path& p) {
            found_.case_is_damaged = true;
            case_ = read_case(p);
            found_.title = case_->title;
            found_.case_is_damaged = false;
        });
        look_at("series.csv", [&](const fs::path& p) { found_.series = inspect_series(p); });
        look_at("summary.json", [&](const fs::path& p) {
            const auto summary = nlohmann::json::parse(read_text(p));
            found_.ended = summary.at("reason").get<std::string>();
            steps_ = summary.at("steps");
            has_theory_ = !summary.at("theory").is_null();
        });
        for (const char* name : {"profile.csv", "sections.csv", "theory.csv"})
            look_at(name, [&](const fs::path& p) { check_along_x(p); });
        found_.wall = look_at_frames("wall");
        found_.fluid = look_at_frames("fluid");
        for (const fs::path& path : CheckpointRing::list(directory_)) look_at_checkpoint(path);
        if (case_) found_.later_end = later_end(*case_, found_.ended, steps_);
        if (found_.running) return found_;
        list_leftovers();
        look_for_missing();
        look_for_unlisted_frames();
        return found_;
    }

private:
    static bool can_go_on(const CheckpointContents& c)
    {
        return c.problem.empty() && c.obstacle.empty();
    }

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

    /// A table along the whole vessel.
    void check_along_x(const fs::path& path) const
    {
        const TableContents table = read_table(path);
        if (table.cut) throw std::runtime_error(fmt::format("row {} is cut off", table.rows() + 1));
        const TableColumn* x = table.find("x");
        if (x == nullptr || x->values.empty()) throw std::runtime_error("holds no rows");
        if (!case_) return;
        const Real length = case_->tube.length * case_->scaling.factor(Quantity::length);
        if (x->values.back() < (1 - 1e-6) * length)
            throw std::runtime_error("ends before the end of the vessel");
    }

    void look_for(const std::string& name, const std::string& remedy = "")
    {
        if (!fs::exists(directory_ / name)) note(directory_ / name, "is missing" + remedy);
    }

    /// Files that were there if others are; an order in which no kill leaves them.
    void look_for_missing()
    {
        const bool ended = fs::exists(directory_ / "summary.json");
        const bool begun =
            ended || !found_.checkpoints.empty() || !found_.wall.empty() || !found_.fluid.empty();
        if (begun) look_for("series.csv"), look_for("case.toml");
        if (ended) look_for("profile.csv"), look_for("sections.csv");
        if (has_theory_) look_for("theory.csv");
        const auto frames = [&](const std::string& of, auto member, bool wanted) {
            const bool listed = std::ranges::any_of(
                found_.checkpoints, [&](const CheckpointContents& c) { return c.*member > 0; });
            if (listed || (ended && wanted))
                for (const char* end : {".h5", ".xdmf"})
                    look_for(of + end, "; to resume makes it anew");
        };
        frames("wall", &CheckpointContents::wall_frames, case_ && case_->output.wall);
        frames("fluid", &CheckpointContents::fluid_frames, case_ && case_->output.fluid);
    }

    /// Why `resume` would refuse to go on from the checkpoint; empty where it would not.
    std::string obstacle_of(const CheckpointFile& file) const
    {
        const RunMemory memory = file.read_memory();
        const Scaling scaling = read_case_text(file.case_text(), "its case").scaling;
        try {
            SeriesWriter::check_row(directory_ / "series.csv", scaling, memory.last_row);
            for (const auto& [of, frames] :
                 {std::pair{"wall", memory.wall_frames}, {"fluid", memory.fluid_frames}})
                FrameWriter::lists_frames({directory_, scaling, hdf5::Precision::full, frames}, of);
        } catch (const InputError& e) {
            return e.what();
        }
        return "";
    }

    void look_at_checkpoint(const fs::path& path)
    {
        found_.checkpoints.push_back(inspect_checkpoint(path));
        note(path, found_.checkpoints.back().problem);
        if (!found_.checkpoints.back().problem.empty()) return;
        try {
            const CheckpointFile file(path);
            if (!case_) case_ = read_case_text(file.case_text(), "its case");
            if (!found_.running) found_.checkpoints.back().obstacle = obstacle_of(file);
            file.sound();
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
        const auto whole =
            std::ranges::find_if(found_.checkpoints, [](const auto& c) { return can_go_on(c); });
        if (whole == found_.checkpoints.end()) return;
        for (const auto& [of, frames] :
             {std::pair{"wall", whole->wall_frames}, {"fluid", whole->fluid_frames}}) {
            const fs::path path = directory_ / (std::string(of) + ".xdmf");
            if (fs::exists(path) && !xdmf::Series(path, of).holds(frames))
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
    std::optional<Case> case_; ///< of case.toml, else of a checkpoint
    Index steps_ = 0;          ///< in summary.json
    bool has_theory_ = false;  ///< summary.json has
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
