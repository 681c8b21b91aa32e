#include "simulation/run.hpp"

#include <chrono>
#include <iomanip>
#include <limits>
#include <sstream>

#include <fmt/format.h>

#include "config/write_case.hpp"
#include "core/error.hpp"
#include "core/for_each.hpp"
#include "output/field_file.hpp"
#include "output/profile.hpp"
#include "output/replace_file.hpp"
#include "output/run_directory.hpp"
#include "output/sections.hpp"
#include "output/series.hpp"
#include "output/version.hpp"
#include "simulation/stop.hpp"
#include "theory/theory_report.hpp"

namespace starling {

namespace {

constexpr Real least_resolved_gap = 2;      ///< in grid spacings
constexpr Real largest_theory_reynolds = 1; ///< the one-dimensional model has no inertia
constexpr Real closest_targets = 0.25;      ///< in steps: times nearer to each other are one
constexpr Real leak_to_warn_of = 0.02;      ///< share of the flow

std::optional<TheoryReport> theory_of(const Case& c)
{
    if (!has_theory(c)) return std::nullopt;
    try {
        return theory_report({c.tube, c.material, c.fluid, c.drive});
    } catch (const NumericalError&) {
        return std::nullopt; // no steady state that the model can reach: nothing to compare with
    }
}

std::string percent_text(Real share)
{
    std::ostringstream text;
    text << std::setprecision(3) << 100 * share << " %";
    return text.str();
}

/// The times at which frames are due: 0 and the multiples of `every`.
class Schedule {
public:
    explicit Schedule(std::optional<Real> every) : every_(every) {}
    /// Time of the next frame; infinite where only the first and last states are wanted.
    Real next() const { return every_ ? next_ : std::numeric_limits<Real>::infinity(); }
    /// Whether a frame is due at t; one due within a quarter of a step counts.
    bool due(Real t, Real dt)
    {
        if (!every_) return false;
        const Real slack = closest_targets * std::min(dt, *every_);
        if (t < next_ - slack) return false;
        next_ = *every_ * (std::floor((t + slack) / *every_) + 1);
        return true;
    }

private:
    std::optional<Real> every_;
    Real next_ = 0;
};

/// The files of one run, each opened when it is first needed.
class RunFiles {
public:
    RunFiles(const Case& c, const RunOptions& options)
        : case_(c), directory_({options.directory, options.force, options.case_file}),
          series_(directory_.file("series.csv"), c.scaling), wall_due_(c.output.wall_every),
          fluid_due_(c.output.fluid_every)
    {
        replace_file(directory_.file("case.toml"),
                     written_case_mark + (": every default filled in\n" + write_case(c)));
    }

    void theory(const TheoryReport& report)
    {
        replace_file(directory_.file("theory.csv"), to_csv(report, case_.scaling));
    }
    void sample(const Sample& s) { series_.write(s); }
    /// Wall and fluid frames that are due now.
    void fields(const Simulation& simulation)
    {
        if (wall_due_.due(simulation.time(), simulation.dt())) wall(simulation);
        if (fluid_due_.due(simulation.time(), simulation.dt())) fluid(simulation);
    }
    /// Time of the next frame.
    Real next_frame() const { return std::min(wall_due_.next(), fluid_due_.next()); }
    void first_wall(const Simulation& simulation)
    {
        if (simulation.steps() != wall_step_) wall(simulation);
    }
    /// What is written once a run has ended.
    void finish(const Simulation& simulation)
    {
        write_profile(directory_.file("profile.csv"), simulation.profile(), case_.scaling);
        write_sections(directory_.file("sections.csv"), simulation.sections(), case_.scaling);
        if (simulation.steps() > wall_step_) wall(simulation);
        if (simulation.steps() > fluid_step_) fluid(simulation);
    }
    void summary(const Summary& s)
    {
        write_summary(directory_.file("summary.json"), s, case_.scaling);
    }

private:
    FieldFileOptions field_options() const
    {
        return {directory_.path(), case_.scaling,
                case_.output.double_precision ? hdf5::Precision::full : hdf5::Precision::single};
    }
    void wall(const Simulation& simulation)
    {
        if (!case_.output.wall) return;
        if (!wall_) wall_.emplace(field_options());
        wall_->write(simulation.wall_snapshot());
        wall_step_ = simulation.steps();
    }
    void fluid(const Simulation& simulation)
    {
        if (!case_.output.fluid) return;
        if (!fluid_) fluid_.emplace(field_options());
        fluid_->write(simulation.fluid_snapshot());
        fluid_step_ = simulation.steps();
    }

