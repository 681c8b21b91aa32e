#include "simulation/resume.hpp"

#include <map>
#include <sstream>

#include "config/read_case.hpp"
#include "core/error.hpp"
#include "output/shell_word.hpp"

namespace starling {

namespace fs = std::filesystem;

namespace {

/// "section.key" -> value, of a case as write_case writes it.
std::map<std::string, std::string> values_of(const Case& c)
{
    std::map<std::string, std::string> values;
    std::istringstream text(write_case(c));
    std::string line, section;
    while (std::getline(text, line)) {
        const std::size_t equals = line.find(" = ");
        if (line.starts_with("["))
            section = line.substr(1, line.find(']') - 1) + ".";
        else if (!line.starts_with("#") && equals != std::string::npos)
            values[section + line.substr(0, equals)] = line.substr(equals + 3);
    }
    return values;
}

bool may_change(const std::string& key)
{
    return key == "title" || key.starts_with("stop.") || key.starts_with("output.") ||
           key.starts_with("checkpoint.");
}

/// The latest checkpoint but the first `skip` that is whole; empty where there is none.
fs::path latest_sound(const std::vector<fs::path>& all, std::size_t skip)
{
    for (std::size_t n = skip; n < all.size(); ++n) {
        try {
            return CheckpointFile(all[n]), all[n];
        } catch (const InputError&) {
        }
    }
    return {};
}

/// Of the directory's case.toml, which the user may have changed, else of the checkpoint.
Case case_to_go_on_with(const fs::path& file, const CheckpointFile& checkpoint,
                        const std::vector<std::string>& overrides)
{
    if (!fs::exists(file))
        return read_case_text(checkpoint.case_text(), "the checkpoint's case", overrides);
    try {
        read_case(file);
    } catch (const InputError& e) {
        throw InputError(
            std::string(e.what()) +
            "\n  the checkpoint holds the case as it was run: to go on with that, move " +
            file.string() + " away and resume again");
    }
    return read_case(file, overrides);
}

} // namespace

std::string differences(const Case& before, const Case& now)
{
    const auto old_values = values_of(before), new_values = values_of(now);
    const auto look_up = [](const auto& values, const std::string& key) {
        const auto found = values.find(key);
        return found == values.end() ? std::string("not given") : found->second;
    };
    auto keys = old_values;
    keys.insert(new_values.begin(), new_values.end());
    std::string text;
    for (const auto& entry : keys) {
        const std::string &key = entry.first, was = look_up(old_values, key),
                          is = look_up(new_values, key);
        if (was != is && !may_change(key)) text += "\n  " + key + ": was " + was + ", is " + is;
    }
    return text;
}

Case case_of(const CheckpointFile& checkpoint)
{
    return read_case_text(checkpoint.case_text(), "the checkpoint's case");
}

CheckpointFile latest_checkpoint(const fs::path& run_directory)
{
    const auto all = CheckpointRing::list(run_directory);
    if (all.empty())
        throw InputError(run_directory.string() + ": holds no checkpoint to go on from");
    try {
        return CheckpointFile(all.front());
    } catch (const InputError& e) {
        const fs::path sound = latest_sound(all, 1);
        throw InputError(std::string(e.what()) +
                         (sound.empty()
                              ? "\n  no other checkpoint is whole"
                              : "\n  the one before is whole: starling resume " +
                                    shell_word(run_directory) + " --from " + shell_word(sound)));
    }
}

Case resumed_case(const fs::path& run_directory, const CheckpointFile& checkpoint,
                  const std::vector<std::string>& overrides, Changes allowed)
{
    const Case before = case_of(checkpoint);
    const Case now = case_to_go_on_with(run_directory / "case.toml", checkpoint, overrides);
    const std::string changed = differences(before, now);
    if (!changed.empty() && allowed != Changes::any)
        throw InputError(
            "the case differs from the one of the checkpoint, so this would be another "
            "run (--accept-changes goes on all the same):" +
            changed);
    return now;
}

} // namespace starling
