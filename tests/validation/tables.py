"""The tables of docs/validation.md: each function writes one section from finished runs."""
import math

import cases
import measures
from carotid import Carotid
from measures import Q_0
from report import percent
from runs import sha256
from tightness import REACH, Tightness
from waves import Oscillation, PressureWave, Sustained
from womersley import Womersley


class Section:
    """A section, its runs, and the words above its table."""

    def __init__(self, name, title, runs, text, write):
        self.name, self.title, self.runs, self.text, self.write = name, title, runs, text, write


def steady(report, what, result):
    """The cell that says when a run was steady; a run that was not fails a check."""
    t = f"t = {result['t']:.3g}"
    if result["converged"]:
        return report.check(f"{what}: steady", True, t)
    return report.check(f"{what}: steady", False, f"not steady: {result['reason'][:40]}, {t}")


def rows(runs, get, width, row):
    """One row for each (key, run); a run that was not made or broke down has no numbers."""
    table = []
    for key, run in runs.items():
        result = get(run)
        label = ", ".join(map(str, key)) if isinstance(key, tuple) else key
        if result is None:
            table.append([label, "not run"] + ["-"] * (width - 2))
        elif result.broke_down:
            table.append([label, "broke down"] + ["-"] * (width - 2))
        else:
            table.append(row(key, result))
    return table


def whole(get):
    """`get` without the runs that `--quick` cut short, of which nothing can be measured."""
    def finished(run):
        result = get(run)
        return None if result is None or result["reason"] == "steps" else result

    return finished


AXISYMMETRIC = ["R_max - 1 against axisymmetric", "Q against axisymmetric"]


def axisymmetric(result):
    """The cells below AXISYMMETRIC."""
    return [percent(result.axisymmetric_displacement_error),
            percent(result.axisymmetric_flow_error)]


def rigid(report, get):
    finished = {d: [get(run) for run in runs] for d, runs in cases.RIGID.items()}
    if not all(r for results in finished.values() for r in results):
        return report.paragraph("Not run.")
    errors = {d: [r["Q_mid"] / Q_0 - 1 for r in results] for d, results in finished.items()}
    mean = {d: sum(e) / len(e) for d, e in errors.items()}
    table = []
    for d, e in errors.items():
        cell = percent(mean[d])
        if d == 0.1:
            cell = report.at_most("mean error of Q at 0.1", mean[d], 0.01)
        table.append([d, *map(percent, e), cell,
                      ", ".join(f"{r['steps']}" for r in finished[d]),
                      "yes" if all(r["converged"] for r in finished[d]) else "**no**"])
    offsets = [f"Q error, offset {y}, {z}" for y, z in cases.OFFSETS]
    report.table(["spacing", *offsets, "mean", "steps", "steady"], table)
    d = list(mean)
    measured = measures.order([mean[d[0]], mean[d[-1]]], [d[0], d[-1]])
    report.paragraph(f"Order of the mean error from {d[0]} to {d[-1]}: "
                     + report.at_least("order of Q over a factor of 3", measured, 1.8))


RADIUS_LIMIT = {0.5: 0.01, 1: 0.01, 1.5: 0.015, 3: 0.025}


def inflation(report, get):
    def row(ratio, r):
        case = f"ratio {ratio}"
        return [ratio, f"{r['Q_mid_over_Q0']:.4f}", f"{r['R_max'] - 1:.4f}",
                report.at_most(f"{case}: radius against Eq. (52)", measures.radius_deviation(r),
                               RADIUS_LIMIT[ratio]),
                report.at_most(f"{case}: R_max - 1", r.displacement_error, 0.03),
                report.at_most(f"{case}: Q", r.flow_error, 0.03), *axisymmetric(r),
                percent(r["leak_over_Q"]), steady(report, case, r), r["steps"],
                f"{r['wall_seconds']:.0f}"]

    header = ["ratio", "Q/Q_0", "R_max - 1", "radius against Eq. (52)", "R_max - 1 against 1-D",
              "Q against 1-D", *AXISYMMETRIC, "leak/Q", "steady", "steps", "seconds"]
    report.table(header, rows(cases.INFLATION, get, len(header), row))


