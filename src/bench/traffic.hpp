#pragma once
/// How much memory a step would move if each of its kernels ran on its own.
#include <vector>

namespace starling::bench {

/// A kernel of the fluid's step and the arrays of one value per cell that it must read or write.
struct KernelTraffic {
    const char* name;
    int reads, writes;
};

/// The kernels as separate passes over arrays larger than the caches. An array counts once where a
/// kernel reads it and once where it writes it, however often its stencil touches a value; one that
/// is written without being read counts once, though the machine may fetch it first; lines along x
/// stay in cache between their two sweeps. Halos and the ends of the box count nothing.
const std::vector<KernelTraffic>& separate_kernels();

/// Bytes per cell and step that these move. A step that fuses kernels moves less, so it may come to
/// more than the whole of the bound that follows.
double bytes_per_cell_step();

} // namespace starling::bench
