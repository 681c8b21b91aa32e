/// Counts allocations: this test replaces malloc and its kin for the whole executable, so it has
/// one of its own and is not built with sanitizers, which replace them too.
#include <gtest/gtest.h>

#include <dlfcn.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstring>

#include "unit/solver/coupled.hpp"

namespace {

std::atomic<long> allocations{0};

/// Counts unless the caller is a library that allocates and frees in its own calls: OpenMP (a team
/// of one thread).
void count(void* caller)
{
    Dl_info info;
    const bool known = dladdr(caller, &info) != 0 && info.dli_fname != nullptr;
    if (known && std::strstr(info.dli_fname, "libgomp")) return;
    ++allocations;
}

} // namespace

// glibc's own, which every allocation function passes on to (operator new calls malloc).
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* p, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size)
{
    count(__builtin_return_address(0));
    return __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t size)
{
    count(__builtin_return_address(0));
    return __libc_calloc(n, size);
}
void* realloc(void* p, std::size_t size)
{
    count(__builtin_return_address(0));
    return __libc_realloc(p, size);
}
void* memalign(std::size_t alignment, std::size_t size)
{
    count(__builtin_return_address(0));
    return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size)
{
    count(__builtin_return_address(0));
    return __libc_memalign(alignment, size);
}
int posix_memalign(void** p, std::size_t alignment, std::size_t size)
{
    count(__builtin_return_address(0));
    *p = __libc_memalign(alignment, size);
    return *p ? 0 : ENOMEM;
}
}

namespace starling {
namespace {

using support::Coupled;

TEST(Allocations, AreCounted)
{
    const long before = allocations;
    const std::vector<int> v(1000);
    const Array<Real> a(10);
    EXPECT_EQ(allocations - before, 2) << v.size() + static_cast<std::size_t>(a.size());
}

struct Advance : testing::TestWithParam<std::tuple<CouplingScheme, int>> {};

TEST_P(Advance, AllocatesNothing)
{
    const auto [scheme, threads] = GetParam();
    const int threads_before = omp_get_max_threads();
    omp_set_num_threads(threads);
    support::CoupledParameters p{.scheme = scheme,
                                 .E_b = 2,
                                 .contact = {.pressure = 1, .range = 1},
                                 .tissue = {.stiffness = 1, .damping = 0.1},
                                 .mu_s = 0.05,
                                 .spacing = 0.25};
    p.tube.smoothing = 1e-4;
    Coupled c(p);
    ASSERT_TRUE(c.run(1)); // threads start
    const Real R_before = norm(c.s.wall.x[c.tube.first(c.tube.rings() / 2)]);
    const Index ghosts_before = c.op.coupling.ghosts(Location::u).count();
    const long before = allocations;
    const bool done = c.run(25);
    const long during = allocations - before;
    omp_set_num_threads(threads_before);
    EXPECT_TRUE(done);
    EXPECT_EQ(during, 0);
    // the wall has passed nodes
    EXPECT_NE(c.op.coupling.ghosts(Location::u).count(), ghosts_before);
    EXPECT_GT(norm(c.s.wall.x[c.tube.first(c.tube.rings() / 2)]) - R_before, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Solver, Advance,
                         testing::Combine(testing::Values(CouplingScheme::printed,
                                                          CouplingScheme::reaction,
                                                          CouplingScheme::conserving),
                                          testing::Values(1, 2)));

} // namespace
} // namespace starling
