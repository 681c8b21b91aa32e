#pragma once
/// A property of the wall that varies along the tube.
#include <algorithm>
#include <vector>

#include "core/types.hpp"

namespace starling {

/// A factor on a property as a function of x (R_0): a named shape, or a table joined by straight
/// lines that holds its first value before and its last after it. 1 everywhere by default.
struct AlongX {
    enum class Shape {
        uniform,
        bump, ///< 1 + change (1 + cos(2 pi (x - position)/length))/2 within half a length
        step, ///< from 1 to 1 + change, over `length` about `position` along a cosine
        table
    };
    Shape shape = Shape::uniform;
    Real position = 0, length = 0, change = 0; ///< of a bump or step
    std::vector<Real> x = {}, values = {};     ///< of a table, x increasing

    bool uniform() const { return shape == Shape::uniform; }

    /// The factor at a position.
    Real operator()(Real at) const
    {
        const Real s = at - position;
        switch (shape) {
        case Shape::uniform: return 1;
        case Shape::bump:
            if (std::abs(s) >= length / 2) return 1;
            return 1 + change * (1 + std::cos(2 * pi * s / length)) / 2;
        case Shape::step:
            if (s <= -length / 2) return 1;
            if (s >= length / 2) return 1 + change;
            return 1 + change * (1 + std::sin(pi * s / length)) / 2;
        case Shape::table: return between_rows(at);
        }
        return 1;
    }
    /// The smallest and the largest factor anywhere.
    Real lowest() const { return shape == Shape::table ? least() : std::min(Real{1}, 1 + change); }
    Real highest() const { return shape == Shape::table ? most() : std::max(Real{1}, 1 + change); }

private:
    Real least() const { return *std::min_element(values.begin(), values.end()); }
    Real most() const { return *std::max_element(values.begin(), values.end()); }
    Real between_rows(Real at) const
    {
        const auto right = std::upper_bound(x.begin(), x.end(), at);
        if (right == x.begin()) return values.front();
        if (right == x.end()) return values.back();
        const auto n = static_cast<std::size_t>(right - x.begin());
        const Real share = (at - x[n - 1]) / (x[n] - x[n - 1]);
        return (1 - share) * values[n - 1] + share * values[n];
    }
};

} // namespace starling
