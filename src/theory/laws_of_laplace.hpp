#pragma once
/// The pressure-radius laws of sec. 3.1.2 and their flow rates. All take the transmural pressure in
/// units of E'h (`effective_modulus`), P_bar = P/(E'h), and give the radius in units of R_0.
#include "core/types.hpp"

namespace starling {

enum class RadiusLaw {
    laplace,        ///< Eq. (45): small strain, load on the deformed radius
    anand_christov, ///< Eq. (46): small strain, load on the undeformed radius
    second_order    ///< Eq. (52): full circumferential Green strain
};

/// R(P_bar). NaN where the law has no tube: `laplace` for P_bar >= 1 (it diverges there) and
/// `anand_christov` for P_bar <= -1 (no radius left); `second_order` holds everywhere.
Real radius(RadiusLaw law, Real P_bar);

/// A stretch of tube between two sections, and the fluid in it.
struct TubeStretch {
    Real P_bar_upstream, P_bar_downstream; ///< transmural pressures over E'h
    Real length;
    Real modulus; ///< E'h
    Real reynolds;
};

/// Q that obeys Eq. (54) with R(P) of the law: Eqs. (55), (56), (57). NaN where `radius` is at
/// either end.
Real flow_rate(RadiusLaw law, const TubeStretch& stretch);

} // namespace starling
