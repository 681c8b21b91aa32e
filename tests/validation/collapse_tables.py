"""The tables of docs/validation.md on tubes that collapse."""
import math

import cases
from collapse import BuckledRing, MeshQuality, Resistor, TubeLaw, balance, distance_between
from report import percent
from tables import Section, rows, steady


def modes(report, get):
    def row(n, r):
        case, quality, (balanced, unsteady) = f"mode {n}", MeshQuality(r), balance(r)
        return [n, report.check(f"{case}: lobes", r["mode"] == n, r["mode"]),
                f"{r['min_area_ratio']:.3f} at {r['x_min_area']:.2f}",
                f"{r['min_gap_over_spacing']:.1f}",
                report.at_most(f"{case}: dV/dt over Q", unsteady, 1e-3, 3), percent(balanced),
                f"{quality.smallest_angle:.0f}° ({quality.smallest_angle_at_rest:.0f}°)",
                f"{quality.smallest_area:.2f} to {quality.largest_area:.2f}",
                steady(report, case, r), f"{r.spacing:.3f}", r["steps"], f"{r['wall_seconds']:.0f}"]

    header = ["case", "lobes", "A_min/A_0 at x", "smallest gap/spacing", "dV/dt over Q", "leak/Q",
              "smallest angle (at rest)", "triangle areas over those at rest", "steady", "spacing",
              "steps", "seconds"]
    report.table(header, rows(cases.MODES, get, len(header), row))


def tube_law(report, get):
    result = get(cases.TUBE_LAW)
    if result is None or result.broke_down:
        return report.paragraph("Not run.")
    law, ring, table = TubeLaw(result), BuckledRing(2), []
    for pressure, area in law.points:
        of_ring = ring.pressure(area)
        table.append([f"{pressure:.2f}", f"{area:.4f}", f"{ring.area(pressure):.4f}",
                      f"{of_ring:.3f}",
                      report.at_most(f"A/A_0 = {area:.2f}: pressure", pressure / of_ring - 1, 0.03)])
    report.table(["pressure over E_b/R_0^3", "A/A_0", "A/A_0 of the ring",
                  "pressure of the ring at A", "difference of pressure"], table)


def laws(report, get):
    reference = get(cases.COLLAPSE_LAWS["Hooke, nu = 0.5"])

    def row(law, r):
        apart = distance_between(r, reference) if reference else math.nan
        return [law, f"{r['min_area_ratio']:.4f} at {r['x_min_area']:.2f}",
                report.check(f"{law}: lobes", r["mode"] == 2, r["mode"]),
                f"{r['smallest_gap']:.4f}",
                report.at_most(f"{law}: wall from Hooke's", apart, 0.02),
                f"{r['Q_mid_over_Q0']:.4f}", percent(r["leak_over_Q"]), steady(report, law, r),
                r["steps"], f"{r['wall_seconds']:.0f}"]

    header = ["law", "A_min/A_0 at x", "lobes", "smallest gap", "wall from Hooke's, over R_0",
              "Q/Q_0", "leak/Q", "steady", "steps", "seconds"]
    report.table(header, rows(cases.COLLAPSE_LAWS, get, len(header), row))


def inertia(report, get):
    def row(key, r):
        n, Re = key
        case, slow = f"n = {n}, Re = {Re}", get(cases.COLLAPSE_INERTIA[n, 0.1])
        apart = distance_between(r, slow) if slow else math.nan
        return [f"{n}, {Re}", report.check(f"{case}: lobes", r["mode"] == n, r["mode"]),
                f"{r['min_area_ratio']:.4f} at {r['x_min_area']:.2f}",
                f"{r['smallest_gap']:.3f}", percent(apart), f"{r['Q_mid_over_Q0']:.4f}",
                percent(r["leak_over_Q"]), steady(report, case, r), r["steps"],
                f"{r['wall_seconds']:.0f}"]

    header = ["n, Re", "lobes", "A_min/A_0 at x", "smallest gap", "wall from that at Re = 0.1, over R_0",
              "Q/Q_0", "leak/Q", "steady", "steps", "seconds"]
    report.table(header, rows(cases.COLLAPSE_INERTIA, get, len(header), row))
    for n in (3, 4):
        results = [get(run) for (lobes, _), run in cases.COLLAPSE_INERTIA.items() if lobes == n]
        if all(results):
            areas = [r["min_area_ratio"] for r in results]
            report.paragraph(f"n = {n}: the smallest area falls with Re: " + report.check(
                f"n = {n}: area falls with Re", areas == sorted(areas, reverse=True),
                ", ".join(f"{a:.4f}" for a in areas)))


def resistor(report, get):
    r = get(cases.RESISTOR)
    if r is None or r.broke_down:
        return report.paragraph("Not run.")
    tube, (leak, unsteady) = Resistor(r), balance(r)
    report.table(
        ["lobes", "A_min/A_0 at x", "smallest gap/spacing", "Q/Q_0", "pressure falls at the narrowest, "
         "over in front and behind", "dP/dx behind against Poiseuille's", "dV/dt over Q", "leak/Q", "t",
         "steps", "seconds"],
        [[report.check("lobes", r["mode"] == 2, r["mode"]),
          f"{r['min_area_ratio']:.4f} at {r['x_min_area']:.2f}", f"{r['min_gap_over_spacing']:.2f}",
          f"{r['Q_mid_over_Q0']:.4f}", f"{tube.steepness[0]:.1f}, {tube.steepness[1]:.1f}",
          report.at_most("slope of the pressure behind", tube.outlet_slope_error, 0.03),
          percent(unsteady), percent(leak), f"{r['t']:.3g}", r["steps"],
          f"{r['wall_seconds']:.0f}"]])


SECTIONS = [
    Section("modes", "Modes of collapse, Fig. 15", list(cases.MODES.values()),
            "The shipped cases. Leak: flow through the wall over Q; what the balance Q_in - Q_out - dV/dt "
            "leaves. Angles and areas are those of the wall's triangles.", modes),
    Section("tube-law", "Tube law of a long tube", [cases.TUBE_LAW],
            "`cases/tube_law.toml`: the middle section of a long tube without flow, as its external pressure "
            "rises in steps, against the inextensible ring.", tube_law),
    Section("collapse-laws", "Three laws in collapse, Fig. 18", list(cases.COLLAPSE_LAWS.values()),
            "`cases/collapse_mode2.toml`, coarse, with other laws. \"Wall from Hooke's\": largest distance of a "
            "vertex of the wall from where it is with Hooke's law.", laws),
    Section("collapse-inertia", "Collapse with inertia, Figs. 19 and 20",
            list(cases.COLLAPSE_INERTIA.values()),
            "`cases/collapse_mode3.toml` and `collapse_mode4.toml`, coarse, at other Reynolds numbers; pressures, "
            "over G_s/R_0, are the same.", inertia),
    Section("resistor", "Starling resistor, Fig. 16", [cases.RESISTOR],
            "`cases/starling_resistor.toml`. The slope of the pressure on the axis where it is steepest, over "
            "those in the first radius of the tube and in the rigid outlet from two radii behind the deforming "
            "part on.", resistor),
]
