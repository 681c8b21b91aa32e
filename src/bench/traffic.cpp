#include "bench/traffic.hpp"

#include "core/types.hpp"

namespace starling::bench {

const std::vector<KernelTraffic>& separate_kernels()
{
    static const std::vector<KernelTraffic> kernels = {
        {"explicit terms", 10, 6},        // u, v, w, P, 3 N, 3 F; 3 right-hand sides, 3 N
        {"lines along z", 3, 3},          //
        {"lines along y", 3, 3},          //
        {"lines along x and sum", 6, 3},  // 3 increments, u, v, w; u, v, w
        {"divergence", 3, 1},             //
        {"transforms forward", 2, 2},     // along z, along y
        {"tridiagonals along x", 1, 1},   //
        {"transforms backward", 2, 2},    // along y, along z
        {"correction of velocity", 4, 3}, // u, v, w, phi; u, v, w
        {"pressure", 2, 1},               // P, phi; P
    };
    return kernels;
}

double bytes_per_cell_step()
{
    int passes = 0;
    for (const KernelTraffic& k : separate_kernels()) passes += k.reads + k.writes;
    return passes * static_cast<double>(sizeof(Real));
}

} // namespace starling::bench
