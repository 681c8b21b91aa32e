#pragma once
/// What may go wrong with a case, told before it runs (`starling check`).
#include <optional>
#include <string>
#include <vector>

#include "simulation/estimate.hpp"
#include "theory/one_dimensional.hpp"

namespace starling {

/// The steady tube by the one-dimensional model: at any Re, so that beyond Re = 1 it is a guide
/// only.
struct Prediction {
    std::optional<OneDimensionalTube> tube; ///< empty: may collapse, or has no steady state
    std::string failure;                    ///< what the model says where it finds none
};

Prediction predict(const Case& c);

/// Largest speed on the axis, where the tube is narrowest: of the prediction, or else as through
/// the undeformed tube.
Real expected_speed(const Case& c, const Prediction& prediction);

/// A sentence for each thing to worry about, with its reason and a remedy, numbers in the case's
/// units; of `e`, all but the warnings is used.
std::vector<std::string> forewarnings(const Case& c, const Prediction& prediction,
                                      const RunEstimate& e);

} // namespace starling
