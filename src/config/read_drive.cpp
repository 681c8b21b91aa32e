#include "config/read_drive.hpp"

#include <fmt/format.h>

#include "config/read_waveform.hpp"

namespace starling {

namespace {

constexpr std::string_view ratio = "drive.pressure_ratio";

/// Where the inlet has a flow rate its pressure follows.
void read_inlet_flow(CaseValues& values, const std::filesystem::path& folder, InletFlow& flow)
{
    flow.given = true;
    values.fill("inlet_flow.mean", flow.mean);
    flow.waveform = read_waveform(values, "inlet_flow", folder);
    if (!values.given("inlet_flow.mean") && !values.given("inlet_flow.amplitude"))
        values.missing("inlet_flow.mean", "or give a waveform");
    for (const char* key : {"drive.pressure_ratio", "drive.pressure_inlet", "drive.end_pressure",
                            "inlet_waveform.amplitude"})
        if (values.given(key))
            values.problem(key, "leave it out: the inlet has a flow rate, [inlet_flow], and its "
                                "pressure follows");
}

void read_windkessel(CaseValues& values, Windkessel& w)
{
    for (const char* key : {"windkessel.R1", "windkessel.R2", "windkessel.C"}) values.require(key);
    values.fill("windkessel.R1", w.R1);
    values.fill("windkessel.R2", w.R2);
    values.fill("windkessel.C", w.C);
    values.fill("windkessel.pressure_distal", w.distal);
    if (values.given(ratio))
        values.problem(ratio, "give pressure_inlet or a flow rate, [inlet_flow]: the pressure at "
                              "the outlet follows from [windkessel]");
    for (const char* key : {"drive.end_pressure", "outlet_waveform.amplitude"})
        if (values.given(key))
            values.problem(key, "leave it out: the pressure at the outlet follows from "
                                "[windkessel]");
}

/// The inlet's pressure, or the outlet's where the inlet's is given, from the ratio.
void read_ratio(CaseValues& values, const Case& c, DriveParameters& drive)
{
    const bool inlet = values.given("drive.pressure_inlet");
    if (inlet && values.given("drive.pressure_outlet"))
        values.problem(ratio, "give it or both pressures, not all three");
    if (!values.sound({ratio, "vessel.length", "fluid.reynolds"})) return;
    const Real drop = values.number(ratio) * c.baseline_pressure_drop();
    (inlet ? drive.pressure_outlet : drive.pressure_inlet) =
        inlet ? drive.pressure_inlet - drop : drive.pressure_outlet + drop;
    for (Real p : {drive.pressure_inlet, drive.pressure_outlet})
        if (!case_key("drive.pressure_inlet").range.contains(p))
            values.problem(ratio, fmt::format("gives a pressure of {:g}, which is too large", p));
}

void read_pressures(CaseValues& values, const Case& c, DriveParameters& drive)
{
    values.fill("drive.pressure_inlet", drive.pressure_inlet);
    values.fill("drive.pressure_outlet", drive.pressure_outlet);
    values.fill("drive.pressure_external", drive.pressure_external);
    if (drive.inlet_flow.given) return;
    const bool by_ratio = values.given(ratio);
    if (values.system() == UnitSystem::si) {
        if (!by_ratio) // where it is given, it has been refused in favour of the inlet's
            values.require("drive.pressure_inlet");
    } else if (by_ratio)
        read_ratio(values, c, drive);
    else if (!values.given("drive.pressure_inlet"))
        values.missing(ratio, "or give pressure_inlet");
}

} // namespace

void read_drive(CaseValues& values, Case& c, const std::filesystem::path& folder)
{
    DriveParameters& drive = c.drive;
    if (values.has_section("inlet_flow")) read_inlet_flow(values, folder, drive.inlet_flow);
    if (values.has_section("windkessel")) read_windkessel(values, drive.windkessel);
    read_pressures(values, c, drive);
    drive.inlet_waveform = read_waveform(values, "inlet_waveform", folder);
    drive.outlet_waveform = read_waveform(values, "outlet_waveform", folder);
    drive.external_waveform = read_waveform(values, "external_waveform", folder);
    drive.total_pressure = values.text("drive.end_pressure", "static") == "total";
    values.fill("drive.ramp", drive.ramp);
}

} // namespace starling
