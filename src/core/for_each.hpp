#pragma once
/// The one loop over grid nodes, and its one-dimensional sister over wall items.
#include <omp.h>

#include "core/types.hpp"

namespace starling {

/// Half-open box of nodes: begin <= (i, j, k) < end.
struct Box {
    std::array<Index, 3> begin{};
    std::array<Index, 3> end{};
};

/// Calls f(i, j, k) for every node of the box: threads over (i, j), SIMD over k.
/// f must only write at (i, j, k) and must not read what another call writes.
/// `firstprivate` keeps the closure in registers: without it g++ does not vectorise.
template <class F>
void for_each(const Box& b, F f)
{
#pragma omp parallel for collapse(2) schedule(static) firstprivate(f)
    for (Index i = b.begin[0]; i < b.end[0]; ++i)
        for (Index j = b.begin[1]; j < b.end[1]; ++j) {
#pragma omp simd
            for (Index k = b.begin[2]; k < b.end[2]; ++k) f(i, j, k);
        }
}

/// Where part `part` of `parts` of a range of `count` items begins: at multiples of 16. A compiler
/// may round an item differently in a loop's vectorised body and in its rest; so every item is in
/// the same place for any number of threads.
constexpr Index part_begin(Index count, Index part, Index parts)
{
    return part == parts ? count : count * part / parts / 16 * 16;
}

/// Calls f(n) for n in [begin, end), many small items, split over threads in contiguous parts.
template <class F>
void for_range(Index begin, Index end, F f)
{
#pragma omp parallel firstprivate(f)
    {
        const Index part = omp_get_thread_num(), parts = omp_get_num_threads();
        const Index first = begin + part_begin(end - begin, part, parts);
        const Index last = begin + part_begin(end - begin, part + 1, parts);
        for (Index n = first; n < last; ++n) f(n);
    }
}

/// Calls f(i) for i in [begin, end), each a plane or a block of work of its own.
template <class F>
void for_planes(Index begin, Index end, F f)
{
#pragma omp parallel for schedule(static) firstprivate(f)
    for (Index i = begin; i < end; ++i) f(i);
}

/// Number of threads a parallel loop may use and the calling thread's number: scratch is per
/// thread.
inline int max_threads() { return omp_get_max_threads(); }
inline int thread_number() { return omp_get_thread_num(); }

} // namespace starling
