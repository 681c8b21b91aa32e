#pragma once
/// What linear theory and the elastic ring say of the collapse of a case's tube.
#include <optional>
#include <string>
#include <vector>

#include "config/scaling.hpp"
#include "theory/buckling.hpp"
#include "theory/tube_problem.hpp"

namespace starling {

/// Loads that buckle the tube into n lobes; pressures are external minus internal.
struct BucklingLoad {
    int n = 2;
    Real ring = 0;    ///< ring of the same bending modulus
    Real at_rest = 0; ///< pinned tube, uniform pressure, linearised about the undeformed wall
    Real tube = 0;    ///< the same about the compressed wall; NaN if none
    Real factor = 0;  ///< of the case's own pressures; NaN if they compress nowhere
};

/// In the paper's units.
struct BucklingReport {
    Real E_b = 0;
    Real length = 0;                 ///< of the deforming part
    TransmuralPressure pressure;     ///< at the clamps, Poiseuille flow in the undeformed tube
    std::vector<BucklingLoad> loads; ///< n = 2 to 8 at least, and beyond the predicted modes
    std::optional<BucklingLoad> under_uniform_pressure; ///< the one with the smallest `tube`
    std::optional<BucklingLoad> under_own_pressure;     ///< the one with the smallest `factor`

    /// Whether the case's pressures suffice, by linear theory.
    bool buckles() const { return under_own_pressure && under_own_pressure->factor < 1; }
};

/// Nothing for a rigid tube, for a wall that does not resist bending, whose load falls with n
/// without end, or for one with tissue around (support.stiffness), whose load is not known.
std::optional<BucklingReport> buckling_report(const TubeProblem& problem);

/// Loads, predicted modes and the tube law of the ring, for people, in the units of `scaling`.
std::string to_text(const BucklingReport& report, const Scaling& scaling);

/// The loads: columns n, p_ring, p_at_rest, p_tube, load_factor, each headed "name [unit]"; "nan"
/// where there is none.
std::string to_csv(const BucklingReport& report, const Scaling& scaling);

/// The ring from the circle to contact for n = 2, 3 and 4: columns n, p, area_ratio, tip_distance,
/// waist_distance, gap, each headed "name [unit]".
std::string tube_law_csv(const BucklingReport& report, const Scaling& scaling);

} // namespace starling
