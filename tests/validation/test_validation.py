#!/usr/bin/python3
"""Coarse runs against theory: what docs/validation.md shows on fine grids, in seconds.

usage: test_validation.py PROGRAM SCENARIO

Each bound is one and a half to two times the error that was measured (in the comment beside it):
room for a change that moves the error a little, none for one that breaks a term. What is measured
at these spacings is the error of the grid.
"""
import pathlib
import subprocess
import sys
import tempfile

import cases
import measures
from collapse import BuckledRing
from runs import SOURCE, Runner, make_run
from tightness import Tightness
from waves import Oscillation, PressureWave
from womersley import Womersley

PROGRAM, SCENARIO = sys.argv[1:3]
failures = []


def result_of(run, directory):
    runner = Runner(PROGRAM, directory, threads=1)
    if runner.make([run]):
        sys.exit(f"FAILED: {run.name} could not be run")
    return measures.Result(pathlib.Path(directory) / run.name)


def expect(what, value, low, high):
    good = low <= value <= high
    print(f"{'ok    ' if good else 'FAILED'} {what}: {value:.5f}, expected {low:g} to {high:g}")
    if not good:
        failures.append(what)


def expect_steady(result):
    if not result["converged"]:
        sys.exit(f"FAILED: {result.directory.name}: {result['reason']}")


def test_rigid(directory):
    """Poiseuille's flow rate, and its order over a factor of two in the spacing."""
    spacings = [0.2, 0.1]
    results = [result_of(cases.rigid(d, 0), directory) for d in spacings]
    for r in results:
        expect_steady(r)
    errors = [r["Q_mid"] / measures.Q_0 - 1 for r in results]
    expect("error of Q at 0.2", errors[0], -0.01, 0.01)  # -0.0064
    expect("error of Q at 0.1", errors[1], -0.0022, 0.0022)  # -0.0014
    expect("order of Q", measures.order(errors, spacings), 1.6, 3)  # 2.2; one offset only


def test_inflation(directory):
    """The main case at ratio 1 becomes steady and agrees with both theories."""
    bounds = {  # Q and R_max - 1 against the 1-D model, radius against Eq. (52), leak
        0.2: (0.018, 0.006, 0.005, 0.004),  # -0.0100, -0.0026, 0.0028, -0.0017
        0.13: (0.005, 0.003, 0.005, 0.002),  # -0.0022, -0.0002, 0.0030, -0.0004
    }
    for spacing, (Q, R, R_52, leak) in bounds.items():
        r = result_of(cases.inflation(1, spacing=spacing, end_time=25, tolerance=1e-3,
                                      **cases.COARSE), directory)
        expect_steady(r)
        expect(f"spacing {spacing}: Q against the model", r.flow_error, -Q, Q)
        expect("R_max - 1 against the model", r.displacement_error, -R, R)
        expect("radius against Eq. (52)", measures.radius_deviation(r), 0, R_52)
        expect("leak over Q", r["leak_over_Q"], -leak, leak)


def test_start(directory):
    """Little passes the wall in any of the first steps, when the drive has been switched on."""
    run = cases.inflation(1, spacing=0.13, output__sample_every=1, stop__steps=40)
    leak = Tightness(result_of(run, directory)).transient
    expect("largest leak of a step over Q_in - Q_out", leak, 0, 0.006)  # 0.0038


def test_womersley(directory):
    """Amplitude and phase of the flow in a rigid tube whose inlet pressure swings."""
    run = make_run("womersley", "cases/womersley.toml", grid__spacing=0.2, time__step=0.02)
    w = Womersley(result_of(run, directory))
    expect("amplitude", w.amplitude_error, -0.01, 0.01)  # 0.0056
    expect("phase in degrees", w.phase_error, 0, 2)  # 1.33
    expect("leak over the amplitude", w.leak, 0, 0.035)  # 0.018


