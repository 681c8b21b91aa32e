#include "simulation/run.hpp"

#include <chrono>
#include <limits>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/for_each.hpp"
#include "output/shell_word.hpp"
#include "output/version.hpp"
#include "simulation/estimate.hpp"
#include "simulation/resume.hpp"
#include "simulation/run_files.hpp"
#include "simulation/run_warnings.hpp"
#include "simulation/stop.hpp"
#include "theory/theory_report.hpp"

namespace starling {

namespace {

constexpr Real largest_theory_reynolds = 1; ///< the one-dimensional model has no inertia
constexpr Real least_step_factor = 0.125;   ///< after three breakdowns, each halving it

std::optional<TheoryReport> theory_of(const Case& c)
{
    if (!has_theory(c)) return std::nullopt;
    try {
        return theory_report({c.tube, c.material, c.fluid, c.drive});
    } catch (const NumericalError&) {
        return std::nullopt; // no steady state that the model can reach: nothing to compare with
    }
}

bool same_steps(const Case& a, const Case& b)
{
    return a.time.step == b.time.step && a.time.safety == b.time.safety;
}

/// The state of a run in progress.
class Run {
public:
    Run(const Case& c, const RunDirectoryOptions& directory, RunObserver& observer)
        : case_(c), observer_(observer), simulation_(c), cycles_(c), files_(c, directory, cycles_),
          stop_(c), theory_(theory_of(c))
    {
    }

    Summary execute()
    {
        begin();
        return go_on();
    }

    /// Goes on from a checkpoint; throws InputError where it leaves nothing to do.
    Summary resume(const CheckpointFile& file)
    {
        RunMemory m = file.read_memory();
        const Case before = case_of(file);
        const bool another = !differences(before, case_).empty();
        // What halved it were breakdowns of another choice of steps.
        const bool other_steps = another && !same_steps(before, case_);
        if (other_steps) m.step_factor = 1;
        // Nor is a state of another physics one to go back to.
        const CheckpointFile sound = another ? file : sound_point(file);
        simulation_.restore([&](State& s) { file.read(s); }, [&](State& s) { sound.read(s); },
                            m.step_factor);
        if (another) simulation_.choose_step();
        good_memory_ = another ? m : sound.read_memory();
        first_step_ = simulation_.steps();
        for (const Sample& s : m.window) stop_.add(s);
        cycles_.go_on_from(m.cycles, simulation_.time());
        stop_.look_at(cycles_);
        Moment at_rest = moment();
        at_rest.wall_seconds = 0; // counts from now
        stop_.check(at_rest);
        if (stop_.reason() && files_.complete(m, simulation_.steps()))
            throw InputError("nothing to do: the run has ended (" + *stop_.reason() +
                             "); change what ends it, as in --set " +
                             later_end(case_, *stop_.reason(), simulation_.steps()));
        const bool ended = stop_.reason().has_value();
        files_.check_go_on(m, before);
        for (const std::string& damage : files_.damage(m)) observer_.warn(damage);
        if (another || !files_.is_newest(file))
            files_.checkpoint_of_return(simulation_, m, good_memory_);
        remember(m);
        if (ended) stop_.check(at_rest); // killed while it wrote its last results: write them
        seconds_before_ = m.wall_seconds;
        phases_before_ = m.phase_seconds;
        if (theory_) files_.theory(*theory_);
        start();
        return go_on();
    }

private:
    /// What the run goes back to after a breakdown.
    CheckpointFile sound_point(const CheckpointFile& file)
    {
        try {
            return file.sound();
        } catch (const InputError& e) {
            observer_.warn(fmt::format("{}; the state of the checkpoint takes the place of the "
                                       "sound one, to which a breakdown soon after would go back",
                                       e.what()));
            return file;
        }
    }

    void start()
    {
        start_ = last_checkpoint_ = Clock::now();
        first_step_ = simulation_.steps();
        observer_.started({case_, simulation_});
    }

    void begin()
    {
        files_.begin();
        if (theory_) files_.theory(*theory_);
        start();
        take_sample();
        files_.fields(simulation_);
        files_.first_wall(simulation_);
        good_memory_ = memory();
    }

    Summary go_on()
    {
        try {
            return go_on_to_the_end();
        } catch (const InputError&) {
            throw;
        } catch (const NumericalError&) {
            throw;
        } catch (const DirectoryLost& e) {
            throw DirectoryLost(e.what() + rescue());
        } catch (const std::runtime_error&) {
            if (!ended_) rescue();
            throw;
        }
    }

