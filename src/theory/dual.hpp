#pragma once
/// A number with its derivatives with respect to two variables: exact Jacobians without formulas.
#include "core/types.hpp"

namespace starling {

struct Dual {
    Real value = 0, d1 = 0, d2 = 0;

    constexpr Dual() = default;
    constexpr Dual(Real v) : value(v) {}
    constexpr Dual(Real v, Real a, Real b) : value(v), d1(a), d2(b) {}

    /// The first and the second variable.
    static constexpr Dual first(Real v) { return {v, 1, 0}; }
    static constexpr Dual second(Real v) { return {v, 0, 1}; }
};

constexpr Dual operator-(const Dual& a) { return {-a.value, -a.d1, -a.d2}; }
constexpr Dual operator+(const Dual& a, const Dual& b)
{
    return {a.value + b.value, a.d1 + b.d1, a.d2 + b.d2};
}
constexpr Dual operator-(const Dual& a, const Dual& b) { return a + (-b); }
constexpr Dual operator*(const Dual& a, const Dual& b)
{
    return {a.value * b.value, a.d1 * b.value + a.value * b.d1, a.d2 * b.value + a.value * b.d2};
}
constexpr Dual operator/(const Dual& a, const Dual& b)
{
    const Real q = a.value / b.value;
    return {q, (a.d1 - q * b.d1) / b.value, (a.d2 - q * b.d2) / b.value};
}
inline Dual sqrt(const Dual& a)
{
    const Real r = std::sqrt(a.value);
    return {r, a.d1 / (2 * r), a.d2 / (2 * r)};
}

} // namespace starling
