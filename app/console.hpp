#pragma once
/// Progress of a run on standard output.
#include <chrono>
#include <string>

#include "simulation/run.hpp"

namespace starling::app {

/// Prints only what must not be missed, to standard error; listens to signals.
class QuietObserver : public RunObserver {
public:
    void retrying(const Retry& retry) override;
    void warn(const std::string& what) override;
    bool stop_requested() override;
};

/// One live line on a terminal, a plain line every ten seconds elsewhere.
class ConsoleObserver : public QuietObserver {
public:
    ConsoleObserver();
    void started(const RunStart& start) override;
    void stepped(const Progress& progress) override;
    void retrying(const Retry& retry) override;
    void warn(const std::string& what) override;
    bool stop_requested() override;
    /// Ends the live line; to be called before anything else is printed.
    void finished();

private:
    using Clock = std::chrono::steady_clock;

    bool terminal_;
    bool live_ = false; ///< a live line stands on the screen
    bool stopping_ = false;
    Clock::duration pause_;
    Clock::time_point next_;
    Scaling scaling_;
    bool fixed_step_ = false; ///< the case gives dt; no limit sets it
};

/// The progress line: step, t, dt and the `limit` that sets it, CFL, flow in and out, leak,
/// displacement, cycles of the drive, speed, time left; numbers in the case's units.
std::string progress_line(const Progress& progress, const std::string& limit,
                          const Scaling& scaling);

/// The same in about 80 columns.
std::string short_progress_line(const Progress& progress, const std::string& limit,
                                const Scaling& scaling);

/// "45 s", "3 min 20 s" or "2 h 05 min"; "?" for NaN.
std::string duration_text(double seconds);

} // namespace starling::app
