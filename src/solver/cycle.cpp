#include "solver/cycle.hpp"

#include <algorithm>
#include <cmath>

namespace starling {

namespace {

constexpr Real least_range = 1e-3; ///< of the largest size; changes in less count over this

} // namespace

std::span<const CycleQuantity> cycle_quantities()
{
    using enum Quantity;
    static const CycleQuantity quantities[] = {
        {"Q_in", flow_rate, &Sample::Q_in},   {"Q_mid", flow_rate, &Sample::Q_mid},
        {"Q_out", flow_rate, &Sample::Q_out}, {"P_in", pressure, &Sample::P_in},
        {"P_out", pressure, &Sample::P_out},  {"R_max", length, &Sample::R_max},
        {"volume", volume, &Sample::volume},
    };
    return quantities;
}

CycleValues values_over(std::span<const Sample> cycle, Real Sample::*member)
{
    CycleValues v{0, cycle.front().*member, cycle.front().*member};
    for (const Sample& s : cycle) {
        v.mean += s.*member / static_cast<Real>(cycle.size());
        v.min = std::min(v.min, s.*member);
        v.max = std::max(v.max, s.*member);
    }
    return v;
}

Real cycle_change(std::span<const Sample> a, std::span<const Sample> b)
{
    Real largest = 0;
    for (const CycleQuantity& q : cycle_quantities()) {
        Real scale = 0;
        for (const CycleQuantity& like : cycle_quantities()) {
            if (like.quantity != q.quantity) continue;
            const CycleValues v = values_over(b, like.member);
            const Real size = std::max(std::abs(v.min), std::abs(v.max));
            scale = std::max({scale, v.max - v.min, least_range * size});
        }
        Real difference = 0;
        for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n)
            difference = std::max(difference, std::abs(a[n].*q.member - b[n].*q.member));
        if (difference > 0) largest = std::max(largest, difference / scale);
    }
    return largest;
}

} // namespace starling