    /// Rows or frames can no longer be written: keeps the last sound state, which they reach up to,
    /// if there is room for it. Says how to go on from there.
    std::string rescue()
    {
        simulation_.back_to_good();
        simulation_.set_step_factor(good_memory_.step_factor);
        try {
            const auto place = files_.rescue(simulation_, good_memory_);
            if (place) return "\n  go on: starling resume " + shell_word(*place);
        } catch (const std::exception& e) {
            return std::string("\n  its state could not be kept: ") + e.what();
        }
        return "";
    }

    Summary go_on_to_the_end()
    {
        try {
            while (!stop_.reason()) step_or_retry();
        } catch (const NumericalError& e) {
            end_broken_down(e);
            throw;
        }
        return end();
    }

    /// Writes the last results, all for which there is room.
    Summary end()
    {
        files_.check_held();
        ended_ = true;
        Attempts attempt;
        attempt([&] { // before the extra row and frames
            files_.checkpoint(simulation_, memory(), good_memory_);
        });
        if (files_.last_row() != simulation_.steps()) attempt([&] { take_sample(); });
        files_.finish(simulation_, attempt);
        Summary result = summary(*stop_.reason(), stop_.converged());
        attempt([&] { result.mean_leak_over_Q = files_.mean_leak(last_.step); });
        result.warnings = run_warnings(case_, result, step_factor_);
        attempt([&] { files_.summary(result); });
        attempt([&] { files_.sync(); });
        if (!attempt.failures().empty())
            throw std::runtime_error(
                fmt::format("the run has ended ({}), but not all of its last results could be "
                            "written:\n  {}",
                            result.reason, fmt::join(attempt.failures(), "\n  ")));
        return result;
    }

    /// Leaves the results of the last sound state.
    void end_broken_down(const NumericalError& e)
    {
        breakdown_ = e.breakdown().place;
        std::optional<Neighbourhood> broken;
        if (breakdown_) broken = simulation_.neighbourhood(*breakdown_);
        simulation_.back_to_good();
        cycles_.go_on_from(good_memory_.cycles, simulation_.time());
        Attempts attempt;
        attempt([&] { files_.checkpoint(simulation_, good_memory_, good_memory_); });
        last_ = simulation_.sample();
        files_.finish(simulation_, attempt);
        Summary result = summary(std::string("numerical error: ") + e.what(), false);
        attempt([&] { result.mean_leak_over_Q = files_.mean_leak(last_.step); });
        result.warnings = run_warnings(case_, result, step_factor_);
        attempt([&] { files_.summary(result); });
        if (broken)
            attempt([&] { files_.breakdown(simulation_.neighbourhood(*breakdown_), *broken); });
        for (const std::string& failure : attempt.failures()) observer_.warn(failure);
    }

    /// With an automatic step a breakdown is tried again from the last sound state with half of it,
    /// unless it is one of the geometry, which half the step meets as well.
    void step_or_retry()
    {
        try {
            step();
        } catch (const NumericalError& e) {
            const bool helps = e.breakdown().shorter_step_helps && !case_.time.step;
            if (!helps || step_factor_ <= least_step_factor) throw;
            go_back();
            observer_.retrying({e.what(), simulation_.steps(), simulation_.time(), step_factor_});
        }
    }

    /// To the last sound state, with half the step. A checkpoint says so before rows and frames of
    /// the course that is given up are dropped.
    void go_back()
    {
        simulation_.back_to_good();
        good_memory_.step_factor = step_factor_ / 2;
        simulation_.set_step_factor(good_memory_.step_factor);
        try_checkpoint(
            [&] { files_.checkpoint_of_return(simulation_, good_memory_, good_memory_); });
        remember(good_memory_);
    }

    /// The next time that a step must end at.
    Real target() const
    {
        const Real end = case_.stop.end_time.value_or(std::numeric_limits<Real>::infinity());
        const Real slack = closest_targets * simulation_.dt();
        const Real of_cycle = cycles_.next(), frame = files_.next_frame();
        const Real target = of_cycle < end - slack ? of_cycle : end;
        return frame < target - slack ? frame : target;
    }

    void step()
    {
        simulation_.step(target());
        if (simulation_.steps() % case_.output.sample_every == 0) take_sample();
        follow_cycle();
        patiently([&] { files_.fields(simulation_); });
        if (simulation_.good_step() == simulation_.steps()) good_memory_ = memory();
        stop_.check(moment());
        const TimeStepLimit& limiting = simulation_.limiting();
        observer_.stepped({simulation_.steps(), simulation_.time(), simulation_.dt(), limiting,
                           last_, seconds(), steps_per_second(), stop_.seconds_left(moment()),
                           cycles_.memory()});
        if (observer_.stop_requested()) stop_.interrupt();
        if (!stop_.reason() && checkpoint_is_due()) write_checkpoint_now();
    }

