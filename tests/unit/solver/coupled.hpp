#pragma once
/// A small coupled problem: a compliant tube in a coarse box that inflates within some steps.
#include "solver/advance.hpp"
#include "unit/immersed_boundary/boxed_tube.hpp"

namespace starling::support {

struct CoupledParameters {
    Material material = NeoHookean{1 / (0.1 * 0.02)};
    CouplingScheme scheme = CouplingScheme::reaction;
    Real E_b = 0; ///< bending modulus
    ContactParameters contact = {};
    TissueParameters tissue = {};
    Real mu_s = 0; ///< membrane viscosity
    Real spacing = 0.3;
    Real pressure_ratio = 5;
    bool centred = false; ///< the tube's axis is the middle of the grid
    TubeParameters tube = short_tube();
};

struct Coupled {
    static constexpr Real reynolds = 0.1;
    static constexpr FluidParameters fluid = {.reynolds = reynolds, .theta = 1};
    Grid g;
    Tube tube;
    Operators op;
    Workspace w;
    State s;

    explicit Coupled(const CoupledParameters& p = {})
        : g(p.centred ? Grid({static_cast<Index>(p.tube.length / p.spacing), 16, 18},
                             {0, -2.5, -2.6}, {p.tube.length, 5, 5.2})
                      : box_around(p.spacing, p.tube.length)),
          tube(make_tube(p.tube, p.tube.edge_over_spacing * g.delta())),
          op(g, tube,
             {p.material, p.E_b, p.contact, p.tube.mesh_filter, p.tube.smoothing, p.tissue, p.mu_s,
              0.5},
             fluid, {.pressure_inlet = p.pressure_ratio * 4 * p.tube.length / reynolds}, p.scheme),
          w(g, tube), s(g, tube)
    {
        s.dt = 5 * 0.02 * g.delta();
        initialise(s, op);
    }
    /// Steps; false as soon as one fails.
    bool run(int steps)
    {
        for (int n = 0; n < steps; ++n)
            if (!advance(s, op, w, s.dt)) return false;
        return true;
    }
};

} // namespace starling::support
