#pragma once
/// Times of repeats of the same work.
#include <algorithm>
#include <vector>

#include "core/types.hpp"

namespace starling::bench {

/// Seconds of every repeat, in the order in which they were taken; at least one.
struct Timing {
    std::vector<double> seconds;

    double least() const { return *std::min_element(seconds.begin(), seconds.end()); }
    /// Of an even number the lower of the two in the middle.
    double median() const
    {
        std::vector<double> sorted = seconds;
        const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        return *middle;
    }
};

} // namespace starling::bench
