#pragma once
/// What a run reports: one sample in time, one profile along x, snapshots of wall and fluid.
/// All numbers are in solver (dimensionless) units.
#include <limits>
#include <string>
#include <vector>

#include "config/scaling.hpp"
#include "core/types.hpp"

namespace starling {

/// One row of series.csv.
struct Sample {
    Real t = 0;
    Index step = 0;
    Real dt = 0;
    Real Q_in = 0, Q_mid = 0, Q_out = 0; ///< flow rate inside the tube: x = 0, middle, x = L
    Real Q_exterior = 0;                 ///< flow rate outside the tube in the middle plane
    Real P_in = 0, P_out = 0;            ///< pressures at the ends inside the tube, of the drive
    Real dV_dt = 0;                      ///< change of the enclosed volume
    Real leak = 0;                       ///< dV/dt - (Q_in - Q_out)
    Real volume = 0;
    Real R_max = 0, x_R_max = 0; ///< largest ring-averaged radius and where
    Real R_min = 0;              ///< smallest vertex distance from the axis
    Real smallest_gap = 0;       ///< smallest distance between opposite walls
    Real min_area_ratio = 1;     ///< smallest cross-section over the undeformed one
    Real x_min_area = 0;         ///< where it is
    Index lobes = 0;             ///< of that cross-section; 0: round
    Real kinetic_energy = 0, elastic_energy = 0, bending_energy = 0;
    /// Rates of energy in the last step, see `Powers`.
    Real power_in = 0, power_out = 0, power_exterior = 0, power_viscous = 0, power_kinetic = 0,
         power_wall = 0, power_residual = 0;
    Real largest_displacement = 0;
    Real max_strain = 0; ///< largest principal stretch - 1
    Real cfl = 0;        ///< max |u| dt / Delta
};

/// One row of profile.csv; rows lie at the planes of vertices of the wall.
struct ProfileRow {
    Real x = 0;
    Real R_mean = 0, R_min = 0, R_max = 0;
    Real area = 0;         ///< of the polygon through the ring's vertices
    Real P_centre = 0;     ///< pressure on the tube's axis
    Real P_transmural = 0; ///< ring-averaged internal - external pressure
    Real Q = 0;            ///< flow rate inside the tube
    Real leak = 0;         ///< flow that has come in through the wall between x = 0 and here
    Real gap = 0;          ///< smallest distance between opposite walls
    Index lobes = 0;       ///< 0: round
    /// Amplitudes of cos and sin(n theta) in the radius at the vertices' undeformed angles.
    Real mode_2 = 0, mode_3 = 0, mode_4 = 0, mode_5 = 0, mode_6 = 0, mode_7 = 0, mode_8 = 0;
    /// Means over the ring of the time-averaged wall shear stress and the oscillatory shear index
    /// of the last cycle; NaN where there is none.
    Real TAWSS = std::numeric_limits<Real>::quiet_NaN();
    Real OSI = std::numeric_limits<Real>::quiet_NaN();
};

/// One row of sections.csv: a wall vertex in its cross-section.
struct SectionPoint {
    Real x = 0;     ///< of the section
    Real theta = 0; ///< angle at which the vertex stood in the undeformed tube, from the y axis
    Real y = 0, z = 0;
};

/// Named values on points or cells, `components` per location, interleaved.
struct NamedArray {
    std::string name;
    Quantity quantity = Quantity::none;
    int components = 1; ///< 1 scalar, 3 vector
    std::vector<Real> values;
};

/// The wall at one time; positions change, triangles do not.
struct WallSnapshot {
    Real t = 0;
    Index step = 0;
    std::vector<Vec3> points;
    std::vector<std::array<VertexIndex, 3>> triangles;
    std::vector<NamedArray> at_vertex;
    std::vector<NamedArray> at_element;
};

/// Fluid fields at cell centres at one time, x slowest and z fastest.
struct FluidSnapshot {
    Real t = 0;
    Index step = 0;
    std::array<Index, 3> cells{}; ///< nx, ny, nz
    Vec3 origin;                  ///< corner of the box with the smallest coordinates
    Vec3 spacing;
    std::vector<NamedArray> at_cell;
};

} // namespace starling
