#pragma once
/// What is known of the cycles of a drive with a period. All numbers in solver units.
#include <limits>
#include <span>

#include "solver/monitor_data.hpp"

namespace starling {

/// A number of a sample that is followed over cycles.
struct CycleQuantity {
    const char* name; ///< as in series.csv
    Quantity quantity;
    Real Sample::*member;
};

/// Flow rates, pressures at the ends, largest radius and volume, in this order.
std::span<const CycleQuantity> cycle_quantities();

/// What a run remembers of its cycles; part of a checkpoint. Cycle n reaches from n to n + 1
/// periods; its samples are taken at the ends of `per_cycle` equal parts of it.
struct CycleMemory {
    Real period = 0;          ///< (R_0/U_c); 0: cycles are not followed
    Index per_cycle = 0;      ///< samples of a cycle
    Index next = 0;           ///< the next sample is taken at next * period/per_cycle
    Index cycles = 0;         ///< that are complete
    Real change = nan;        ///< from the cycle before the last one to the last; NaN: none yet
    Real change_before = nan; ///< the change one cycle earlier
    std::vector<Sample> last, current; ///< samples of the last complete cycle, of the one under way

    static constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
};

/// The largest difference between samples of two cycles at the same part of the cycle, in flow
/// rate, pressure, radius and volume, each over its scale: the range over the cycle `b`, of flow
/// rates and of pressures the widest, but at least a thousandth of the largest size in it.
Real cycle_change(std::span<const Sample> a, std::span<const Sample> b);

/// A number over a cycle.
struct CycleValues {
    Real mean = 0, min = 0, max = 0;
    Real amplitude() const { return (max - min) / 2; }
};

/// Over the samples, one at least.
CycleValues values_over(std::span<const Sample> cycle, Real Sample::*member);

} // namespace starling
