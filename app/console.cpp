#include "console.hpp"

#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "environment.hpp"

namespace starling::app {

namespace {

using namespace std::chrono_literals;

constexpr const char* clear_to_end_of_line = "\x1b[K";

/// Columns of the terminal, less one so that no line wraps.
std::size_t terminal_width()
{
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 20) return 79;
    return size.ws_col - 1u;
}

/// "0:45", "11:50" or "2h05" for lines that must be short.
std::string clock_text(double seconds)
{
    if (!std::isfinite(seconds)) return "?";
    const auto whole = std::llround(seconds);
    if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}h{:02}", whole / 3600, whole % 3600 / 60);
}

Real leak_percent(const Sample& s)
{
    const Real leak = leak_over_Q(s);
    return std::isfinite(leak) ? 100 * leak : 0;
}

/// How many cycles are complete, and by how much the last one differs from the one before.
std::string cycle_text(const CycleMemory& m)
{
    if (m.cycles == 0) return "";
    const std::string change = std::isfinite(m.change) ? fmt::format("{:.2g}", m.change) : "?";
    return fmt::format("  cycle {} change {}", m.cycles, change);
}

} // namespace

void QuietObserver::retrying(const Retry& retry)
{
    fmt::print(stderr, "{}\ntrying again from step {} with {:.3g} of the automatic step\n",
               retry.reason, retry.step, retry.step_factor);
}

void QuietObserver::warn(const std::string& what) { fmt::print(stderr, "warning: {}\n", what); }

bool QuietObserver::stop_requested() { return stop_signal_seen(); }

ConsoleObserver::ConsoleObserver()
    : terminal_(isatty(STDOUT_FILENO) != 0),
      pause_(terminal_ ? Clock::duration(200ms) : Clock::duration(10s)),
      next_(Clock::now() + pause_)
{
}

void ConsoleObserver::started(const RunStart& start)
{
    const Case& c = start.description;
    scaling_ = c.scaling;
    fixed_step_ = c.time.step.has_value();
    fmt::print("{}: {} cells, {} vertices, {} triangles; numbers in {}\n",
               c.title.empty() ? "run" : c.title, start.simulation.cells(),
               start.simulation.vertices(), start.simulation.elements(),
               scaling_.si ? "SI units" : "units of R_0, U_c and rho");
    if (start.simulation.steps() > 0)
        fmt::print("Going on from step {}, t = {:.6g} {}\n", start.simulation.steps(),
                   start.simulation.time() * scaling_.factor(Quantity::time),
                   scaling_.unit(Quantity::time));
    std::fflush(stdout);
}

void ConsoleObserver::stepped(const Progress& progress)
{
    const auto now = Clock::now();
    if (now < next_) return;
    next_ = now + pause_;
    const std::string limit = fixed_step_ ? "fixed" : progress.limiting.name;
    std::string line = progress_line(progress, limit, scaling_);
    if (terminal_) {
        const std::size_t width = terminal_width();
        if (line.size() > width) line = short_progress_line(progress, limit, scaling_);
        line.resize(std::min(line.size(), width));
        fmt::print("\r{}{}", line, clear_to_end_of_line);
        live_ = true;
    } else {
        fmt::print("{}\n", line);
    }
    std::fflush(stdout);
}

void ConsoleObserver::retrying(const Retry& retry)
{
    finished();
    QuietObserver::retrying(retry);
}

void ConsoleObserver::warn(const std::string& what)
{
    finished();
    QuietObserver::warn(what);
}

bool ConsoleObserver::stop_requested()
{
    if (!stop_signal_seen()) return false;
    if (!stopping_) {
        finished();
        fmt::print("stopping: writing results\n");
        std::fflush(stdout);
    }
    return stopping_ = true;
}

void ConsoleObserver::finished()
{
    if (live_) fmt::print("\n");
    std::fflush(stdout);
    live_ = false;
}

std::string progress_line(const Progress& p, const std::string& limit, const Scaling& scaling)
{
    const Sample& s = p.last;
    const Real time = scaling.factor(Quantity::time), flow = scaling.factor(Quantity::flow_rate);
    return fmt::format("step {}  t {:.4g}  dt {:.3g} ({})  CFL {:.2f}  Q {:.4g} > {:.4g}  "
                       "leak {:.2f} %  displacement {:.3g}{}  {:.1f} steps/s  {} left",
                       p.step, p.t * time, p.dt * time, limit, s.cfl, s.Q_in * flow, s.Q_out * flow,
                       leak_percent(s), s.largest_displacement * scaling.factor(Quantity::length),
                       cycle_text(p.cycles), p.steps_per_second, duration_text(p.seconds_left));
}

std::string short_progress_line(const Progress& p, const std::string& limit, const Scaling& scaling)
{
    const Sample& s = p.last;
    const Real time = scaling.factor(Quantity::time), flow = scaling.factor(Quantity::flow_rate);
    return fmt::format(
        "{} t {:.4g} dt {:.2g} {} CFL {:.2f} Q {:.3g}>{:.3g} leak {:.1f}% d {:.2g}{} "
        "{:.0f}/s {}",
        p.step, p.t * time, p.dt * time, limit.substr(0, limit.find(' ')), s.cfl, s.Q_in * flow,
        s.Q_out * flow, leak_percent(s), s.largest_displacement * scaling.factor(Quantity::length),
        cycle_text(p.cycles).substr(0, 9), p.steps_per_second, clock_text(p.seconds_left));
}

std::string duration_text(double seconds)
{
    if (!std::isfinite(seconds)) return "?";
    if (seconds < 10) return fmt::format("{:.2g} s", seconds);
    const auto whole = std::llround(seconds);
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

} // namespace starling::app
