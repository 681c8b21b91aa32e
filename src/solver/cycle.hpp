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

/// The wall shear stress at each vertex, summed over samples (rho U_c^2).
struct ShearSums {
    std::vector<Vec3> stress;
    std::vector<Real> magnitude;

    /// Empty sums are none yet.
    void add(std::span<const Vec3> shear);
    bool empty() const { return stress.empty(); }
    /// Time-averaged wall shear stress at a vertex, the mean magnitude over so many samples.
    Real TAWSS(std::size_t vertex, Index samples) const
    {
        return magnitude[vertex] / static_cast<Real>(samples);
    }
    /// Oscillatory shear index (1 - |mean stress|/mean |stress|)/2 at a vertex: 0 where the stress
    /// keeps its direction, 1/2 where its mean vanishes; NaN where there is no stress.
    Real OSI(std::size_t vertex) const
    {
        return (1 - norm(stress[vertex]) / magnitude[vertex]) / 2;
    }
};

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
    ShearSums shear_last, shear_current; ///< over those samples

    static constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
};

/// Adds the arrays "TAWSS" and "OSI" of the last complete cycle at the vertices, NaN before there
/// is one; none where cycles are not followed.
void add_shear(const CycleMemory& cycles, WallSnapshot& wall);
/// Sets TAWSS and OSI of rows that stand for rings of `ring_size` vertices each.
void add_shear(const CycleMemory& cycles, VertexIndex ring_size, std::vector<ProfileRow>& rows);

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
