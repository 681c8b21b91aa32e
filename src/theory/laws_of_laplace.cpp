#include "theory/laws_of_laplace.hpp"

#include <limits>

namespace starling {

namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

/// Integral of R^4 over P_bar, written in R: with d P_bar = dR/R^2, dR and (1 + 1/R^2)/2 dR.
Real integral_of_R4(RadiusLaw law, Real R)
{
    const Real R3 = R * R * R, R5 = R3 * R * R;
    switch (law) {
    case RadiusLaw::laplace: return R3 / 3;
    case RadiusLaw::anand_christov: return R5 / 5;
    case RadiusLaw::second_order: return (R3 / 3 + R5 / 5) / 2;
    }
    return nan;
}

} // namespace

Real radius(RadiusLaw law, Real P_bar)
{
    switch (law) {
    case RadiusLaw::laplace: return P_bar < 1 ? 1 / (1 - P_bar) : nan;         // Eq. (45)
    case RadiusLaw::anand_christov: return P_bar > -1 ? 1 + P_bar : nan;       // Eq. (46)
    case RadiusLaw::second_order: return P_bar + std::sqrt(1 + P_bar * P_bar); // Eq. (52)
    }
    return nan;
}

Real flow_rate(RadiusLaw law, const TubeStretch& s)
{
    // Eqs. (55)-(57): Q length = (pi Re/8) E'h times the integral of R^4 dP_bar
    return pi * s.reynolds * s.modulus / (8 * s.length) *
           (integral_of_R4(law, radius(law, s.P_bar_upstream)) -
            integral_of_R4(law, radius(law, s.P_bar_downstream)));
}

} // namespace starling