def displacement_table(report, get, runs, first):
    def row(key, r):
        case = f"{first} {key}"
        return [key, f"{r['R_max'] - 1:.4f}", f"{r['theory']['R_max_1d'] - 1:.4f}",
                report.at_most(f"{case}: R_max - 1", r.displacement_error, 0.05),
                f"{r['Q_mid_over_Q0']:.3f}", percent(r.flow_error), *axisymmetric(r),
                percent(r["leak_over_Q"]), steady(report, case, r), f"{r.spacing:.3f}", r["steps"],
                f"{r['wall_seconds']:.0f}"]

    header = [first, "R_max - 1", "1-D model", "difference", "Q/Q_0", "Q against 1-D",
              *AXISYMMETRIC, "leak/Q", "steady", "spacing", "steps", "seconds"]
    report.table(header, rows(runs, get, len(header), row))


def deformability(report, get):
    displacement_table(report, get, cases.DEFORMABILITY, "eps")


def softening(report, get):
    displacement_table(report, get, cases.SOFTENING, "ratio")


def laws(report, get):
    displacement_table(report, get, cases.LAWS, "law")
    results = [get(run) for run in cases.LAWS.values()]
    if not all(results):
        return
    R = [r["R_max"] for r in results]
    report.paragraph("Order of the paper, from the largest to the smallest: " + report.check(
        "order of the laws", R == sorted(R, reverse=True), " > ".join(cases.LAWS)))


def refinement(report, get):
    def row(key, r):
        ratio, _ = key
        return [f"{ratio}, {r.spacing:.4f}", r["cells"], f"{r['Q_mid_over_Q0']:.4f}",
                percent(r.flow_error), f"{r['R_max'] - 1:.5f}", percent(r.displacement_error),
                *axisymmetric(r), percent(measures.radius_deviation(r)), percent(r["leak_over_Q"]),
                f"{r['t']:.3g}", r["steps"], f"{r['wall_seconds']:.0f}"]

    header = ["ratio, spacing", "cells", "Q/Q_0", "Q against 1-D", "R_max - 1",
              "R_max - 1 against 1-D", *AXISYMMETRIC, "radius against Eq. (52)", "leak/Q", "t",
              "steps", "seconds"]
    report.table(header, rows(cases.REFINEMENT, get, len(header), row))
    for ratio in (1, 3):
        results = [get(run) for (of, _), run in cases.REFINEMENT.items() if of == ratio]
        if all(r and not r.broke_down for r in results):
            richardson(report, ratio, results)


def richardson(report, ratio, results):
    """Limit and order of Q/Q_0 and R_max - 1."""
    h = [r.spacing for r in results]
    one_d = results[0]["theory"]
    for name, values, theory in (
            ("Q/Q_0", [r["Q_mid_over_Q0"] for r in results], one_d["Q_1d"] / Q_0),
            ("R_max - 1", [r["R_max"] - 1 for r in results], one_d["R_max_1d"] - 1)):
        limit = measures.limit_of_second_order(values[-2:], h[-2:])
        errors = [value / limit - 1 for value in values]
        p = measures.order(errors[:2], h[:2])
        report.paragraph(
            f"Ratio {ratio}, {name}: Richardson's limit of the two finest grids {limit:.5f} "
            f"({percent(limit / theory - 1)} from the one-dimensional model's {theory:.5f}); the grids "
            f"are {', '.join(percent(e, 3) for e in errors)} from it: order from the first to the second "
            + report.at_least(f"ratio {ratio}: order of {name}", p, 1.5))


