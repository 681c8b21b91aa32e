#pragma once
/// What the user asked for.
#include <string>
#include <vector>

namespace starling::app {

/// The arguments of all subcommands; each uses some.
struct CommandLine {
    std::string command;                ///< name of the subcommand
    std::string case_file;              ///< run, check, theory
    std::vector<std::string> overrides; ///< "section.key=value"
    std::string directory;              ///< run --out, resume, plot; info, export: or a file
    std::string name;                   ///< cases NAME; may be empty
    std::string checkpoint;             ///< resume --from; may be empty
    int threads = 0;                    ///< 0: as many as OpenMP offers
    bool force = false;
    bool quiet = false;
    std::string csv;             ///< theory --csv: "profile", "buckling", "tube-law"; empty: text
    bool accept_changes = false; ///< resume
    std::string export_file;     ///< export --out
    std::string time;            ///< export --time; empty: the last
    std::string what;            ///< export --what: "wall", "fluid"; empty: by the file's name
    std::vector<std::string> grids, walls; ///< bench --grid, --wall; empty: the usual ones
    std::vector<int> thread_counts;        ///< bench --threads
    int repeats = 0;                       ///< bench; 0: the usual number
    bool quick = false;                    ///< bench
    std::string json_file;                 ///< bench --json; empty: none
};

/// Thrown after --help or --version has been answered.
struct Done {};

/// Throws InputError for wrong usage, with the nearest valid name, and Done.
CommandLine parse(int argc, char** argv);

} // namespace starling::app
