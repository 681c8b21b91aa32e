#include "config/scaling.hpp"

namespace starling {

Real Scaling::factor(Quantity q) const
{
    const Real l = length, u = velocity, p = density * velocity * velocity;
    switch (q) {
    case Quantity::none: return 1;
    case Quantity::length: return l;
    case Quantity::area: return l * l;
    case Quantity::volume: return l * l * l;
    case Quantity::time: return l / u;
    case Quantity::velocity: return u;
    case Quantity::flow_rate: return l * l * u;
    case Quantity::pressure: return p;
    case Quantity::force: return p * l * l;
    case Quantity::energy: return p * l * l * l;
    case Quantity::power: return p * u * l * l;
    case Quantity::surface_tension: return p * l;
    case Quantity::shear_stress: return p;
    case Quantity::rate: return u / l;
    case Quantity::density: return density;
    case Quantity::viscosity: return density * u * l;
    case Quantity::flow_resistance: return density * u / (l * l);
    case Quantity::compliance: return l * l * l / p;
    case Quantity::stiffness_per_area: return p / l;
    case Quantity::damping_per_area: return density * u;
    case Quantity::surface_viscosity: return density * u * l * l;
    }
    return 1;
}

std::string Scaling::unit(Quantity q) const
{
    switch (q) {
    case Quantity::none: return "1";
    case Quantity::length: return si ? "m" : "R_0";
    case Quantity::area: return si ? "m^2" : "R_0^2";
    case Quantity::volume: return si ? "m^3" : "R_0^3";
    case Quantity::time: return si ? "s" : "R_0/U_c";
    case Quantity::velocity: return si ? "m/s" : "U_c";
    case Quantity::flow_rate: return si ? "m^3/s" : "R_0^2 U_c";
    case Quantity::pressure:
    case Quantity::shear_stress: return si ? "Pa" : "rho U_c^2";
    case Quantity::force: return si ? "N" : "rho U_c^2 R_0^2";
    case Quantity::energy: return si ? "J" : "rho U_c^2 R_0^3";
    case Quantity::power: return si ? "W" : "rho U_c^3 R_0^2";
    case Quantity::surface_tension: return si ? "N/m" : "rho U_c^2 R_0";
    case Quantity::rate: return si ? "1/s" : "U_c/R_0";
    case Quantity::density: return si ? "kg/m^3" : "rho";
    case Quantity::viscosity: return si ? "Pa s" : "rho U_c R_0";
    case Quantity::flow_resistance: return si ? "Pa s/m^3" : "rho U_c/R_0^2";
    case Quantity::stiffness_per_area: return si ? "Pa/m" : "rho U_c^2/R_0";
    case Quantity::surface_viscosity: return si ? "Pa s m" : "rho U_c R_0^2";
    case Quantity::damping_per_area: return si ? "Pa s/m" : "rho U_c";
    case Quantity::compliance: return si ? "m^3/Pa" : "R_0^3/(rho U_c^2)";
    }
    return "";
}

} // namespace starling