def womersley(report, get):
    def row(alpha, r):
        w = Womersley(r)
        case = f"alpha = {alpha}"
        return [alpha, report.at_most(f"{case}: amplitude", w.amplitude_error, 0.01),
                report.check(f"{case}: phase", abs(w.phase_error) <= 1,
                             f"{w.phase_error:.2f} degrees (≤ 1)"), percent(w.leak), r["steps"],
                f"{r['wall_seconds']:.0f}"]

    header = ["alpha", "amplitude of Q", "phase of Q", "leak over the amplitude", "steps",
              "seconds"]
    report.table(header, rows(cases.WOMERSLEY, get, len(header), row))


ONE_D_LIMIT = {1: 0.01, 3: 0.02}


def long_run(report, get):
    def row(key, r):
        ratio, spacing = key
        case, t, start = f"ratio {ratio}, {spacing}", Tightness(r), get(cases.START[key])
        if start is None or start.broke_down:
            return [f"{ratio}, {spacing}", "not run"] + ["-"] * (len(header) - 2)
        passed = max(t.transient, Tightness(start).transient)
        at_most = report.at_most
        transient, sections, flow, radius = (
            (at_most(f"{case}: leak of the transient", passed, 0.005),
             at_most(f"{case}: leak of a section", t.sections, 0.002),
             at_most(f"{case}: Q", r.flow_error, ONE_D_LIMIT[ratio]),
             at_most(f"{case}: R_max - 1", r.displacement_error, ONE_D_LIMIT[ratio]))
            if spacing == 0.1 else
            map(percent, (passed, t.sections, r.flow_error, r.displacement_error)))
        return [f"{ratio}, {spacing}", transient, sections, percent(t.quadrature), flow, radius,
                percent(t.exterior_pressure(3)),
                at_most(f"{case}: pressure outside", t.exterior_pressure(REACH), 0.005),
                percent(t.exterior_flow), percent(t.power_left_over),
                at_most(f"{case}: out of roundness", measures.out_of_roundness(r), 0.01),
                percent(measures.spread_of_radii(r)), f"{measures.zig_zag(r):.1e}",
                f"{r['t']:.3g}", r["steps"]]

    header = ["ratio, spacing", "leak of the transient", "leak of a section", "change of Q(x)",
              "Q against 1-D", "R_max - 1 against 1-D", "pressure outside, 3 spacings",
              "4.6 spacings", "flow outside", "power left over", "out of roundness / R_0",
              "spread of radii", "zig-zag", "t", "steps"]
    report.table(header, rows(cases.LONG, get, len(header), row))


def collapse(report, get):
    def row(key, r):
        n, spacing = key
        t = Tightness(r)
        leak, at_worst = ((report.at_most(f"{n} lobes: leak", t.end, 0.01),
                           report.at_most(f"{n} lobes: leak from t = 2 on", t.largest_after(2), 0.01))
                          if spacing == 0.1 else (percent(t.end), percent(t.largest_after(2))))
        return [f"{n}, {spacing}", leak, at_worst, percent(t.sections), f"{t.Q:.4f}",
                f"{r['min_area_ratio']:.3f}", f"{r['min_gap_over_spacing']:.1f}", f"{r['t']:.3g}",
                r["steps"], f"{r['wall_seconds']:.0f}"]

    header = ["lobes, spacing", "leak", "largest from t = 2 on", "leak of a section", "Q half way", "A_min/A_0",
              "smallest gap / spacing", "t", "steps", "seconds"]
    report.table(header, rows(cases.COLLAPSE, get, len(header), row))
    for lobes in (2, 3, 4, 5):
        results = [get(cases.COLLAPSE[lobes, d]) for d in (0.2, 0.1)]
        if all(r and not r.broke_down for r in results):
            p = measures.order([Tightness(r).largest_after(2) for r in results], [0.2, 0.1])
            report.paragraph(f"Order of the largest leak with {lobes} lobes from 0.2 to 0.1: "
                             + report.at_least(f"{lobes} lobes: order of the leak", p, 1.5))


