#pragma once
/// Equality of cases, to the bit.
#include <bit>
#include <cstdint>
#include <vector>

#include "config/case.hpp"

namespace starling::test {

/// Every number of a case as bits; an absent optional is a value of its own.
inline std::vector<std::uint64_t> bits(const Case& c)
{
    std::vector<std::uint64_t> out;
    const auto real = [&](Real x) { out.push_back(std::bit_cast<std::uint64_t>(x)); };
    const auto integer = [&](auto n) { out.push_back(static_cast<std::uint64_t>(n)); };
    const auto maybe = [&](const auto& x) {
        integer(x.has_value());
        if (x) real(static_cast<Real>(*x));
    };
    for (Real x : {c.grid.width_y,
                   c.grid.width_z,
                   c.grid.spacing,
                   c.grid.tube_offset_y,
                   c.grid.tube_offset_z,
                   c.fluid.reynolds,
                   c.fluid.theta,
                   c.drive.pressure_inlet,
                   c.drive.pressure_outlet,
                   c.drive.pressure_external,
                   c.tube.length,
                   c.tube.rigid_inlet,
                   c.tube.rigid_outlet,
                   c.tube.edge_over_spacing,
                   c.material.eps,
                   c.material.poisson_ratio,
                   c.material.psi,
                   c.material.skalak_C,
                   c.material.bending,
                   c.material.contact,
                   c.tube.smoothing,
                   c.perturbation.amplitude,
                   c.tube.mesh_filter,
                   c.time.safety,
                   c.scaling.length,
                   c.scaling.velocity,
                   c.scaling.density,
                   c.checkpoint.every,
                   c.material.support.stiffness,
                   c.material.support.damping,
                   c.material.viscosity})
        real(x);
    for (const auto& x : {c.time.step, c.stop.end_time, c.stop.steady_tolerance, c.stop.wall_clock,
                          c.stop.periodic_tolerance, c.output.wall_every, c.output.fluid_every})
        maybe(x);
    maybe(c.perturbation.mode);
    integer(c.perturbation.seed);
    for (const auto& x : {c.stop.steps, c.checkpoint.steps}) maybe(x);
    const DriveParameters& d = c.drive;
    for (Real x : {d.ramp, d.inlet_flow.mean, d.windkessel.R1, d.windkessel.R2, d.windkessel.C,
                   d.windkessel.distal})
        real(x);
    for (bool flag : {d.inlet_flow.given, d.total_pressure}) integer(flag);
    for (const Waveform* w :
         {&d.inlet_waveform, &d.outlet_waveform, &d.external_waveform, &d.inlet_flow.waveform}) {
        real(w->amplitude);
        real(w->period);
        for (const auto* numbers : {&w->cosine, &w->sine, &w->times, &w->values}) {
            integer(numbers->size());
            for (Real x : *numbers) real(x);
        }
    }
    for (const AlongX* a : {&c.tube.rest_radius, &c.material.stiffness}) {
        integer(a->shape);
        for (Real x : {a->position, a->length, a->change}) real(x);
        for (const auto* numbers : {&a->x, &a->values}) {
            integer(numbers->size());
            for (Real x : *numbers) real(x);
        }
    }
    integer(c.checkpoint.keep);
    integer(c.time.cycle_samples);
    integer(c.grid.cells.has_value());
    if (c.grid.cells)
        for (Index n : *c.grid.cells) integer(n);
    for (bool flag :
         {c.tube.rigid, c.output.wall, c.output.fluid, c.output.double_precision, c.scaling.si})
        integer(flag);
    integer(c.output.sample_every);
    integer(c.output.fluid_part.region);
    integer(c.output.fluid_part.stride);
    integer(c.material.law);
    integer(c.coupling.scheme);
    return out;
}

inline bool same(const Case& a, const Case& b) { return a.title == b.title && bits(a) == bits(b); }

} // namespace starling::test
