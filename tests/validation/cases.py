"""The runs behind docs/validation.md."""
import dataclasses
import math

from runs import make_run

# Tolerance of the runs below, which leaves an error of some 0.2 % in R_max - 1. The ghost nodes
# that come and go keep Q of a steady tube moving by some 1e-4 at spacing 0.1, 5e-4 at 0.2.
STEADY = 5e-4
COARSE = dict(vessel__rigid_outlet=0.4)  # at spacing 0.2, two spacings of the outlet are rigid
LENGTH = 4 * math.pi
RELAXATIONS = 12  # a run that is not steady after so many relaxation times is stopped

# offsets of the tube's axis from the middle of the box, in spacings
OFFSETS = [(0, 0), (0.25, 0.1), (0.4, 0.3)]


def rigid(spacing, offset):
    y, z = OFFSETS[offset]
    return make_run(f"rigid-d{spacing}-o{offset}", "cases/rigid_tube.toml",
                    vessel__length=2, grid__width_y=4, grid__width_z=4, grid__spacing=spacing,
                    grid__tube_offset_y=round(y * spacing, 6),
                    grid__tube_offset_z=round(z * spacing, 6))


def inflation(ratio, spacing=0.1, law="hooke", eps=0.02, width=4.7, end_time=None, tolerance=STEADY,
              threads=0, **more):
    """The paper's inflation case with one thing or another changed."""
    label = {"wall__mesh_filter": "filter", "vessel__rigid_outlet": "outlet",
             "coupling__scheme": "", "stop__steps": "steps", "output__sample_every": "every"}
    name = f"{law}-eps{eps}-r{ratio}-d{spacing}"
    name += f"-w{width}" if width != 4.7 else ""
    name += "".join(f"-{label[key]}{value}" for key, value in more.items())
    name += f"-t{threads}" if threads else ""
    name += "-long" if tolerance < 1e-9 else ""
    settings = dict(drive__pressure_ratio=ratio, grid__spacing=spacing)
    if eps != 0.02:
        settings["wall__eps"] = eps
    if law != "hooke":
        settings["wall__law"] = law
    if width != 4.7:
        settings |= dict(grid__width_y=width, grid__width_z=width)
    settings |= dict(stop__steady_tolerance=tolerance,
                     stop__end_time=end_time or round(RELAXATIONS * 0.4 * eps * LENGTH**2, 1))
    return make_run(name, "cases/inflation.toml", threads, **(settings | more))


RIGID = {d: [rigid(d, n) for n in range(len(OFFSETS))] for d in (0.2, 0.1333, 0.1, 0.0667)}

INFLATION = {ratio: inflation(ratio) for ratio in (0.5, 1, 1.5, 3)}

DEFORMABILITY = {eps: inflation(3, eps=eps) for eps in (0.005, 0.01, 0.02)}

# Soft laws at large inflation need a wider box, and relax slowly: a factor of e takes 5 to 6 at
# ratio 4, against a window of 0.16, so that the tolerance leaves an error of 1 % in R_max - 1.
WIDE = dict(spacing=0.15, width=7.6, end_time=45, tolerance=3e-4)
SOFTENING = {2.5: inflation(2.5, law="neo-hookean", eps=0.01, end_time=20)}
SOFTENING |= {r: inflation(r, law="neo-hookean", eps=0.01, **WIDE) for r in (3, 3.5, 4)}

LAWS = {
    "neo-Hookean": SOFTENING[4],
    "Mooney-Rivlin, psi = 0.5": inflation(4, law="mooney-rivlin", eps=0.01, **WIDE),
    "Hooke, nu = 0.5": inflation(4, eps=0.01),
    "Skalak, C = 1": inflation(4, law="skalak", eps=0.01),
}

# Three times as long as it takes to be steady; never steady enough.
LONG = {(ratio, d): inflation(ratio, spacing=d, end_time=36, tolerance=1e-12)
        for ratio in (1, 3) for d in (0.13, 0.1)}

# The first steps, each of them sampled, for the leak of the transient.
START = {(ratio, d): inflation(ratio, spacing=d, output__sample_every=1, stop__steps=200)
         for ratio in (1, 3) for d in (0.13, 0.1)}

# Never steady enough: to a time at which what still changes is small beside what is compared.
REFINEMENT = {(ratio, d): inflation(ratio, spacing=d, end_time=16, tolerance=1e-12, **COARSE)
              for ratio in (1, 3) for d in (0.2, 0.13, 0.1, 0.065)}