def carotid(report, get):
    result = get(cases.CAROTID["as shipped"])
    if result is None or result.broke_down:
        return report.paragraph("Not run.")
    c = Carotid(result)
    one_d, lumped = c.one_dimensional(), c.lumped()

    def row(name, P):
        return [name, f"{c.mean(P):.0f}", f"{P.min():.0f}", f"{P.max():.0f}",
                f"{P.max() - P.min():.0f}"]

    report.table(["pressure, Pa", "mean", "lowest", "highest", "pulse"],
                 [row("inlet", c.P_in), row("inlet, one-dimensional", one_d[0]),
                  row("outlet", c.P_out), row("outlet, one-dimensional", one_d[1]),
                  row("lumped", lumped)])
    report.paragraph(
        f"Over the last heartbeat: leak {percent(c.leak_share)} of the flow (it lowers the mean pressure by "
        f"{abs(c.leak_share * c.mean_flow * sum(c.Z)):.0f} Pa); power left over "
        + report.at_most("carotid: power left over", c.power_left_over, 0.02)
        + f" of what enters; {result['steps']} steps, {result['wall_seconds']:.0f} s.")


def pressure_wave(report, get):
    def row(key, r):
        case, w = f"box {key[0]}, spacing {key[1]}", PressureWave(r)
        error = w.speed / w.predicted_speed - 1
        back = w.return_speed / w.predicted_return_speed - 1
        return [f"{key[0]}, {key[1]}", f"{w.tube.long_wave_speed:.3f}", f"{w.predicted_speed:.4f}",
                f"{w.speed:.4f}", report.at_most(f"{case}: speed", error, 0.03),
                f"{w.amplitude:.3f}", f"{w.predicted_amplitude:.3f}",
                report.at_most(f"{case}: speed to the clamp and back", back, 0.03),
                f"{w.returned:.3f}", f"{w.predicted_return:.3f}", r["steps"],
                f"{r['wall_seconds']:.0f}"]

    header = ["box, spacing", "speed of long waves", "speed, theory", "speed", "difference",
              "amplitude kept", "the same, theory", "speed to the clamp and back, difference",
              "amplitude come back", "the same, theory", "steps", "seconds"]
    report.table(header, rows(cases.PRESSURE_WAVE, whole(get), len(header), row))


def oscillation(report, get):
    def number(value):
        return "-" if math.isnan(value) else f"{value:.2f}"

    def period(Re, o):
        cell = number(o.period)
        if Re < 50:
            return cell
        error = o.period / o.slowed_period - 1
        return cell + ", " + report.at_most(f"Re = {Re}: period on the stream", error, 0.1, 1)

    def row(Re, r):
        o = Oscillation(r)
        return [Re, number(o.swing), o.swings, number(o.small_period), number(o.stream),
                number(o.slowed_period), period(Re, o), number(o.small_decay_time),
                number(o.decay_time), f"{r['Q_mid_over_Q0']:.3f}", f"{r['R_max'] - 1:.4f}",
                r["steps"], f"{r['wall_seconds']:.0f}"]

    header = ["Re", "first swing", "swings", "period of small waves at rest", "stream",
              "on the stream", "period", "decay time of small waves", "decay time",
              "Q/Q_0 at the end", "R_max - 1 at the end", "steps", "seconds"]
    report.table(header, rows(cases.OSCILLATION, whole(get), len(header), row))
    runs = [Oscillation(r) for r in map(whole(get), cases.OSCILLATION.values())
            if r and not r.broke_down]
    for what, name in (("amplitude", "swing"), ("decay time", "decay_time")):
        found = [value for o in runs if not math.isnan(value := getattr(o, name))]
        report.paragraph(f"The {what} grows with Re: "
                         + report.check(f"{what} grows with Re", len(found) > 1 and found == sorted(found),
                                        ", ".join(map(number, found))))