    bool checkpoint_is_due() const
    {
        const CheckpointParameters& p = case_.checkpoint;
        const Index step = simulation_.steps();
        if (p.steps && step % *p.steps == 0) return true;
        return checkpoint_is_timely(
            std::chrono::duration<double>(Clock::now() - last_checkpoint_).count(), p.every,
            simulation_.good_step() == step);
    }

    void write_checkpoint_now()
    {
        last_checkpoint_ = Clock::now();
        if (!is_finite(simulation_.state())) return; // the next check of the step will tell
        try_checkpoint([&] { files_.checkpoint(simulation_, memory(), good_memory_); });
    }

    /// A checkpoint that cannot be written does not end the run: the next one may succeed.
    template <class F>
    void try_checkpoint(F write)
    {
        try {
            write();
        } catch (const std::exception& e) {
            observer_.warn(fmt::format("no checkpoint: {}; the run goes on", e.what()));
        }
    }

    void take_sample()
    {
        last_ = simulation_.sample();
        stop_.add(last_);
        patiently([&] { files_.sample(last_); });
    }

    /// Writes rows or frames; where there is no room, tries again for some time.
    template <class F>
    void patiently(F write)
    {
        for (const auto begin = Clock::now(); true;) try {
                return write();
            } catch (const DirectoryLost&) {
                throw;
            } catch (const std::runtime_error& e) {
                if (ended_ || !wait_for_room(begin, e.what())) throw;
            }
    }

    /// Whether to try again what has failed for `reason`, since `begin`.
    bool wait_for_room(std::chrono::steady_clock::time_point begin, const std::string& reason)
    {
        using namespace std::chrono_literals;
        constexpr std::chrono::milliseconds patience = 60s, pause = 2s, glance = 100ms;
        const auto waited = Clock::now() - begin;
        if (waited < pause)
            observer_.warn(reason + "; trying again for a minute, until there is room");
        if (waited > patience) return false;
        for (std::chrono::milliseconds slept = 0ms; slept < pause; slept += glance) {
            if (observer_.stop_requested()) return false;
            std::this_thread::sleep_for(glance);
        }
        return true;
    }

    void follow_cycle()
    {
        if (!cycles_.due(simulation_.time(), simulation_.dt())) return;
        const bool sampled = last_.step == simulation_.steps();
        const std::vector<Vec3> shear = simulation_.wall_shear_stress();
        if (cycles_.add(sampled ? last_ : simulation_.sample(), shear)) stop_.look_at(cycles_);
    }

    RunMemory memory() const
    {
        RunMemory m;
        m.cycles = cycles_.memory();
        m.window = stop_.memory();
        m.wall_seconds = seconds_before_ + seconds();
        m.step_factor = step_factor_;
        for (const auto& phase : phase_seconds()) m.phase_seconds.push_back(phase.second);
        files_.note(m);
        return m;
    }

    /// Goes on from the moment of `m`, which the simulation has been set to.
    void remember(const RunMemory& m)
    {
        step_factor_ = m.step_factor;
        files_.go_on_from(m, simulation_.time(), simulation_.steps());
        stop_ = StopCriteria(case_);
        for (const Sample& s : m.window) stop_.add(s);
        cycles_.go_on_from(m.cycles, simulation_.time());
        stop_.look_at(cycles_);
        last_ = simulation_.sample();
    }

    Moment moment() const
    {
        return {simulation_.steps(), simulation_.time(), simulation_.dt(), seconds(), first_step_};
    }
    /// Real time since the run began or was resumed.
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    double steps_per_second() const
    {
        return static_cast<double>(simulation_.steps() - first_step_) / seconds();
    }

    /// Of the run from its beginning, also where it was resumed.
    std::vector<std::pair<std::string, double>> phase_seconds() const
    {
        std::vector<std::pair<std::string, double>> all;
        for (const PhaseTime& p : simulation_.phase_times()) {
            const std::size_t n = all.size();
            all.emplace_back(p.name,
                             p.seconds + (n < phases_before_.size() ? phases_before_[n] : 0));
        }
        return all;
    }

