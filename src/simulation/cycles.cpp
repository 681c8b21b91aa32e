#include "simulation/cycles.hpp"

#include <cmath>
#include <utility>

#include "simulation/time_step.hpp"

namespace starling {

namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real round_off = 1e-9; ///< of a period

} // namespace

Real first_cycle(const Case& c, Real t)
{
    const Real period = c.drive.period();
    if (period == 0) return infinity;
    return period * std::ceil(std::max(t, c.drive.ramp) / period - round_off);
}

Cycles::Cycles(const Case& c) : case_(&c) { begin(0); }

void Cycles::begin(Real t)
{
    memory_ = {};
    const Real period = case_->drive.period();
    if (period == 0 || case_->time.cycle_samples == 0) return;
    memory_.period = period;
    memory_.per_cycle = case_->time.cycle_samples;
    memory_.next = std::llround(first_cycle(*case_, t) / period) * memory_.per_cycle + 1;
}

void Cycles::go_on_from(const CycleMemory& memory, Real t)
{
    begin(t);
    const bool same = memory.period == memory_.period && memory.per_cycle == memory_.per_cycle;
    if (same) memory_ = memory;
}

Real Cycles::next() const
{
    if (memory_.period == 0) return infinity;
    return static_cast<Real>(memory_.next) * memory_.period / static_cast<Real>(memory_.per_cycle);
}

bool Cycles::due(Real t, Real dt) const { return t >= next() - closest_targets * dt; }

bool Cycles::add(const Sample& sample, std::span<const Vec3> shear)
{
    CycleMemory& m = memory_;
    ++m.next;
    m.current.push_back(sample);
    m.shear_current.add(shear);
    if (static_cast<Index>(m.current.size()) < m.per_cycle) return false;
    m.change_before = m.change;
    if (m.cycles > 0) m.change = cycle_change(m.last, m.current);
    m.last = std::exchange(m.current, {});
    m.shear_last = std::exchange(m.shear_current, {});
    ++m.cycles;
    return true;
}

Real Cycles::time_to(Real tolerance) const
{
    const CycleMemory& m = memory_;
    if (!(m.change < m.change_before)) return CycleMemory::nan;
    const Real cycles = std::log(m.change / tolerance) / std::log(m.change_before / m.change);
    return m.period * std::max(std::ceil(cycles), Real{0});
}

} // namespace starling
