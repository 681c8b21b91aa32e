#pragma once
/// The machine's own bandwidth of memory, to hold the step against.
#include "bench/timing.hpp"
#include "core/array.hpp"

namespace starling::bench {

/// The in-place triad a <- a + s b: of every item it reads a and b and writes a, which is in the
/// cache already, so that 24 bytes move and no line is fetched only to be overwritten.
class Triad {
public:
    static constexpr double bytes_per_item = 3 * sizeof(Real);

    /// Two arrays of `size` items, which should be much larger than the caches.
    explicit Triad(Index size);

    /// Passes over both arrays, each timed, on so many threads.
    Timing run(int threads, int repeats);

private:
    Array<Real> a_, b_;
};

} // namespace starling::bench
