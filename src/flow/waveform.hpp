#pragma once
/// Values that change in time: what is added to a steady pressure or flow rate.
#include <algorithm>
#include <vector>

#include "core/types.hpp"

namespace starling {

/// amplitude times a shape of time: a Fourier series
/// sum_n cosine[n-1] cos(2 pi n t/period) + sine[n-1] sin(2 pi n t/period), or a table of `values`
/// at increasing `times`, joined by straight lines. A table with a period repeats, and its first
/// value follows its last; one without holds its first value before and its last after it.
struct Waveform {
    Real amplitude = 0; ///< in the unit of the result; 0: none
    Real period = 0;    ///< (R_0/U_c); 0: does not repeat
    std::vector<Real> cosine = {}, sine = {};
    std::vector<Real> times = {}; ///< (R_0/U_c), from 0 to the period where there is one
    std::vector<Real> values = {};

    bool none() const { return amplitude == 0; }
    /// The value at t >= 0.
    Real operator()(Real t) const;
    /// The mean over a period; without one the value that the table ends with.
    Real level() const;
    /// The smallest and the largest value: of a series on a grid of 64 points per harmonic.
    Real lowest() const;
    Real highest() const;
    /// A time step that follows it: 50 to the shortest harmonic, or to a table and two to a row;
    /// infinite for none.
    Real resolution() const;

private:
    Real series(Real t) const;
    Real table(Real t) const;
    std::size_t harmonics() const { return std::max(cosine.size(), sine.size()); }
    /// The values between which all others lie, in `amplitude`.
    std::vector<Real> extremes() const;
};

} // namespace starling