    Summary summary(const std::string& reason, bool converged) const
    {
        Summary s;
        s.title = case_.title;
        s.converged = converged;
        s.reason = reason;
        s.last = last_;
        s.mean_leak_over_Q = std::numeric_limits<Real>::quiet_NaN(); // to be read from series.csv
        s.spacing = simulation_.spacing();
        s.wall_seconds = seconds_before_ + seconds();
        s.cell_steps_per_second = static_cast<double>(simulation_.steps()) *
                                  static_cast<double>(simulation_.cells()) / s.wall_seconds;
        s.threads = max_threads();
        s.peak_memory_bytes = peak_memory_bytes();
        s.cells = simulation_.cells();
        s.vertices = simulation_.vertices();
        s.elements = simulation_.elements();
        s.version = version();
        s.breakdown = breakdown_;
        s.phase_seconds = phase_seconds();
        if (theory_) s.theory = TheoryValues{theory_->tube.Q, theory_->tube.R_max};
        if (cycles_.memory().cycles > 0) s.cycle = cycles_.memory();
        return s;
    }

    using Clock = std::chrono::steady_clock;

    const Case& case_;
    RunObserver& observer_;
    Simulation simulation_;
    Cycles cycles_;
    RunFiles files_;
    StopCriteria stop_;
    std::optional<TheoryReport> theory_;
    Sample last_;
    RunMemory good_memory_; ///< of the last sound state
    Real step_factor_ = 1;
    bool ended_ = false;              ///< the last results are being written
    std::optional<Vec3> breakdown_;   ///< where the run ended
    double seconds_before_ = 0;       ///< real time before the run was resumed
    std::vector<Real> phases_before_; ///< the same of the phases of the step
    Index first_step_ = 0;
    Clock::time_point start_ = Clock::now(), last_checkpoint_ = start_;
};

/// Runs; where a file could not be written, the message says how to go on.
template <class F>
Summary with_advice(const std::filesystem::path& directory, F f)
{
    try {
        return f();
    } catch (const InputError&) {
        throw;
    } catch (const NumericalError&) {
        throw;
    } catch (const DirectoryLost&) {
        throw;
    } catch (const std::runtime_error& e) {
        const bool can_go_on = !CheckpointRing::list(directory).empty();
        throw std::runtime_error(fmt::format(
            "{}\n  try: free space on the disk, then: {}", e.what(),
            can_go_on ? "starling resume " + shell_word(directory)
                      : "the same command with --force (there is no checkpoint to go on from)"));
    }
}

} // namespace

bool checkpoint_is_timely(double seconds, double every, bool found_sound)
{
    constexpr double earliest = 0.9; // of the interval
    return seconds >= (found_sound ? earliest : 1) * every;
}

std::string later_end(const Case& c, const std::string& reason, Index steps)
{
    if (reason == "steady" && c.stop.steady_tolerance)
        return fmt::format("stop.steady_tolerance={:g}", *c.stop.steady_tolerance / 10);
    if (reason == "periodic" && c.stop.periodic_tolerance)
        return fmt::format("stop.periodic_tolerance={:g}", *c.stop.periodic_tolerance / 10);
    if (reason == "steps") return fmt::format("stop.steps={}", 2 * steps);
    if (reason != "end time" || !c.stop.end_time) return "";
    const Real end = 2 * *c.stop.end_time * c.scaling.factor(Quantity::time);
    return c.scaling.si ? fmt::format("\"stop.end_time={:g} s\"", end)
                        : fmt::format("stop.end_time={:g}", end);
}

bool has_theory(const Case& c)
{
    const bool straight = c.tube.rest_radius.uniform();
    const bool slow = c.fluid.reynolds <= largest_theory_reynolds;
    const bool known = c.tube.rigid ? straight || slow : straight && slow && !may_collapse(c);
    return known && !c.drive.has_waveform() && c.drive.gives_pressures();
}

Summary run(const Case& c, const RunOptions& options, RunObserver& observer)
{
    const RunDirectoryOptions directory{options.directory, options.force, options.case_file};
    RunDirectory::check(directory); // before a set-up that takes long
    check_memory(c, available_memory_bytes());
    return with_advice(options.directory, [&] { return Run(c, directory, observer).execute(); });
}

Summary resume(const Case& c, const CheckpointFile& checkpoint,
               const std::filesystem::path& directory, RunObserver& observer)
{
    const RunDirectoryOptions options{directory, false, {}, true};
    RunDirectory::check(options);
    check_memory(c, available_memory_bytes());
    return with_advice(directory, [&] { return Run(c, options, observer).resume(checkpoint); });
}

} // namespace starling
