#include "config/read_scaling.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace starling {

namespace {

constexpr Real unknown = std::numeric_limits<Real>::quiet_NaN();

bool require_all(CaseValues& values, std::initializer_list<std::string_view> names)
{
    bool all = true;
    for (std::string_view name : names) all = values.require(name) && all;
    return all;
}

/// |P_in - P_out| R_0^2/(4 mu L), or NaN.
Real velocity_of_drop(CaseValues& values)
{
    // A pressure ratio has been refused, with the advice to give the pressure at the inlet.
    if (values.given("drive.pressure_ratio") && !values.given("drive.pressure_inlet"))
        return unknown;
    const bool known = require_all(
        values, {"drive.pressure_inlet", "fluid.viscosity", "vessel.radius", "vessel.length"});
    if (!known || !values.sound({"drive.pressure_outlet"})) return unknown;
    const long double outlet =
        values.given("drive.pressure_outlet") ? values.si("drive.pressure_outlet") : 0;
    const long double drop = std::abs(values.si("drive.pressure_inlet") - outlet);
    if (drop == 0) {
        values.missing("drive.velocity_scale",
                       "without a pressure drop it cannot be found from the case");
        return unknown;
    }
    const long double r = values.si("vessel.radius");
    const long double velocity =
        drop * r * r / (4 * values.si("fluid.viscosity") * values.si("vessel.length"));
    if (velocity > 1e-20L && velocity < 1e20L) return static_cast<Real>(velocity);
    values.problem("drive.pressure_inlet",
                   fmt::format("gives a velocity scale of {:g} m/s", velocity));
    return unknown;
}

/// 2 |Q|/(pi R_0^2), of the mean flow rate at the inlet or, without one, of its amplitude.
Real velocity_of_flow(CaseValues& values)
{
    const std::string_view key =
        values.given("inlet_flow.mean") ? "inlet_flow.mean" : "inlet_flow.amplitude";
    if (!values.has(key) || !values.require("vessel.radius")) return unknown;
    const long double r = values.si("vessel.radius"), Q = std::abs(values.si(key));
    const long double velocity = 2 * Q / (static_cast<long double>(pi) * r * r);
    if (velocity > 1e-20L && velocity < 1e20L) return static_cast<Real>(velocity);
    values.missing("drive.velocity_scale", "it cannot be found from the flow rate");
    return unknown;
}

} // namespace

Scaling read_scaling(CaseValues& values)
{
    if (values.system() == UnitSystem::dimensionless) return {};
    Scaling s{true, unknown, unknown, unknown};
    if (values.require("vessel.radius")) s.length = static_cast<Real>(values.si("vessel.radius"));
    if (values.require("fluid.density")) s.density = static_cast<Real>(values.si("fluid.density"));
    if (values.has("drive.velocity_scale") && values.si("drive.velocity_scale") > 0)
        s.velocity = static_cast<Real>(values.si("drive.velocity_scale"));
    else if (!values.given("drive.velocity_scale"))
        s.velocity =
            values.has_section("inlet_flow") ? velocity_of_flow(values) : velocity_of_drop(values);
    values.set_scaling(s);
    return s;
}

void read_reynolds(CaseValues& values, const Scaling& scaling, Real& reynolds)
{
    if (values.system() == UnitSystem::dimensionless) {
        if (values.require("fluid.reynolds")) values.fill("fluid.reynolds", reynolds);
        return;
    }
    values.require("fluid.viscosity");
    const auto scale = static_cast<long double>(scaling.factor(Quantity::viscosity));
    if (!values.has("fluid.viscosity") || !std::isfinite(scale)) return;
    values.accept("fluid.viscosity", "fluid.reynolds",
                  static_cast<Real>(scale / values.si("fluid.viscosity")), reynolds);
}

} // namespace starling