    const Case& case_;
    RunDirectory directory_;
    SeriesWriter series_;
    Schedule wall_due_, fluid_due_;
    std::optional<WallFile> wall_;
    std::optional<FluidFile> fluid_;
    Index wall_step_ = -1, fluid_step_ = -1; ///< steps of the last frames
};

/// The state of a run in progress.
class Run {
public:
    Run(const Case& c, const RunOptions& options, RunObserver& observer)
        : case_(c), observer_(observer), simulation_(c), files_(c, options), stop_(c),
          theory_(theory_of(c))
    {
    }

    Summary execute()
    {
        try {
            begin();
            while (!stop_.reason()) step();
            if (last_.step != simulation_.steps()) take_sample();
        } catch (const NumericalError& e) {
            end_broken_down(e);
            throw;
        }
        files_.finish(simulation_);
        Summary result = summary(*stop_.reason(), stop_.steady());
        files_.summary(result);
        return result;
    }

private:
    void begin()
    {
        if (theory_) files_.theory(*theory_);
        start_ = Clock::now();
        observer_.started({case_, simulation_});
        take_sample();
        files_.fields(simulation_);
        files_.first_wall(simulation_);
    }

    /// Leaves the results of the last sound state.
    void end_broken_down(const NumericalError& e)
    {
        simulation_.back_to_good();
        last_ = simulation_.sample();
        files_.finish(simulation_);
        files_.summary(summary(std::string("numerical error: ") + e.what(), false));
    }

    /// The next time that a step must end at.
    Real target() const
    {
        const Real end = case_.stop.end_time.value_or(std::numeric_limits<Real>::infinity());
        const Real frame = files_.next_frame();
        return frame < end - closest_targets * simulation_.dt() ? frame : end;
    }

    void step()
    {
        simulation_.step(target());
        if (simulation_.steps() % case_.output.sample_every == 0) take_sample();
        files_.fields(simulation_);
        stop_.check(moment());
        const TimeStepLimit& limiting = simulation_.limiting();
        observer_.stepped({simulation_.steps(), simulation_.time(), simulation_.dt(), limiting,
                           last_, seconds(), steps_per_second(), stop_.seconds_left(moment())});
        if (observer_.stop_requested()) stop_.interrupt();
    }

    void take_sample()
    {
        last_ = simulation_.sample();
        files_.sample(last_);
        stop_.add(last_);
    }

    Moment moment() const
    {
        return {simulation_.steps(), simulation_.time(), simulation_.dt(), seconds()};
    }
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    double steps_per_second() const { return static_cast<double>(simulation_.steps()) / seconds(); }

    Summary summary(const std::string& reason, bool converged) const
    {
        Summary s;
        s.title = case_.title;
        s.converged = converged;
        s.reason = reason;
        s.last = last_;
        s.spacing = simulation_.spacing();
        s.wall_seconds = seconds();
        s.cell_steps_per_second = steps_per_second() * static_cast<double>(simulation_.cells());
        s.threads = max_threads();
        s.peak_memory_bytes = peak_memory_bytes();
        s.cells = simulation_.cells();
        s.vertices = simulation_.vertices();
        s.elements = simulation_.elements();
        s.version = version();
        for (const PhaseTime& p : simulation_.phase_times())
            s.phase_seconds.emplace_back(p.name, p.seconds);
        if (theory_) s.theory = TheoryValues{theory_->tube.Q, theory_->tube.R_max};
        s.warnings = warnings(s);
        return s;
    }

    std::vector<std::string> warnings(const Summary& s) const
    {
        std::vector<std::string> found;
        if (std::abs(s.leak_over_Q()) > leak_to_warn_of)
            found.push_back("the leak through the wall is " + percent_text(s.leak_over_Q()) +
                            " of the flow: a finer grid lets less through");
        if (last_.smallest_gap < least_resolved_gap * s.spacing)
            found.push_back(fmt::format("opposite walls are {:.2g} grid spacings apart: the flow "
                                        "between them is not resolved below 2",
                                        last_.smallest_gap / s.spacing));
        if (s.theory && !s.converged)
            found.push_back("the run ended before it was found steady; the one-dimensional model "
                            "is steady");
        return found;
    }

    using Clock = std::chrono::steady_clock;

    const Case& case_;
    RunObserver& observer_;
    Simulation simulation_;
    RunFiles files_;
    StopCriteria stop_;
    std::optional<TheoryReport> theory_;
    Sample last_;
    Clock::time_point start_;
};

} // namespace

bool has_theory(const Case& c)
{
    const Real external = c.drive.pressure_external;
    const bool inflated = c.drive.pressure_inlet >= external && c.drive.pressure_outlet >= external;
    return c.tube.rigid || (inflated && c.fluid.reynolds <= largest_theory_reynolds);
}

Summary run(const Case& c, const RunOptions& options, RunObserver& observer)
{
    RunDirectory::check(
        {options.directory, options.force, options.case_file}); // before a set-up that takes long
    return Run(c, options, observer).execute();
}

} // namespace starling
