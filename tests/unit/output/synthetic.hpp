#pragma once
/// Small snapshots whose values follow from position and time, for tests of files and viewers.
#include "solver/monitor_data.hpp"

namespace starling::synthetic {

/// Units that change every number: R_0 = 2 m, U_c = 3 m/s, rho = 5 kg/m^3.
inline Scaling si_scaling() { return {true, 2, 3, 5}; }

/// A tetrahedron's surface that moves by (t, 2t, 3t); tension = element number + t.
inline WallSnapshot wall(Real t, Index step)
{
    WallSnapshot s;
    s.t = t;
    s.step = step;
    const Vec3 move{t, 2 * t, 3 * t};
    for (Vec3 p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        s.points.push_back(p + move);
    s.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    NamedArray displacement{"displacement", Quantity::length, 3, {}};
    NamedArray pressure{"transmural_pressure", Quantity::pressure, 1, {}};
    NamedArray tension{"tension1", Quantity::surface_tension, 1, {}};
    using Value = decltype(NamedArray::values)::value_type;
    for (int n = 0; n < 4; ++n) {
        for (Real d : {move.x, move.y, move.z})
            displacement.values.push_back(static_cast<Value>(d));
        pressure.values.push_back(static_cast<Value>(10 * n));
        tension.values.push_back(static_cast<Value>(n + t));
    }
    s.at_vertex = {displacement, pressure};
    s.at_element = {tension};
    return s;
}

/// 6 x 4 x 5 cells; pressure = t + x + 10 y + 100 z and velocity = (x, y, z) at the cell centres.
inline FluidSnapshot fluid(Real t, Index step)
{
    FluidSnapshot s;
    s.t = t;
    s.step = step;
    s.cells = {6, 4, 5};
    s.origin = {0, -1, -2};
    s.spacing = {0.5, 0.25, 0.75};
    NamedArray velocity{"velocity", Quantity::velocity, 3, {}};
    NamedArray pressure{"pressure", Quantity::pressure, 1, {}};
    using Value = decltype(NamedArray::values)::value_type;
    const auto centre = [](Real origin, Real spacing, Index n) {
        return origin + spacing * (static_cast<Real>(n) + 0.5);
    };
    for (Index i = 0; i < s.cells[0]; ++i)
        for (Index j = 0; j < s.cells[1]; ++j)
            for (Index k = 0; k < s.cells[2]; ++k) {
                const Vec3 p{centre(s.origin.x, s.spacing.x, i), centre(s.origin.y, s.spacing.y, j),
                             centre(s.origin.z, s.spacing.z, k)};
                for (Real c : {p.x, p.y, p.z}) velocity.values.push_back(static_cast<Value>(c));
                pressure.values.push_back(static_cast<Value>(t + p.x + 10 * p.y + 100 * p.z));
            }
    s.at_cell = {velocity, pressure};
    return s;
}

} // namespace starling::synthetic
