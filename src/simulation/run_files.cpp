#include "simulation/run_files.hpp"

#include <fstream>
#include <iterator>

#include "config/write_case.hpp"
#include "core/error.hpp"
#include "output/frame_file.hpp"
#include "output/profile.hpp"
#include "output/replace_file.hpp"
#include "output/sections.hpp"

namespace starling {

bool Schedule::due(Real t, Real dt)
{
    if (!every_) return false;
    const Real slack = closest_targets * std::min(dt, *every_);
    if (t < next_ - slack) return false;
    next_ = *every_ * (std::floor((t + slack) / *every_) + 1);
    return true;
}

void Schedule::go_on(Real t, Real next)
{
    if (!every_) return;
    const bool same =
        next > t && next == *every_ * std::round(next / *every_) && next <= t + 2 * *every_;
    next_ = same ? next : *every_ * (std::floor(t / *every_) + 1);
}

RunFiles::RunFiles(const Case& c, const RunDirectoryOptions& directory, const Cycles& cycles)
    : case_(c), cycles_(cycles), directory_(directory),
      checkpoints_(directory_.path(), c.checkpoint.keep), wall_due_(c.output.wall_every),
      fluid_due_(c.output.fluid_every)
{
}

void RunFiles::begin()
{
    write_own_case();
    series_.emplace(directory_.file("series.csv"), case_.scaling);
}

bool RunFiles::complete(const RunMemory& m, Index step) const
{
    for (const char* name : {"summary.json", "profile.csv", "sections.csv"})
        if (!std::filesystem::exists(directory_.file(name))) return false;
    const bool wall =
        !case_.output.wall || m.wall_step == step || lists_frame("wall", m.wall_frames);
    const bool fluid =
        !case_.output.fluid || m.fluid_step == step || lists_frame("fluid", m.fluid_frames);
    return wall && fluid &&
           SeriesWriter::has_row(directory_.file("series.csv"), case_.scaling, step);
}

bool RunFiles::lists_frame(const std::string& of, Index number) const
{
    std::ifstream stream(directory_.file((of + ".xdmf").c_str()), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    return text.find(frame_name(of, number) + ":") != std::string::npos;
}

void RunFiles::write_own_case() const
{
    replace_file(
        directory_.file("case.toml"),
        write_case_with_end(written_case_mark + std::string(": every default filled in"), case_));
}

void RunFiles::check_go_on(const RunMemory& m, const Case& before) const
{
    SeriesWriter::check_row(directory_.file("series.csv"), case_.scaling, m.last_row);
    FrameWriter::lists_frames(field_options(m.wall_frames), "wall");
    FrameWriter::lists_frames(field_options(m.fluid_frames), "fluid");
    const SnapshotParameters &was = before.output.fluid_part, &is = case_.output.fluid_part;
    if (m.fluid_frames > 0 && (was.region != is.region || was.stride != is.stride))
        throw InputError(
            "output.fluid_region and output.fluid_stride cannot change while there are "
            "frames of the fluid: those of fluid.xdmf have one grid; leave them as "
            "they were, or run the case in another directory");
}

std::vector<std::string> RunFiles::damage(const RunMemory& m) const
{
    std::vector<std::string> found;
    const std::filesystem::path series = directory_.file("series.csv");
    try {
        inspect_series(series, m.last_row);
    } catch (const std::exception& e) {
        found.push_back(series.string() + ": " + e.what() +
                        "; the run goes on, the row stays as it is, mean_leak_over_Q of "
                        "summary.json will be null");
    }
    for (const auto& [of, count] : {std::pair{"wall", m.wall_frames}, {"fluid", m.fluid_frames}}) {
        if (!FrameWriter::lists_frames(field_options(count), of))
            found.push_back(directory_.file((std::string(of) + ".xdmf").c_str()).string() +
                            ": does not list all frames up to the checkpoint; it is made anew from "
                            "them");
        for (Index n = 0; n < count; ++n) try {
                check_seal(directory_.path() / frame_name(of, n), frame_seal);
            } catch (const InputError& e) {
                found.push_back(std::string(e.what()) +
                                "; the run goes on, this frame stays as it is");
            }
    }
    return found;
}

void RunFiles::go_on_from(const RunMemory& m, Real t, Index step)
{
    series_.emplace(directory_.file("series.csv"), case_.scaling, m.last_row);
    write_own_case();
    directory_.remove_end(); // which is none
    wall_.emplace(field_options(m.wall_frames));
    fluid_.emplace(field_options(m.fluid_frames));
    checkpoints_.go_on_from(step);
    wall_is_due_ = fluid_is_due_ = false;
    wall_due_.go_on(t, m.next_wall);
    fluid_due_.go_on(t, m.next_fluid);
    last_row_ = m.last_row;
    wall_step_ = m.wall_step;
    fluid_step_ = m.fluid_step;
}

void RunFiles::note(RunMemory& m) const
{
    m.last_row = last_row_;
    m.wall_frames = wall_ ? wall_->frames() : 0;
    m.fluid_frames = fluid_ ? fluid_->frames() : 0;
    m.wall_step = wall_step_;
    m.fluid_step = fluid_step_;
    m.next_wall = std::min(wall_due_.next(), std::numeric_limits<Real>::max());
    m.next_fluid = std::min(fluid_due_.next(), std::numeric_limits<Real>::max());
}

void RunFiles::theory(const TheoryReport& report)
{
    replace_file(directory_.file("theory.csv"), to_csv(report, case_.scaling));
}

void RunFiles::sample(const Sample& s)
{
    check_held();
    series_->write(s);
    last_row_ = s.step;
}

void RunFiles::fields(const Simulation& simulation)
{
    wall_is_due_ = wall_due_.due(simulation.time(), simulation.dt()) || wall_is_due_;
    fluid_is_due_ = fluid_due_.due(simulation.time(), simulation.dt()) || fluid_is_due_;
    if (wall_is_due_) wall(simulation);
    wall_is_due_ = false;
    if (fluid_is_due_) fluid(simulation);
    fluid_is_due_ = false;
}

void RunFiles::first_wall(const Simulation& simulation)
{
    if (simulation.steps() != wall_step_) wall(simulation);
}

void RunFiles::checkpoint(const Simulation& simulation, const RunMemory& memory,
                          const RunMemory& good)
{
    check_held();
    sync();
    checkpoints_.write(
        {{simulation.state(), memory}, {simulation.good_state(), good}, write_case(case_)});
}

void RunFiles::checkpoint_of_return(const Simulation& simulation, const RunMemory& memory,
                                    const RunMemory& good)
{
    checkpoints_.go_on_from(simulation.steps());
    checkpoint(simulation, memory, good);
}

bool RunFiles::is_newest(const CheckpointFile& file) const
{
    const auto all = CheckpointRing::list(directory_.path());
    std::error_code none;
    return !all.empty() && std::filesystem::equivalent(all.front(), file.path(), none);
}

std::optional<std::filesystem::path> RunFiles::rescue(const Simulation& simulation,
                                                      const RunMemory& memory) const
{
    const auto place = directory_.where();
    const RunPoint point{simulation.state(), memory};
    if (place)
        CheckpointRing(*place, case_.checkpoint.keep).write({point, point, write_case(case_)});
    return place;
}

void RunFiles::breakdown(const Neighbourhood& sound, const Neighbourhood& broken)
{
    check_held();
    FieldFileOptions options = field_options(0);
    options.prefix = "breakdown_";
    WallFile wall(options);
    FluidFile fluid(options);
    for (const Neighbourhood* n : {&sound, &broken}) {
        wall.write(n->wall);
        fluid.write(n->fluid);
    }
}

void RunFiles::finish(const Simulation& simulation, Attempts& attempt)
{
    attempt([&] {
        check_held();
        std::vector<ProfileRow> rows = simulation.profile();
        add_shear(cycles_.memory(), simulation.ring_size(), rows);
        write_profile(directory_.file("profile.csv"), rows, case_.scaling);
    });
    attempt([&] {
        check_held();
        write_sections(directory_.file("sections.csv"), simulation.sections(), case_.scaling);
    });
    if (simulation.steps() > wall_step_) attempt([&] { wall(simulation); });
    if (simulation.steps() > fluid_step_) attempt([&] { fluid(simulation); });
}

void RunFiles::summary(const Summary& s)
{
    check_held();
    write_summary(directory_.file("summary.json"), s, case_.scaling);
}

void RunFiles::sync()
{
    for (const char* name : {"series.csv", "profile.csv", "sections.csv", "summary.json"})
        if (std::filesystem::exists(directory_.file(name))) sync_to_disk(directory_.file(name));
    if (wall_) wall_->sync();
    if (fluid_) fluid_->sync();
    sync_to_disk(directory_.path()); // their names
}

FieldFileOptions RunFiles::field_options(Index keep) const
{
    return {directory_.path(), case_.scaling,
            case_.output.double_precision ? hdf5::Precision::full : hdf5::Precision::single, keep};
}

void RunFiles::wall(const Simulation& simulation)
{
    if (!case_.output.wall) return;
    check_held();
    if (!wall_) wall_.emplace(field_options(0));
    WallSnapshot snapshot = simulation.wall_snapshot();
    add_shear(cycles_.memory(), snapshot);
    wall_->write(snapshot);
    wall_step_ = simulation.steps();
}

void RunFiles::fluid(const Simulation& simulation)
{
    if (!case_.output.fluid) return;
    check_held();
    if (!fluid_) fluid_.emplace(field_options(0));
    fluid_->write(simulation.fluid_snapshot());
    fluid_step_ = simulation.steps();
}

} // namespace starling