# Tubes that collapse, before and near their steady state.
COLLAPSE = {(n, d): make_run(f"collapse{n}-d{d}", f"cases/collapse_mode{n}.toml", grid__spacing=d,
                             vessel__rigid_outlet=0.4 if n == 2 else 0.6, stop__end_time=20,
                             stop__steady_tolerance=1e-12)
            for n in (2, 3, 4, 5) for d in (0.2, 0.14, 0.1)}

THREADS = {n: inflation(1.5, threads=n, stop__steps=200) for n in (1, 2)}

SCHEMES = {(scheme, d): inflation(1, spacing=d, coupling__scheme=scheme)
           for d in (0.13, 0.1) for scheme in ("printed", "reaction", "conserving")}

# Womersley numbers; the longer transient of the third needs more periods.
WOMERSLEY = {alpha: make_run(f"womersley-a{alpha}", "cases/womersley.toml",
                             fluid__reynolds=alpha**2,
                             stop__end_time=round(2 * math.pi * (2 + alpha), 6))
             for alpha in (1, 2, 3)}

CAROTID = {"as shipped": dataclasses.replace(make_run("carotid", "cases/carotid.toml"),
                                             coarse=("grid.cells=[150,15,15]",))}


def collapse(mode, **settings):
    """A shipped tube that collapses, with one thing or another changed."""
    label = "".join(f"-{value}" for value in settings.values())
    run = make_run(f"collapse{mode}{label}", f"cases/collapse_mode{mode}.toml", **settings)
    return dataclasses.replace(run, coarse=("grid.spacing=0.25", "vessel.rigid_outlet=0.5",
                                            "grid.width_z=4"))


MODES = {n: collapse(n) for n in (2, 3, 4, 5, 6, 8)}

# On coarse grids, and in boxes that hold the two lobes, which lie along y.
TWO_LOBES = dict(vessel__rigid_outlet=0.44, grid__spacing=0.22, grid__width_y=4.4,
                 grid__width_z=3.4)
COLLAPSE_LAWS = {"Hooke, nu = 0.5": collapse(2, **TWO_LOBES),
                 "neo-Hookean": collapse(2, wall__law="neo-hookean", **TWO_LOBES),
                 "Skalak, C = 1": collapse(2, wall__law="skalak", **TWO_LOBES)}

# At Re = 50 the tube swings before it rests.
COLLAPSE_INERTIA = {(n, Re): collapse(n, fluid__reynolds=Re, grid__spacing=spacing,
                                      grid__width_y=3.8, grid__width_z=3.8,
                                      **(dict(stop__end_time=200) if Re == 50 else {}))
                    for n, numbers, spacing in ((3, (0.1, 10, 20), 0.2), (4, (0.1, 10, 50), 0.17))
                    for Re in numbers}

TUBE_LAW = dataclasses.replace(make_run("tube-law", "cases/tube_law.toml"),
                               coarse=("grid.spacing=0.25",))

RESISTOR = dataclasses.replace(make_run("resistor", "cases/starling_resistor.toml"),
                               coarse=("grid.spacing=0.25", "grid.width_z=4"))

FILTERS = {(ratio, d, s): inflation(ratio, spacing=d, end_time=16, tolerance=1e-12,
                                    wall__mesh_filter=s)
           for d, strengths in ((0.13, (0, 1, 2, 4)), (0.1, (2, 4))) for ratio in (1, 3)
           for s in strengths}


def pressure_wave(width, spacing):
    return make_run(f"pressure-wave-w{width}-d{spacing}", "cases/pressure_wave.toml",
                    grid__width_y=width, grid__width_z=width, grid__spacing=spacing,
                    output__fluid="false")


PRESSURE_WAVE = {key: pressure_wave(*key) for key in ((4.7, 0.2), (4.7, 0.15), (7, 0.2))}

# Long enough for three periods.
OSCILLATION = {Re: make_run(f"oscillation-Re{Re}", "cases/oscillation_damped.toml",
                            fluid__reynolds=Re, stop__end_time=end)
               for Re, end in ((10, 30), (25, 45), (50, 60), (75, 80), (100, 100), (125, 120))}

SUSTAINED = {"as shipped": make_run("oscillation-sustained", "cases/oscillation_sustained.toml")}
