#pragma once
/// Small axisymmetric waves of the undeformed tube, with the fluid inside and outside and its
/// viscosity: docs/theory.md, "Waves". In the paper's units.
#include <complex>
#include <string>

#include "config/scaling.hpp"
#include "grid/grid_parameters.hpp"
#include "theory/tube_problem.hpp"

namespace starling {

using Complex = std::complex<Real>;

/// Waves eta = exp(i (k x - omega t)) in the radius of a tube in the middle of a box.
class TubeWaves {
public:
    TubeWaves(const MaterialParameters& material, Real reynolds, const GridParameters& box);

    /// Speed of long waves without viscosity: that of Moens and Korteweg times
    /// sqrt(1 - pi/(W_y W_z)), the share of the fluid inside in the inertia.
    Real long_wave_speed() const;
    /// omega of a wave number k > 0 without viscosity, of the fluid and of the wall.
    Real inviscid_frequency(Real k) const;
    /// k of a wave of the real frequency omega > 0 that travels towards +x: omega/Re(k) is its
    /// speed, and its amplitude falls as exp(-Im(k) x).
    Complex wave_number(Real omega) const;
    /// omega of a wave of real k > 0: its amplitude falls as exp(Im(omega) t). Where friction lets
    /// it swing no more the real part is zero, and this is the slower of the two decays.
    Complex frequency(Real k) const;

private:
    Complex stiffness(Complex omega) const;
    Complex inertia(Complex k, Complex omega) const;
    Complex first_guess(Real k) const;

    Real reynolds_, stiffness_, damping_, outer_radius_;
};

/// The slowest standing wave between the ends, where pressures are given: half a wave.
struct TubeMode {
    Real wave_number = 0;
    Real period = 0;     ///< NaN where friction does not let the tube swing
    Real decay_time = 0; ///< in which the amplitude falls by a factor e
};

/// Wave number of the slowest mode: k L_d + atan(k l_in) + atan(k l_out) = pi, with the lengths of
/// the deforming part and of the rigid ends, in which only inertia counts.
Real slowest_wave_number(const TubeParameters& tube);

TubeMode slowest_mode(const TubeWaves& waves, const TubeParameters& tube);

/// What theory says of the waves of a compliant tube, for people.
std::string waves_text(const TubeProblem& problem, const GridParameters& box,
                       const Scaling& scaling);

/// Waves of given frequency: columns omega, speed, attenuation, each headed "name [unit]", up to
/// waves of about the length pi R_0. Throws InputError for a rigid tube.
std::string waves_csv(const TubeProblem& problem, const GridParameters& box,
                      const Scaling& scaling);

} // namespace starling
