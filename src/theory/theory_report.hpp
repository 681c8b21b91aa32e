#pragma once
/// Everything the theories say of a case, as `starling theory CASE.toml` prints it.
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "config/scaling.hpp"
#include "theory/laws_of_laplace.hpp"
#include "theory/one_dimensional.hpp"

namespace starling {

inline constexpr std::array radius_laws{RadiusLaw::laplace, RadiusLaw::anand_christov,
                                        RadiusLaw::second_order};

/// Predictions in the paper's units; NaN where a law has no value.
struct TheoryReport {
    TubeProblem problem;
    OneDimensionalTube tube;
    Real modulus = 0;                    ///< E'h of the laws
    Real Q_over_Q0 = 0;                  ///< of the one-dimensional model
    std::array<Real, 3> law_Q_over_Q0{}; ///< Eqs. (55)-(57) from x_R_max to the outlet clamp
    Real max_strain = 0;                 ///< largest |R - 1|
    Real max_slope = 0;                  ///< largest |dR/dx|: lubrication wants it small
    Real P_clamp_inlet = 0, P_clamp_outlet = 0;

    /// R(P) of a law at the model's transmural pressure at x; NaN in the rigid ends.
    Real law_radius(RadiusLaw law, Real x) const;
};

/// The law's name for people.
std::string_view law_name(ElasticLaw law);

/// Solves the one-dimensional model, with a marched profile beyond Re = 1, and evaluates the laws
/// at its pressures. Throws NumericalError as `solve_one_dimensional` and `solve_marched` do.
TheoryReport theory_report(const TubeProblem& problem);

/// A table for people, in the units of `scaling`.
std::string to_text(const TheoryReport& report, const Scaling& scaling);

/// The whole profile, columns x, R, P, R_laplace, R_anand_christov, R_second_order, each headed
/// "name [unit]", in the units of `scaling`; "nan" where a law has no value.
std::string to_csv(const TheoryReport& report, const Scaling& scaling);

} // namespace starling
