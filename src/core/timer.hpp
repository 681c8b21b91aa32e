#pragma once
/// Seconds per named phase.
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace starling {

/// Accumulates wall time in phases; `mark(p)` charges the time since the last mark to phase p.
class PhaseTimer {
public:
    explicit PhaseTimer(std::vector<std::string> names)
        : names_(std::move(names)), seconds_(names_.size(), 0.0), last_(Clock::now())
    {
    }

    void start() { last_ = Clock::now(); }
    void mark(std::size_t phase)
    {
        const auto now = Clock::now();
        seconds_[phase] += std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }
    const std::vector<std::string>& names() const { return names_; }
    const std::vector<double>& seconds() const { return seconds_; }

private:
    using Clock = std::chrono::steady_clock;
    std::vector<std::string> names_;
    std::vector<double> seconds_;
    Clock::time_point last_;
};

} // namespace starling
