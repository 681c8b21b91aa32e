#include "output/checkpoint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <exception>

#include <fmt/format.h>

#include "core/error.hpp"
#include "output/file_name.hpp"
#include "output/replace_file.hpp"
#include "output/series.hpp"
#include "output/version.hpp"

namespace starling {

namespace fs = std::filesystem;

namespace {

constexpr std::array<const char*, 3> component_names = {"u", "v", "w"};
constexpr std::array<const char*, 2> end_pressure_names = {"/fluid/P_inlet", "/fluid/P_outlet"};

[[noreturn]] void refuse(const fs::path& path, const std::string& reason)
{
    throw InputError(path.string() + ": " + reason);
}

/// The small numbers of a run's memory as attributes of /run.
template <class Self, class F>
void for_numbers(Self& m, F f)
{
    f("last_row", m.last_row);
    f("wall_frames", m.wall_frames);
    f("fluid_frames", m.fluid_frames);
    f("wall_step", m.wall_step);
    f("fluid_step", m.fluid_step);
    f("next_wall", m.next_wall);
    f("next_fluid", m.next_fluid);
    f("wall_seconds", m.wall_seconds);
    f("step_factor", m.step_factor);
    f("cycle_period", m.cycles.period);
    f("cycle_samples", m.cycles.per_cycle);
    f("cycle_next", m.cycles.next);
    f("cycles", m.cycles.cycles);
    f("cycle_change", m.cycles.change);
    f("cycle_change_before", m.cycles.change_before);
}

/// The lists of samples, by name.
template <class Self, class F>
void for_samples(Self& m, F f)
{
    f("/run/window", m.window);
    f("/run/last_cycle", m.cycles.last);
    f("/run/this_cycle", m.cycles.current);
}

/// The sums of wall shear stress, by name.
template <class Self, class F>
void for_shear(Self& m, F f)
{
    f("/run/last_shear", m.cycles.shear_last);
    f("/run/this_shear", m.cycles.shear_current);
}

/// What the ends remember beside fields, by name.
template <class Ends, class F>
void for_end_values(Ends& ends, F f)
{
    f("inside_inlet", ends.inside[0]);
    f("inside_outlet", ends.inside[1]);
    f("windkessel", ends.stored);
}

/// The fields of the fluid, by name.
template <class Fluid, class F>
void for_fields(Fluid& fluid, F f)
{
    for (std::size_t c = 0; c < 3; ++c) {
        f(std::string("/fluid/") + component_names[c], fluid.u.component[c]);
        f(std::string("/fluid/N_before_") + component_names[c], fluid.N_before.component[c]);
    }
    f("/fluid/P", fluid.P);
}

std::span<const Real> as_reals(const Array<Vec3>& a)
{
    static_assert(sizeof(Vec3) == 3 * sizeof(Real));
    return {reinterpret_cast<const Real*>(a.data()), 3 * static_cast<std::size_t>(a.size())};
}

std::span<Real> as_reals(Array<Vec3>& a)
{
    return {reinterpret_cast<Real*>(a.data()), 3 * static_cast<std::size_t>(a.size())};
}

void write_state(hdf5::File& file, const State& s)
{
    using enum hdf5::Precision;
    for (const char* group : {"/state", "/fluid", "/wall", "/ghosts"}) file.make_group(group);
    file.attribute("/state", "t", s.t);
    file.attribute("/state", "step", s.step);
    file.attribute("/state", "dt", s.dt);
    file.attribute("/state", "dt_before", s.fluid.dt_before);
    file.attribute("/state", "kinetic_energy", s.fluid.kinetic_energy);
    file.attribute("/state", "kinetic_energy_before", s.fluid.kinetic_energy_before);
    for_end_values(s.fluid.ends,
                   [&](const char* name, Real value) { file.attribute("/state", name, value); });
    for_fields(s.fluid, [&](const std::string& path, const ScalarField& f) {
        const auto v = f.values().span();
        file.write(path, {v.size()}, v, full);
    });
    for (std::size_t end = 0; end < 2; ++end)
        file.write(end_pressure_names[end],
                   {static_cast<hsize_t>(s.fluid.ends.pressure[end].size())},
                   s.fluid.ends.pressure[end].span(), full);
    const hsize_t vertices = static_cast<hsize_t>(s.wall.x.size());
    file.write("/wall/x", {vertices, 3}, as_reals(s.wall.x), full);
    file.write("/wall/velocity", {vertices, 3}, as_reals(s.wall.velocity), full);
    file.write("/wall/support", {vertices, 3}, as_reals(s.wall.support), full);
    file.write("/wall/support_rate", {vertices, 3}, as_reals(s.wall.support_rate), full);
    file.write("/wall/passing", {vertices, 3}, as_reals(s.wall.passing), full);
}

void write_ghosts(hdf5::File& file, const GhostState& s, const std::string& group)
{
    file.make_group(group);
    file.write(group + "/inside", s.inside.values().span());
    std::vector<std::int32_t> node, element;
    std::vector<std::uint8_t> outside;
    std::vector<Real> point, squared_distance;
    for (const NearNode& n : s.near_wall) {
        node.insert(node.end(), {n.i, n.j, n.k});
        element.push_back(n.intercept.element);
        outside.push_back(n.intercept.outside ? 1 : 0);
        const Vec3& p = n.intercept.point;
        point.insert(point.end(), {p.x, p.y, p.z});
        squared_distance.push_back(n.intercept.squared_distance);
    }
    const hsize_t count = s.near_wall.size();
    file.write(group + "/node", {count, 3}, node);
    file.write(group + "/element", {count}, element);
    file.write(group + "/outside", outside);
    file.write(group + "/point", {count, 3}, point, hdf5::Precision::full);
    file.write(group + "/squared_distance", {count}, squared_distance, hdf5::Precision::full);
}

void read_ghosts(const hdf5::File& file, GhostState& s, const std::string& group)
{
    file.read(group + "/inside",
              {s.inside.values().data(), static_cast<std::size_t>(s.inside.values().size())});
    const std::size_t count = file.size(group + "/element");
    std::vector<std::int32_t> node(3 * count), element(count);
    std::vector<std::uint8_t> outside(count);
    std::vector<Real> point(3 * count), squared_distance(count);
    file.read(group + "/node", node);
    file.read(group + "/element", element);
    file.read(group + "/outside", outside);
    file.read(group + "/point", point);
    file.read(group + "/squared_distance", squared_distance);
    s.near_wall.resize(count); // keeps the room that was reserved for it
    for (std::size_t n = 0; n < count; ++n)
        s.near_wall[n] = {node[3 * n],
                          node[3 * n + 1],
                          node[3 * n + 2],
                          false,
                          {element[n],
                           {point[3 * n], point[3 * n + 1], point[3 * n + 2]},
                           squared_distance[n],
                           outside[n] != 0}};
}

void write_memory(hdf5::File& file, const RunMemory& m)
{
    file.make_group("/run");
    for_numbers(m, [&](const char* name, auto value) { file.attribute("/run", name, value); });
    file.write("/run/phase_seconds", {m.phase_seconds.size()}, m.phase_seconds,
               hdf5::Precision::full);
    for_samples(m, [&](const char* name, const std::vector<Sample>& samples) {
        std::vector<Real> values;
        for (const Sample& s : samples)
            for (const Column<Sample>& c : sample_columns())
                values.push_back(
                    std::visit([&](auto p) { return static_cast<Real>(s.*p); }, c.member));
        file.write(name, {samples.size(), sample_columns().size()}, values, hdf5::Precision::full);
    });
    for_shear(m, [&](const char* name, const ShearSums& sums) {
        std::vector<Real> values;
        for (std::size_t v = 0; v < sums.stress.size(); ++v) {
            const Vec3& s = sums.stress[v];
            values.insert(values.end(), {s.x, s.y, s.z, sums.magnitude[v]});
        }
        file.write(name, {sums.stress.size(), 4}, values, hdf5::Precision::full);
    });
}

std::string file_of(const char* kind, Index step)
{
    return fmt::format("{}_{:010}.h5", kind, step);
}
std::string checkpoint_name(Index step) { return file_of("step", step); }
std::string sound_name(Index step) { return file_of("sound", step); } ///< beside that checkpoint

void write_hdf5(const fs::path& path, const RunPoint& point, Index sound_step,
                const std::string& case_text)
{
    const State& state = point.state;
    hdf5::File file = hdf5::File::create(path, hdf5::Layout::contiguous, seal_size);
    file.attribute("/", "format", std::string("starling checkpoint"));
    file.attribute("/", "format_version", Index{checkpoint_seal.version});
    file.attribute("/", "version", version());
    file.attribute("/", "units", std::string("dimensionless: R_0, U_c, rho"));
    write_state(file, state);
    file.attribute("/state", "sound_step", sound_step);
    for (std::size_t c = 0; c < 3; ++c)
        write_ghosts(file, state.ghosts[c], std::string("/ghosts/") + component_names[c]);
    write_memory(file, point.memory);
    const auto* text = reinterpret_cast<const std::uint8_t*>(case_text.data());
    file.write("/case", std::span(text, case_text.size()));
    save_sealed(file, checkpoint_seal, true);
}

bool all_finite(std::span<const Real> values)
{
    return std::ranges::all_of(values, [](Real v) { return std::isfinite(v); });
}

} // namespace

bool is_finite(const State& s)
{
    bool finite = std::isfinite(s.t) && std::isfinite(s.dt) && std::isfinite(s.fluid.ends.stored) &&
                  std::isfinite(s.fluid.kinetic_energy) &&
                  std::isfinite(s.fluid.kinetic_energy_before) && all_finite(as_reals(s.wall.x)) &&
                  all_finite(as_reals(s.wall.velocity)) && all_finite(as_reals(s.wall.support)) &&
                  all_finite(as_reals(s.wall.support_rate)) && all_finite(as_reals(s.wall.passing));
    for_fields(s.fluid, [&](const std::string&, const ScalarField& f) {
        finite = finite && all_finite(f.values().span());
    });
    for (const Array<Real>& values : s.fluid.ends.pressure)
        finite = finite && all_finite(values.span());
    return finite;
}

namespace {

void write_point(const fs::path& path, const RunPoint& point, Index sound_step,
                 const std::string& case_text)
{
    if (!is_finite(point.state))
        throw std::logic_error("a state that is not finite is no checkpoint");
    const fs::path temporary = path.string() + ".new";
    try {
        write_hdf5(temporary, point, sound_step, case_text);
        fs::rename(temporary, path);
        sync_to_disk(path.parent_path()); // its name
    } catch (...) {
        std::error_code none;
        fs::remove(temporary, none);
        throw;
    }
}

} // namespace

fs::path write_checkpoint(const fs::path& folder, const RunRecord& record)
{
    const Index step = record.now.state.step, sound_step = record.sound.state.step;
    fs::path path = folder / checkpoint_name(step);
    std::exception_ptr no_sound; // the present state may be written all the same
    try {
        if (sound_step != step)
            write_point(folder / sound_name(step), record.sound, sound_step, record.case_text);
    } catch (const std::runtime_error&) {
        no_sound = std::current_exception();
    }
    try {
        write_point(path, record.now, sound_step, record.case_text);
    } catch (...) { // no room is taken by what is of no use alone
        std::error_code none;
        if (!fs::exists(path, none)) fs::remove(folder / sound_name(step), none);
        throw;
    }
    if (no_sound) std::rethrow_exception(no_sound);
    if (sound_step == step) fs::remove(folder / sound_name(step)); // of an earlier one
    return path;
}

CheckpointFile::CheckpointFile(const fs::path& path) : path_(path)
{
    check_seal(path, checkpoint_seal);
    try {
        const hdf5::File file = hdf5::File::open(path);
        step_ = file.index_attribute("/state", "step");
        sound_step_ = file.index_attribute("/state", "sound_step");
        t_ = file.real_attribute("/state", "t");
        version_ = file.text_attribute("/", "version");
        case_text_.resize(file.size("/case"));
        file.read("/case",
                  std::span(reinterpret_cast<std::uint8_t*>(case_text_.data()), case_text_.size()));
    } catch (const std::exception& e) {
        refuse(path, e.what());
    }
}

CheckpointFile CheckpointFile::sound() const
{
    if (sound_step_ == step_) return *this;
    const fs::path beside = path_.parent_path() / sound_name(step_);
    CheckpointFile found(beside);
    if (found.step_ != sound_step_)
        refuse(beside, fmt::format("is of step {}, not {}", found.step_, sound_step_));
    return found;
}

void CheckpointFile::read(State& s) const
{
    try {
        const hdf5::File file = hdf5::File::open(path_);
        s.t = file.real_attribute("/state", "t");
        s.step = file.index_attribute("/state", "step");
        s.dt = file.real_attribute("/state", "dt");
        s.fluid.dt_before = file.real_attribute("/state", "dt_before");
        s.fluid.kinetic_energy = file.real_attribute("/state", "kinetic_energy");
        s.fluid.kinetic_energy_before = file.real_attribute("/state", "kinetic_energy_before");
        for_end_values(s.fluid.ends, [&](const char* name, Real& value) {
            value = file.real_attribute("/state", name);
        });
        for_fields(s.fluid, [&](const std::string& path, ScalarField& f) {
            file.read(path, std::span(f.values().data(), f.values().span().size()));
        });
        for (std::size_t end = 0; end < 2; ++end) {
            Array<Real>& values = s.fluid.ends.pressure[end];
            file.read(end_pressure_names[end],
                      std::span(values.data(), static_cast<std::size_t>(values.size())));
        }
        file.read("/wall/x", as_reals(s.wall.x));
        file.read("/wall/velocity", as_reals(s.wall.velocity));
        file.read("/wall/support", as_reals(s.wall.support));
        file.read("/wall/support_rate", as_reals(s.wall.support_rate));
        file.read("/wall/passing", as_reals(s.wall.passing));
        for (std::size_t c = 0; c < 3; ++c)
            read_ghosts(file, s.ghosts[c], std::string("/ghosts/") + component_names[c]);
    } catch (const std::exception& e) {
        refuse(path_, std::string(e.what()) + " (another grid or wall?)");
    }
}

namespace {

void set(Real& target, Real value) { target = value; }

/// Throws std::runtime_error for what is no whole number.
void set(Index& target, Real value)
{
    constexpr Real largest = 9007199254740992; // 2^53: whole numbers below are exact
    if (!(std::abs(value) <= largest) || value != std::trunc(value))
        throw std::runtime_error(
            fmt::format("a sample holds {} in place of a whole number", value));
    target = static_cast<Index>(value);
}

} // namespace

/// Throws std::runtime_error for cycles that could not have been.
void check_cycles(const CycleMemory& m)
{
    const auto count = [](const std::vector<Sample>& s) { return static_cast<Index>(s.size()); };
    if (m.period == 0) return;
    const bool whole = m.cycles == 0 ? m.last.empty() : count(m.last) == m.per_cycle;
    if (!(m.period > 0) || m.per_cycle < 1 || m.next < 1 || m.cycles < 0 || !whole ||
        count(m.current) >= m.per_cycle)
        throw std::runtime_error("its cycles do not fit together");
}

RunMemory CheckpointFile::read_memory() const
{
    try {
        const hdf5::File file = hdf5::File::open(path_);
        RunMemory m;
        for_numbers(m, [&](const char* name, auto& value) {
            if constexpr (std::is_same_v<decltype(value), Index&>)
                value = file.index_attribute("/run", name);
            else
                value = file.real_attribute("/run", name);
        });
        m.phase_seconds.resize(file.size("/run/phase_seconds"));
        file.read("/run/phase_seconds", m.phase_seconds);
        for_samples(m, [&](const char* name, std::vector<Sample>& samples) {
            const auto columns = sample_columns();
            samples.resize(file.size(name) / columns.size());
            std::vector<Real> values(samples.size() * columns.size());
            file.read(name, values);
            auto value = values.begin();
            for (Sample& s : samples)
                for (const Column<Sample>& c : columns)
                    std::visit([&](auto p) { set(s.*p, *value++); }, c.member);
        });
        for_shear(m, [&](const char* name, ShearSums& sums) {
            std::vector<Real> values(file.size(name));
            file.read(name, values);
            for (std::size_t n = 0; n + 3 < values.size(); n += 4) {
                sums.stress.push_back({values[n], values[n + 1], values[n + 2]});
                sums.magnitude.push_back(values[n + 3]);
            }
        });
        check_cycles(m.cycles);
        return m;
    } catch (const std::exception& e) {
        refuse(path_, e.what());
    }
}

namespace {

bool is_checkpoint_name(const std::string& name)
{
    return is_numbered_name(name, "step_", 10, ".h5");
}

/// What a kill left of a checkpoint.
std::vector<fs::path> unfinished(const fs::path& folder)
{
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder))
        for (const char* kind : {"step_", "sound_"})
            if (is_numbered_name(entry.path().filename().string(), kind, 10, ".h5.new"))
                found.push_back(entry.path());
    return found;
}

