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

void ShearSums::add(std::span<const Vec3> shear)
{
    stress.resize(shear.size());
    magnitude.resize(shear.size());
    for (std::size_t v = 0; v < shear.size(); ++v) {
        stress[v] += shear[v];
        magnitude[v] += norm(shear[v]);
    }
}

void add_shear(const CycleMemory& cycles, WallSnapshot& wall)
{
    if (cycles.period == 0) return;
    const ShearSums& sums = cycles.shear_last;
    NamedArray tawss{"TAWSS", Quantity::shear_stress, 1, {}}, osi{"OSI", Quantity::none, 1, {}};
    tawss.values.resize(wall.points.size(), CycleMemory::nan);
    osi.values.resize(wall.points.size(), CycleMemory::nan);
    for (std::size_t v = 0; v < sums.stress.size(); ++v) {
        tawss.values[v] = sums.TAWSS(v, cycles.per_cycle);
        osi.values[v] = sums.OSI(v);
    }
    wall.at_vertex.push_back(std::move(tawss));
    wall.at_vertex.push_back(std::move(osi));
}

void add_shear(const CycleMemory& cycles, VertexIndex ring_size, std::vector<ProfileRow>& rows)
{
    const ShearSums& sums = cycles.shear_last;
    if (sums.empty()) return;
    const auto n = static_cast<std::size_t>(ring_size);
    for (std::size_t ring = 0; ring < rows.size(); ++ring) {
        rows[ring].TAWSS = rows[ring].OSI = 0;
        for (std::size_t v = ring * n; v < (ring + 1) * n; ++v) {
            rows[ring].TAWSS += sums.TAWSS(v, cycles.per_cycle) / ring_size;
            rows[ring].OSI += sums.OSI(v) / ring_size;
        }
    }
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
