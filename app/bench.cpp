#include "bench.hpp"

#include <cstdio>
#include <filesystem>

#include <fmt/format.h>
#include <omp.h>

#include "bench/bench.hpp"
#include "core/error.hpp"
#include "output/replace_file.hpp"
#include "output/summary.hpp"

namespace starling::app {

namespace {

namespace fs = std::filesystem;

constexpr Index cells_of_large_grids = 10'000'000;
constexpr Index quick_triad_size = Index{1} << 20;

std::vector<std::string> grids(const CommandLine& line)
{
    if (!line.grids.empty()) return line.grids;
    if (line.quick) return {"32x24x24"};
    return {"256x96x96", "512x240x240"};
}

/// The walls for a grid: what the line says, or none and one as fine as the grid asks for.
std::vector<std::string> walls(const CommandLine& line, const bench::Problem& grid)
{
    if (!line.walls.empty()) return line.walls;
    if (line.quick) return {"none", "1k"};
    return {"none", grid.cell_count() < cells_of_large_grids ? "17k" : "250k"};
}

std::vector<int> threads(const CommandLine& line)
{
    if (!line.thread_counts.empty()) return line.thread_counts;
    if (line.quick || omp_get_num_procs() < 2) return {1};
    return {1, 2};
}

bench::Plan plan_of(const CommandLine& line)
{
    bench::Plan plan;
    for (const std::string& grid : grids(line)) {
        bench::Problem p{bench::parse_grid(grid)};
        for (const std::string& wall : walls(line, p)) {
            p.vertices = bench::parse_wall(wall);
            plan.problems.push_back(p);
        }
    }
    plan.threads = threads(line);
    plan.repeats = line.repeats > 0 ? line.repeats : line.quick ? 3 : 5;
    if (line.quick) plan.triad_size = quick_triad_size;
    return plan;
}

/// Finds out before the work whether the file can be written after it.
void check_writable(const std::string& file)
{
    const fs::path folder = fs::absolute(file).parent_path();
    if (fs::is_directory(file) || !fs::is_directory(folder))
        throw InputError("--json " + file + ": cannot be written");
}

} // namespace

void bench_command(const CommandLine& line)
{
    const bench::Plan plan = plan_of(line);
    if (!line.json_file.empty()) check_writable(line.json_file);
    bench::check_memory(plan, available_memory_bytes());
    const bench::Report report = bench::run(plan, [&](const std::string& what) {
        if (!line.quiet) fmt::print("{}\n", what);
        std::fflush(stdout);
    });
    fmt::print("{}", bench::to_text(report));
    if (!line.json_file.empty()) replace_file(line.json_file, bench::to_json(report));
}

} // namespace starling::app