void remove_with_its_sound(const fs::path& checkpoint)
{
    const std::string number = checkpoint.filename().string().substr(std::strlen("step"));
    fs::remove(checkpoint);
    fs::remove(checkpoint.parent_path() / ("sound" + number));
}

void point_latest(const fs::path& folder, const fs::path& name)
{
    std::error_code none;
    const fs::path temporary = folder / "latest.new";
    fs::remove(temporary, none);
    fs::create_symlink(name, temporary);
    fs::rename(temporary, folder / "latest");
}

} // namespace

CheckpointRing::CheckpointRing(const fs::path& run_directory, Index keep)
    : directory_(run_directory), keep_(keep)
{
}

fs::path CheckpointRing::folder(const fs::path& run_directory)
{
    return run_directory / "checkpoints";
}

std::vector<fs::path> CheckpointRing::list(const fs::path& run_directory)
{
    std::vector<fs::path> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder(run_directory), error))
        if (is_checkpoint_name(entry.path().filename())) found.push_back(entry.path());
    std::ranges::sort(found, std::greater<>());
    return found;
}

std::vector<fs::path> CheckpointRing::orphans(const fs::path& run_directory)
{
    std::vector<fs::path> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder(run_directory), none)) {
        const std::string name = entry.path().filename();
        if (!is_numbered_name(name, "sound_", 10, ".h5")) continue;
        const std::string of = "step" + name.substr(std::strlen("sound"));
        if (!fs::exists(entry.path().parent_path() / of)) found.push_back(entry.path());
    }
    return found;
}

void CheckpointRing::write(const RunRecord& record)
{
    if (keep_ == 0) {
        for (const fs::path& p : list(directory_))
            if (newest_ >= 0 && p.filename() > checkpoint_name(newest_)) remove_with_its_sound(p);
        return;
    }
    const fs::path folder_path = folder(directory_);
    fs::create_directories(folder_path);
    const std::string name = write_checkpoint(folder_path, record).filename();
    newest_ = std::max(newest_, record.now.state.step);
    const std::string newest = checkpoint_name(newest_);
    point_latest(folder_path, newest);
    Index kept = name == newest ? 1 : 0; // an older one is kept beside them
    for (const fs::path& p : list(directory_))
        if (p.filename() > newest || (p.filename() != name && ++kept > keep_))
            remove_with_its_sound(p);
    std::error_code none;
    for (const fs::path& p : unfinished(folder_path)) fs::remove(p, none);
    for (const fs::path& p : orphans(directory_)) fs::remove(p, none);
}

} // namespace starling
