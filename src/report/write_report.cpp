#include "report/write_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "config/read_case.hpp"
#include "core/error.hpp"
#include "output/replace_file.hpp"
#include "output/version.hpp"
#include "report/page_data.hpp"
#include "report/page_template.hpp"
#include "simulation/inspect.hpp"

namespace starling::report {

namespace fs = std::filesystem;

namespace {

/// Collects the parts of the page. A part whose files are damaged is left out, with a note.
class Page {
public:
    explicit Page(const fs::path& directory) : directory_(directory), run_(inspect_run(directory))
    {
        for (const Finding& f : run_.findings)
            if (f.path.filename() != case_file) notes_.push_back(words_of(f)); // add_case says more
    }

    Json data()
    {
        Json page = {{"title", run_.title},
                     {"directory", fs::absolute(directory_ / "").parent_path().filename().string()},
                     {"generator", "Starling " + version()}};
        add_state(page);
        add_tables(page);
        add_case(page);
        page["wall"] = part("the wall", [&] { return wall_data(whole(run_.wall), notes_); });
        page["flow"] = part("the flow",
                            [&] { return flow_data(whole(run_.fluid), whole(run_.wall), notes_); });
        page["notes"] = notes_;
        return page;
    }
    const Notes& notes() const { return notes_; }

private:
    static constexpr const char* case_file = "case.toml";
    static constexpr const char* summary_file = "summary.json";

    /// Of tables the rows before the damage are shown; of indices and checkpoints nothing ever is.
    std::string words_of(const Finding& f) const
    {
        const std::string name = f.path.lexically_relative(directory_).string();
        if (name.ends_with(".csv"))
            return fmt::format("{}: {}; the rows before it are shown.", name, f.problem);
        const bool shown = name.starts_with("frames/") || name == summary_file;
        return fmt::format("{} {}{}.", name, shown ? "is left out: " : "", f.problem);
    }

    template <class F>
    Json part(const std::string& what, F make)
    {
        try {
            return make();
        } catch (const InputError& e) {
            notes_.push_back(fmt::format("{} is not shown: {}", what, e.what()));
            return nullptr;
        }
    }

    static std::vector<ListedFrame> whole(std::vector<ListedFrame> frames)
    {
        std::erase_if(frames, [](const ListedFrame& frame) { return !frame.problem.empty(); });
        return frames;
    }

    void add_state(Json& page)
    {
        if (!run_.ended.empty()) summary_ = Json::parse(read_text(directory_ / summary_file));
        page["summary"] = summary_;
        page["running"] = run_.running;
        for (const auto* frames : {&run_.wall, &run_.fluid})
            for (const ListedFrame& frame : *frames)
                if (frame.problem.empty()) page["unit_of_t"] = frame.head.unit_of_t;
    }

    void add_tables(Json& page)
    {
        for (const char* name : {"series", "profile", "theory"}) {
            const std::string file = std::string(name) + ".csv";
            if (!fs::exists(directory_ / file)) continue;
            page[name] = part(file, [&]() -> Json {
                const TableContents table = read_table(directory_ / file);
                if (file == "series.csv") series_ = table;
                return table.rows() > 0 ? table_data(file, table, notes_) : Json();
            });
        }
    }

    void add_case(Json& page)
    {
        const fs::path path = directory_ / case_file;
        page["case"] = part("the case", [&] {
            if (!fs::exists(path)) throw InputError("case.toml is missing");
            const Case c = read_case(path);
            page["results"] = result_data(summary_, series_, c);
            Json data = case_data(c);
            data["text"] = read_text(path);
            return data;
        });
    }

    fs::path directory_;
    RunContents run_;
    Notes notes_;
    Json summary_;
    TableContents series_;
};

/// JSON that may stand inside a script: no "<" ends or begins anything there.
std::string script_text(const Json& json)
{
    std::string text;
    for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace)) {
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    return text;
}

void check_there_is_something(const Json& data, const fs::path& directory)
{
    const auto shown = [&](const char* part) {
        return data.contains(part) && !data[part].is_null();
    };
    if (std::ranges::none_of(std::array{"series", "wall", "flow"}, shown))
        throw InputError(directory.string() +
                         ": holds no results to report on (no rows in series.csv, no frames)");
}

} // namespace

Written write_report(const fs::path& run_directory)
{
    const std::size_t place = page_template.find(data_mark);
    Page page(run_directory);
    const Json data = page.data();
    check_there_is_something(data, run_directory);
    if (place == std::string_view::npos)
        throw std::runtime_error(
            "this starling was built without the page of its reports: install Node.js 18 or newer "
            "with npm (Debian: tools/install_packages web) and build again, with access to the npm "
            "registry: cmake --preset release && cmake --build --preset release");
    std::string text(page_template.substr(0, place));
    text += script_text(data);
    text += page_template.substr(place + data_mark.size());
    const fs::path path = run_directory / file_name;
    replace_file(path, text);
    return {path, page.notes()};
}

} // namespace starling::report