def test_pressure_wave(directory):
    """A pulse travels as theory says, and comes back from the clamp with the other sign."""
    run = make_run("wave", "cases/pressure_wave.toml", grid__spacing=0.25, time__step=0.05,
                   output__fluid="false")
    w = PressureWave(result_of(run, directory))
    expect("speed over that of theory", w.speed / w.predicted_speed, 0.98, 1.05)  # 1.029
    expect("amplitude kept over that of theory", w.amplitude / w.predicted_amplitude, 0.9, 1.1)  # 1.07
    expect("speed to the clamp and back", w.return_speed / w.predicted_return_speed, 0.98, 1.06)  # 1.036
    expect("amplitude come back", w.returned, -0.76, -0.66)  # -0.709, theory -0.687


def test_oscillation(directory):
    """A tube swings after the start with the period of theory; the swing decays."""
    run = make_run("oscillation", "cases/oscillation_damped.toml", fluid__reynolds=50,
                   grid__spacing=0.25, stop__end_time=36, output__fluid="false")
    o = Oscillation(result_of(run, directory))
    expect("period over that of small waves on the stream", o.period / o.slowed_period, 0.88, 1.03)  # 0.942
    expect("decay time over that of small waves", o.decay_time / o.small_decay_time, 0.6, 1)  # 0.783


def test_laws(directory):
    """The softer the law, the wider the tube: neo-Hookean > Mooney-Rivlin > Hooke > Skalak."""
    coarse = dict(spacing=0.2, eps=0.01, vessel__rigid_outlet=0.55, end_time=15,
                  tolerance=1e-3)
    R = []
    # measured: -0.0081, -0.0085, -0.0026, -0.0009
    for law, bound in (("neo-hookean", 0.014), ("mooney-rivlin", 0.014), ("hooke", 0.005),
                       ("skalak", 0.0025)):
        r = result_of(cases.inflation(2, law=law, **coarse), directory)
        expect_steady(r)
        expect(f"{law}: R_max - 1 against the model", r.displacement_error, -bound, bound)
        R.append(r["R_max"])
    for first, second in zip(R, R[1:]):
        expect("difference of neighbouring laws", first - second, 0.005, 1)


def test_ring(_):
    """The tube law of the buckled ring as the program prints it is that of collapse.BuckledRing, which
    shares no code with it."""
    command = [PROGRAM, "theory", str(SOURCE / "cases" / "tube_law.toml"), "--csv=tube-law"]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    rows = [[float(x) for x in line.split(",")] for line in text.splitlines()[1:]]
    for n in (2, 3):
        ring, E_b = BuckledRing(n, smallest_area=0.4), 0.3
        branch = [(p / E_b, area) for lobes, p, area, *_ in rows if lobes == n and area > 0.42]
        worst = max(abs(ring.pressure(area) / p - 1) for p, area in branch)
        expect(f"n = {n}: points of the branch", len(branch), 20, 1000)
        expect(f"n = {n}: pressure against the other code", worst, 0, 5e-4)


def test_tool(directory):
    """tools/validate makes every run and every table (coarse, four steps: the numbers are void),
    makes none of them twice, and says with its exit code that checks do not hold."""
    page = pathlib.Path(directory) / "page.md"
    command = [sys.executable, str(SOURCE / "tools" / "validate"), "--binary", PROGRAM, "--out",
               directory, "--threads", "1", "--quick", "--keep", "--write", str(page), "--only",
               "rigid", "inflation", "long", "collapse", "laws", "refinement", "womersley", "threads", "schemes",
               "filter", "speed", "modes", "tube-law", "collapse-laws", "collapse-inertia", "resistor"]
    first = subprocess.run(command, capture_output=True, text=True, check=False)
    again = subprocess.run(command, capture_output=True, text=True, check=False)
    text = page.read_text(encoding="utf-8")
    expect("exit code", first.returncode, 1, 1)
    expect("runs made at first", first.stderr.count("after 4 steps"), 80, 100)
    expect("runs kept", again.stderr.count(": kept") - again.stderr.count("\n"), 0, 0)
    expect("rows without a run", text.lower().count("not run"), 0, 0)
    expect("files of 1 and 2 threads that differ", text.count("differs"), 0, 0)


with tempfile.TemporaryDirectory() as place:
    globals()[f"test_{SCENARIO}"](place)
sys.exit(1 if failures else 0)