def sustained(report, get):
    result = whole(get)(cases.SUSTAINED["as shipped"])
    if result is None or result.broke_down:
        return report.paragraph("Not run.")
    s = Sustained(result)
    back = [share for _, share in s.backflow]
    report.table(["from the first minimum on", "measured"], [
        ["maxima of the volume", report.check("maxima", len(s.maxima) >= 4, f"{len(s.maxima)} (≥ 4)")],
        ["between them", ", ".join(f"{p:.1f}" for p in s.periods)],
        ["volume over that at rest", f"{s.volumes[0] / s.at_start:.2f} to "
                                     f"{s.volumes[1] / s.at_start:.2f}"],
        ["largest radius", f"{s.narrowest:.2f} to {s.widest:.2f}, widest at x = {s.x_widest:.1f}"],
        ["flow rate at the inlet over Q_0", f"{s.flows[0] / Q_0:.1f} to {s.flows[1] / Q_0:.1f}"],
        ["mean flow rate over Q_0", f"{s.mean_flow / Q_0:.2f}"],
        ["share of the plane of the axis where the flow goes back",
         f"{percent(min(back), 0)} to {percent(max(back), 0)}" if back else "-"],
        ["power left over", percent(s.power_left_over, 1)],
        ["leak over the flow", percent(s.leak, 1)],
        ["steps, seconds", f"{result['steps']}, {result['wall_seconds']:.0f}"]])


def threads(report, get):
    results = [get(run) for run in cases.THREADS.values()]
    if not all(results):
        return report.paragraph("Not run.")
    table = []
    for name in ("series.csv", "profile.csv", "wall.h5", "fluid.h5"):
        sums = [sha256(r.directory / name) for r in results]
        same = report.check(f"{name} with 1 and 2 threads", sums[0] == sums[1],
                            "same" if sums[0] == sums[1] else "differs")
        table.append([f"`{name}`", *(f"`{s[:16]}`" for s in sums), same])
    report.table(["file", "sha256, 1 thread", "sha256, 2 threads", ""], table)


def schemes(report, get):
    def row(key, r):
        scheme, spacing = key
        when = (steady(report, f"{scheme}, {spacing}", r) if scheme == "conserving" else
                f"t = {r['t']:.3g}" if r["converged"] else f"not steady, t = {r['t']:.3g}")
        return [f"{scheme}, {spacing}", percent(r["leak_over_Q"]), percent(r.flow_error),
                percent(r.displacement_error), *axisymmetric(r),
                percent(measures.radius_deviation(r)), f"{r['R_max'] - 1:.4f}", when, r["steps"],
                f"{r['t'] / r['steps']:.4f}"]

    header = ["scheme, spacing", "leak/Q", "Q against 1-D", "R_max - 1 against 1-D",
              *AXISYMMETRIC, "radius against Eq. (52)", "R_max - 1", "steady", "steps", "mean dt"]
    report.table(header, rows(cases.SCHEMES, get, len(header), row))


def filters(report, get):
    def change(key, Q):
        ratio, spacing, strength = key
        run = cases.FILTERS.get((ratio, spacing, strength / 2))
        half = get(run) if run and strength else None
        if half is None or half.broke_down:
            return "-"
        if strength < 4:
            return percent(Q / half["Q_mid"] - 1, 3)
        return report.at_most(f"ratio {ratio}, {spacing}: Q with twice the filter",
                              Q / half["Q_mid"] - 1, 0.001, 3)

    def row(key, r):
        return [", ".join(map(str, key)), f"{r['Q_mid_over_Q0']:.5f}", change(key, r["Q_mid"]),
                f"{r['R_max'] - 1:.5f}", percent(r["leak_over_Q"]), f"{measures.zig_zag(r):.1e}",
                percent(measures.out_of_roundness(r)), f"{r['t']:.3g}", r["steps"]]

    header = ["ratio, spacing, mesh_filter", "Q/Q_0", "Q against half of it", "R_max - 1", "leak/Q",
              "zig-zag", "out of roundness", "t", "steps"]
    report.table(header, rows(cases.FILTERS, get, len(header), row))


