#include "bench/bandwidth.hpp"

#include <chrono>

#include "core/for_each.hpp"

namespace starling::bench {

namespace {

void pass(Array<Real>& a_array, const Array<Real>& b_array, Real s)
{
    Real* a = a_array.data();
    const Real* b = b_array.data();
    for_range(0, a_array.size(), [=](Index n) { a[n] += s * b[n]; });
}

} // namespace

Triad::Triad(Index size) : a_(size), b_(size) { b_.fill(1); }

Timing Triad::run(int threads, int repeats)
{
    using Clock = std::chrono::steady_clock;
    const int threads_before = max_threads();
    omp_set_num_threads(threads);
    pass(a_, b_, 0); // threads start
    Timing timing;
    for (int n = 0; n < repeats; ++n) {
        const auto start = Clock::now();
        pass(a_, b_, 1e-9);
        timing.seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    }
    omp_set_num_threads(threads_before);
    return timing;
}

} // namespace starling::bench
