#pragma once
/// One-dimensional regularised delta functions on four neighbouring nodes.
#include "core/types.hpp"

namespace starling {

/// Weights of the four nodes first .. first + 3; they sum to one.
struct Stencil4 {
    std::int32_t first = 0;
    std::array<Real, 4> weight{};

    /// Weight of any node.
    constexpr Real at(Index node) const
    {
        return node < first || node > first + 3 ? 0
                                                : weight[static_cast<std::size_t>(node - first)];
    }
};

enum class Kernel {
    cosine,            ///< Peskin's, Eq. (27) with h-bar = 2 Delta
    quadratic_bspline, ///< order 3: the three nearest nodes, the fourth weight is zero
    cubic_bspline,     ///< order 4; its derivative is the difference of two of order 3
};

/// Number of nodes that can have weight: the first so many of a stencil.
constexpr std::size_t node_count(Kernel kernel)
{
    return kernel == Kernel::quadratic_bspline ? 3 : 4;
}

/// Weights at coordinate s, in spacings from node 0. s must be finite and fit an int.
inline Stencil4 delta_weights(Kernel kernel, Real s)
{
    const Real floor = std::floor(s), t = s - floor; // t in [0, 1) from the second node
    Stencil4 stencil{static_cast<std::int32_t>(floor) - 1, {}};
    auto& w = stencil.weight;
    switch (kernel) {
    case Kernel::cosine: {
        const Real c = std::cos(pi / 2 * t), d = std::sin(pi / 2 * t);
        w = {(1 - d) / 4, (1 + c) / 4, (1 + d) / 4, (1 - c) / 4};
        break;
    }
    case Kernel::quadratic_bspline: {
        const bool nearer_to_next = t >= 0.5;
        const Real r = nearer_to_next ? t - 1 : t; // from the node nearest
        stencil.first += nearer_to_next;
        w = {0.5 * (0.5 - r) * (0.5 - r), 0.75 - r * r, 0.5 * (0.5 + r) * (0.5 + r), 0};
        break;
    }
    case Kernel::cubic_bspline: {
        const Real r = 1 - t;
        w = {r * r * r / 6, 2. / 3 - t * t * (1 - t / 2), 2. / 3 - r * r * (1 - r / 2),
             t * t * t / 6};
        break;
    }
    }
    return stencil;
}

/// The kernels of a transfer: along a component's own direction and across it. A pair of
/// B-splines of orders 4 and 3 makes the interpolated velocity divergence-free.
struct KernelPair {
    Kernel along = Kernel::cosine;
    Kernel across = Kernel::cosine;
    Real sharpening = 0; ///< half the second moment taken off both, in squared spacings

    /// Half width along x, in spacings.
    Real reach() const { return sharpening > 0 ? 3 : 2; }
};

/// Composite B-splines, sharpened: docs/numerics.md, "Kernels".
inline constexpr KernelPair composite_bsplines{Kernel::cubic_bspline, Kernel::quadratic_bspline,
                                               1.0 / 8};

} // namespace starling