def speed(report, get):
    r = get(cases.INFLATION[1.5])
    if r is None or r.broke_down:
        return report.paragraph("Not run.")
    phases = r["phase_seconds"]
    whole = sum(phases.values())
    step_rate = r["cells"] * r["steps"] / whole / 1e6
    search = phases["element search"] / whole
    table = [[f"million cell-steps/s of the step, {r['cells']} cells, {r['threads']} threads",
              report.at_least("speed", step_rate, 15)],
             ["the same of the run, with sampling and files", f"{r['cell_steps_per_second'] / 1e6:.2f}"],
             ["search of the ghost nodes, share of the step",
              report.at_most("share of the search", search, 0.1, 1)]]
    table += [[f"share of {name}", percent(seconds / whole, 1)]
              for name, seconds in phases.items() if name != "element search"]
    report.table(["of one run", "measured"], table)


def values(runs):
    return list(runs.values())


SECTIONS = [
    Section("rigid", "Rigid tube", [r for runs in cases.RIGID.values() for r in runs],
            "Flow rate through a rigid tube at Re = 0.1 against pi/2. How the circle lies on the "
            "grid moves the error, so it is averaged over three places of the axis, offset from "
            "the middle of the box by the given parts of a spacing along y and z.", rigid),
    Section("inflation", "Inflation", values(cases.INFLATION),
            "Section 3.1 of the paper: L = 4 pi, rigid ends 1.18 and 0.39, box 4.7, Hooke, "
            "nu = 0.5, eps = 0.02, spacing 0.1. \"Ratio\" is Delta P/Delta P_0. Radius: largest "
            "deviation from Eq. (52) with the simulated pressure on the axis, from the largest "
            "radius + 0.5 to the end of the deforming part - 0.5. \"1-D\" is the one-dimensional "
            "model, whose own error grows with the slope of the wall; \"axisymmetric\" the "
            "solution of the full Navier-Stokes equations by `tools/axisymmetric_tube` "
            "(docs/theory.md has both, side by side). Leak: flow through the wall over Q.",
            inflation),
    Section("long", "Tightness, for three times as long", values(cases.LONG) + values(cases.START),
            "As in the section before, up to t = 36. Leak of the transient: largest at a sample, over "
            "the largest |Q_in - Q_out|; the first 200 steps, in a run of their own, are all sampled. Leak of a section: largest flow at the end that has passed the wall "
            "between the inlet and a section (column `leak` of profile.csv), over Q; change of Q(x): largest "
            "|Q(x) - Q(0)| over Q, which contains the error of measuring Q (docs/numerics.md, \"Leak\"). "
            "Pressure outside: largest deviation from the external pressure at the end farther outside the "
            "wall than so many spacings, over the inlet pressure; the wall's forces reach 4.6 spacings far "
            "along the diagonal of their kernels. Flow outside: largest of a section, clear of the ghost "
            "nodes, over Q. Power left over: docs/numerics.md, \"Energy\". Out of roundness: largest distance "
            "of the wall from the mean radii of its rings; spread: largest radius of a ring less its "
            "smallest. Zig-zag: see the filter of the mesh.", long_run),
    Section("collapse", "Leak in collapse", values(cases.COLLAPSE),
            "The shipped cases of collapse at t = 20, while they still drain: leak over the flow half way then, "
            "and the largest of a sample, over the flow half way at its time. The order is that of the largest; the "
            "leak at one time changes its sign from grid to grid.",
            collapse),
    Section("deformability", "Deformability, Fig. 6(d)", values(cases.DEFORMABILITY),
            "Ratio 3, Hooke, spacing 0.1.", deformability),
    Section("softening", "Large inflation of a neo-Hookean tube, Fig. 6(c)",
            values(cases.SOFTENING),
            "eps = 0.01. From ratio 3 on the box is 7.6 wide and the grid coarser.", softening),
    Section("laws", "Four laws, Fig. 10", values(cases.LAWS), "Ratio 4, eps = 0.01.", laws),
    Section("refinement", "Grid refinement", values(cases.REFINEMENT),
            "As in the section on inflation, but with a rigid outlet of 0.4, which the coarsest "
            "grid needs, and to t = 16. The limit is that of the two finest grids for order 2; the order "
            "is that of the distances of the other two from it.", refinement),
    Section("womersley", "Womersley flow", values(cases.WOMERSLEY),
            "`cases/womersley.toml`, spacing 0.1: first harmonic of Q half way over the last period "
            "against Womersley's solution.", womersley),
    Section("carotid", "Carotid artery", values(cases.CAROTID),
            "`cases/carotid.toml`: pressures over the last of three heartbeats. One-dimensional: linear, "
            "about the radius and stiffness at the mean pressure by (52), with Womersley's friction (speed 6.3 m/s "
            "without pressure, 6.4 m/s at the mean), harmonic by harmonic, "
            "between the inlet's flow rate and the Windkessel. Lumped: the vessel as one compliance before "
            "the Windkessel.", carotid),
    Section("pressure_wave", "Pressure wave", values(cases.PRESSURE_WAVE),
            "`cases/pressure_wave.toml`: a pulse whose Moens-Korteweg speed is 1, between the stations "
            "x = 7 and 19, and from 19 to the outlet clamp and back. Speed: distance over the delay of "
            "the largest cross-correlation of the displacements. Theory: the displacement at the first "
            "station (for the way back: at the second, with the reflection at the clamp) is sent along "
            "the tube by the dispersion relation of docs/theory.md, with the fluid outside and "
            "viscosity, and measured in the same way. Amplitude: largest displacement over that at the "
            "first station; come back: smallest over the largest that went by.",
            pressure_wave),
    Section("oscillation", "Damped oscillation, Fig. 13", values(cases.OSCILLATION),
            "`cases/oscillation_damped.toml` at several Re: eps = 0.01, ratio 1, spacing 0.2. First swing: "
            "the first maximum of the enclosed volume less the minimum behind it, in R_0^3; period: "
            "between the first two maxima; decay time: from the first two swings. Small waves: the "
            "slowest mode of docs/theory.md, about the undeformed tube; on the stream: with its mean "
            "speed over that first period.", oscillation),
    Section("sustained", "Sustained oscillation, Fig. 14", values(cases.SUSTAINED),
            "`cases/oscillation_sustained.toml`: Re = 50, eps = 0.02, ratio 1.25, spacing 0.2; docs/waves.md "
            "has other ratios. Power left over and leak: integrals over time, over those of what enters "
            "and of |Q| half way.", sustained),
    Section("threads", "The same bits with 1 and 2 threads", values(cases.THREADS),
            "200 steps at ratio 1.5, spacing 0.1.", threads),
    Section("schemes", "Coupling schemes at ratio 1", values(cases.SCHEMES),
            "`coupling.scheme` (docs/case_file.md) at two spacings. What a step costs: "
            "docs/numerics.md, \"The axial guide\".", schemes),
    Section("filter", "Filter of the mesh", values(cases.FILTERS),
            "`wall.mesh_filter`. Zig-zag: largest amplitude of the wave of two rings in the mean radius, "
            "away from the clamps. Out of roundness: as in the section on tightness. A weaker filter leaves "
            "a roughness that takes flow; from 2 on Q does not depend on it.", filters),
    Section("speed", "Speed", [cases.INFLATION[1.5]],
            "The inflation at ratio 1.5. Meaningful only on a machine that does nothing else.",
            speed),
]
