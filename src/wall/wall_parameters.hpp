#pragma once
/// What a case says about the tube and its material.
#include <optional>

#include "core/types.hpp"
#include "wall/along_x.hpp"

namespace starling {

/// Geometry of the undeformed tube, radius 1: rigid inlet, deforming part, rigid outlet.
struct TubeParameters {
    Real length = 4 * pi;
    Real rigid_inlet = 1.18;       ///< length of the rigid inlet
    Real rigid_outlet = 0.39;      ///< length of the rigid outlet
    bool rigid = false;            ///< the whole tube is rigid (rigid_inlet, rigid_outlet unused)
    Real edge_over_spacing = 0.65; ///< triangle edge relative to the grid spacing
    Real smoothing = 0;            ///< alpha of the smoothing velocity (U_c R_0^3)
    Real mesh_filter =
        1; ///< rate of the filter of the shortest waves, over that of the grid's waves
    AlongX rest_radius = {}; ///< undeformed radius over R_0; 1 at both ends of the tube
};

enum class ElasticLaw { hooke, neo_hookean, mooney_rivlin, skalak };

/// Springs and dampers of the tissue around the vessel, to the rest position, per undeformed area.
struct TissueParameters {
    Real stiffness = 0; ///< k (rho U_c^2/R_0)
    Real damping = 0;   ///< c (rho U_c)

    bool none() const { return stiffness == 0 && damping == 0; }
};

/// Membrane material in the paper's scaling: G_s* = 1/(Re eps).
struct MaterialParameters {
    ElasticLaw law = ElasticLaw::hooke;
    Real eps = 0.02; ///< deformability mu U_c / G_s
    Real poisson_ratio =
        0.5;            ///< nu_s (Hooke; for Skalak it sets C = nu_s/(1 - nu_s) unless C is given)
    Real psi = 0.5;     ///< Mooney-Rivlin Psi in [0, 1]
    Real skalak_C = 1;  ///< Skalak's area modulus over G_s
    Real contact = 0;   ///< pressure that keeps touching walls apart, in G_s/R_0; 0: none
    Real bending = 0;   ///< B = E_b/(R_0^2 G_s); 0: a membrane
    Real viscosity = 0; ///< mu_s of the wall, in its plane (rho U_c R_0^2); 0: purely elastic
    TissueParameters support = {}; ///< tissue around the deforming part
    AlongX stiffness = {};         ///< factor on G_s, and so on the tensions
};

/// A small deviation of the wall from the circular tube at t = 0, which chooses how it buckles.
struct PerturbationParameters {
    Real amplitude = 0;             ///< of the radius (R_0); 0: none
    std::optional<Index> mode = {}; ///< lobes of a single wave around the tube; empty: random waves
    Index seed = 1;                 ///< of the random waves
};

} // namespace starling
