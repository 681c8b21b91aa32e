#!/usr/bin/python3
"""The program as a user meets it: what it prints, its exit codes and the files it leaves.

usage: test_app.py PROGRAM SOURCE_DIR SCENARIO
"""
import csv
import importlib
import inspect
import json
import math
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM = os.path.abspath(sys.argv[1])
SOURCE = pathlib.Path(sys.argv[2])
CASE = str(SOURCE / "cases" / "inflation.toml")
COARSE = [CASE, "--set", "grid.spacing=0.25", "--set", "vessel.rigid_outlet=0.55"]
SHORT = COARSE + ["--set", "stop.steps=5", "--set", "output.sample_every=2"]
SKIPPED = 77


def starling(*arguments, **environment):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                          timeout=200, env={**os.environ, **environment}, check=False)


def expect(condition, *what):
    if not condition:
        sys.exit("FAILED: " + " ".join(str(w) for w in what))


def expect_exit(result, code):
    expect(result.returncode == code, "exit code", result.returncode, "instead of", code, "\n",
           result.stdout, result.stderr)


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as stream:
        return list(csv.reader(stream))


def summary_of(directory):
    with open(directory / "summary.json", encoding="utf-8") as stream:
        return json.load(stream)


def wait_for(condition, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        expect(time.monotonic() < end, "waited in vain")
        time.sleep(0.02)


def test_help(_):
    for command in ([], ["run"], ["resume"], ["check"], ["theory"], ["cases"], ["plot"],
                    ["info"], ["export"], ["report"], ["bench"]):
        result = starling(*command, "--help")
        expect_exit(result, 0)
        expect("Usage: starling" in result.stdout, command, result.stdout)


def test_version(_):
    result = starling("--version")
    expect_exit(result, 0)
    expect(re.fullmatch(r"starling \d+\.\d+\.\d+( \(git [0-9a-f]{12,}\+?\))?\n", result.stdout),
           result.stdout)


def test_usage(directory):
    out = directory / "out"
    for arguments, words in (
            ([], "command"), (["rnu"], '"run"'), (["chekc", CASE], '"check"'),
            (["run", CASE], "--out"), (["run", "--out", out], "case"),
            (["run", CASE, "--ot", out], '"--out"'), (["run", CASE, "--out", out, "--frce"], '"--force"'),
            (["run", CASE, "--out", out, "--threads", "0"], "--threads"),
            (["run", CASE, "--out", out, "--threads", "two"], "--threads"),
            (["run", CASE, CASE, "--out", out], "unexpected"), (["plot"], "directory"),
            (["plot", directory], "no results"), (["report"], "directory"),
            (["report", directory], "no results"), (["cases", "inflaton"], '"inflation"')):
        result = starling(*arguments)
        expect_exit(result, 2)
        expect(words in result.stderr, arguments, "should say", words, "but says", result.stderr)
        expect(result.stdout == "", arguments, "printed", result.stdout)
    expect(not out.exists(), "wrong usage created", out)


def test_bad_case(directory):
    out = directory / "out"
    broken = directory / "broken.toml"
    broken.write_text("[fluid\nreynolds = 0.1\n", encoding="utf-8")
    for arguments, words in (
            ([directory / "missing.toml"], "missing.toml"), ([broken], "broken.toml"),
            ([CASE, "--set", "wall.lwa=hooke"], "law"), ([CASE, "--set", "wall.eps=-1"], "wall.eps"),
            ([CASE, "--set", "nonsense"], "nonsense")):
        for command in (["run", *arguments, "--out", out], ["check", *arguments],
                        ["theory", *arguments]):
            result = starling(*command)
            expect_exit(result, 2)
            expect(words in result.stderr, command, "should say", words, "but says", result.stderr)
    expect(not out.exists(), "a bad case created", out)


def test_cases(directory):
    names = [line.split()[0] for line in starling("cases").stdout.splitlines()[:-1]]
    expect(set(names) >= {"inflation", "inflation_neo_hookean", "rigid_tube"}, names)
    for name in names:
        copy = directory / f"{name}.toml"
        copy.write_text(starling("cases", name).stdout, encoding="utf-8")
        expect(copy.read_text(encoding="utf-8") ==
               (SOURCE / "cases" / f"{name}.toml").read_text(encoding="utf-8"), name)
        expect_exit(starling("check", copy), 0)


def test_check_and_theory(directory):
    result = starling("check", CASE)
    expect_exit(result, 0)
    for words in ("Re ", "eps", "cells", "vertices", "memory", "wave speed", "membrane stiffness",
                  "binds", "steps", "E/(1 - nu^2)"):
        expect(words in result.stdout, "check does not say", words, "\n", result.stdout)
    expect("Warning" not in result.stdout and result.stdout.endswith("The case is valid.\n"), result.stdout)
    early = starling("check", CASE, "--set", "stop.steps=50").stdout
    expect("Warning: the run ends before" in early, early)
    result = starling("theory", CASE)
    expect_exit(result, 0)
    expect("Q/Q_0" in result.stdout, result.stdout)
    result = starling("theory", CASE, "--csv")
    expect(result.stdout.startswith("x [R_0],R [R_0],P ["), result.stdout[:80])
    for words in ("Moens-Korteweg", "with the fluid outside", "slowest mode"):
        expect(words in starling("theory", CASE).stdout, "theory does not say", words)
    fast = ["theory", CASE, "--set", "fluid.reynolds=50", "--set", "drive.pressure_ratio=3"]
    expect("slowest mode" in starling(*fast).stdout, "theory without a steady model lacks waves")
    result = starling("theory", CASE, "--csv=waves")
    expect(result.stdout.startswith("omega [U_c/R_0],speed [U_c],att"), result.stdout[:80])
    expect("Buckling" not in starling("theory", CASE).stdout, "a membrane has no buckling load")
    expect_exit(starling("theory", CASE, "--csv=buckling"), 2)
    expect_exit(starling("theory", CASE, "--csv=nonsense"), 2)
    bending = ["theory", CASE, "--set", "wall.bending=0.002", "--set", "drive.pressure_external=1e4"]
    result = starling(*bending)
    expect_exit(result, 0)
    for words in ("times the case's pressures buckle it into n = ", "Tube law", "Q/Q_0"):
        expect(words in result.stdout, "theory does not say", words, "\n", result.stdout)
    expect(starling(*bending, "--csv=buckling").stdout.startswith("n [1],p_ring ["), "loads")
    unsteady = ["theory", SOURCE / "cases" / "womersley.toml"]
    expect("which this case does not give" in starling(*unsteady).stdout, starling(*unsteady).stdout)
    expect_exit(starling(*unsteady, "--csv"), 2)
    expect(starling(*bending, "--csv=tube-law").stdout.startswith("n [1],p ["), "tube law")
    expect(not list(directory.iterdir()), "check or theory wrote a file")


def test_run(directory):
    out = directory / "deep" / "out"
    result = starling("run", *SHORT, "--out", out)
    expect_exit(result, 0)
    for words in ("Ended (steps) after 5 steps", "one-dimensional model", "Time per phase",
                  f"go further: starling resume {out} --set stop.steps=10"):
        expect(words in result.stdout, "run does not say", words, "\n", result.stdout)
    expected = {"case.toml", "theory.csv", "series.csv", "profile.csv", "sections.csv", "summary.json",
                "wall.h5", "wall.xdmf", "fluid.h5", "fluid.xdmf", "frames", "checkpoints"}
    expect({p.name for p in out.iterdir()} == expected, sorted(out.iterdir()))
    check_tables(out)
    summary = summary_of(out)
    expect(summary["steps"] == 5 and summary["reason"] == "steps", summary)
    expect(summary["converged"] is False and summary["cells"] > 1000, summary)
    expect(starling("check", out / "case.toml").returncode == 0, "case.toml is not a valid case")
    expect((out / "wall.xdmf").read_text(encoding="utf-8").count("<Time ") == 2, "wall frames")
    expect((out / "fluid.xdmf").read_text(encoding="utf-8").count("<Time ") == 1, "fluid frames")
    printed = starling("check", *SHORT).stdout
    predicted = 1e6 * float(re.search(r"memory +about (\S+) MB", printed)[1])
    expect(0.95 * summary["peak_memory_bytes"] < predicted, "memory", summary, printed)
    time_line = re.search(r"time +(\S+) s on", result.stdout)
    expect(time_line and float(time_line[1]) > 0, "a run takes time", result.stdout)
    quiet = starling("run", *SHORT, "--out", directory / "quiet", "--quiet")
    expect(quiet.returncode == 0 and quiet.stdout == quiet.stderr == "", quiet)


def check_tables(out):
    series = rows_of(out / "series.csv")
    expect([row[1] for row in series[1:]] == ["0", "2", "4", "5"], series)
    document = (SOURCE / "docs" / "results.md").read_text(encoding="utf-8")
    for name in ("series.csv", "profile.csv", "sections.csv", "theory.csv"):
        for title in rows_of(out / name)[0]:
            column, unit = re.fullmatch(r"(\w+) \[(.+)\]", title).groups()
            expect(f"`{column}`" in document, column, "is not in docs/results.md")
            expect(f"| {unit} |" in document, unit, "is not in docs/results.md")
    for key in summary_of(out):
        expect(f"`{key}`" in document, key, "is not in docs/results.md")


def test_si_units(directory):
    out = directory / "out"
    result = starling("run", SOURCE / "cases" / "microchannel_si.toml", "--out", out,
                      "--set", "grid.spacing=0.1 mm", "--set", "stop.steps=5")
    expect_exit(result, 0)
    thicker = starling("resume", out, "--set", "stop.steps=6", "--set", "wall.thickness=30 um")
    expect_exit(thicker, 2)
    expect("case.toml of a run holds it in their place" in thicker.stderr, thicker.stderr)
    printed = re.search(r"flow rate in, middle, out +(\S+), (\S+), (\S+) m\^3/s", result.stdout)
    expect(printed, result.stdout)
    summary = json.loads((out / "summary.json").read_text())
    for value, key in zip(printed.groups(), ("Q_in", "Q_mid", "Q_out")):
        expect(abs(float(value) - summary[key]) <= 1e-4 * abs(summary[key]), key, value,
               summary[key])


def test_set_scale(_):
    """--set of the radius is named where it puts another key out of its range."""
    for radius, key in (("2 mm", "grid.width_y"), ("0.1 mm", "grid.spacing")):
        result = starling("check", SOURCE / "cases" / "microchannel_si.toml", "--set", f"vessel.radius={radius}")
        expect_exit(result, 2)
        expect(re.search(rf"{key}: .*--set vessel.radius has changed the scale", result.stderr), result.stderr)


def test_too_large(directory):
    out = directory / "out"
    large = [CASE, "--set", "grid.spacing=0.006"]  # 1.3e9 cells, 300 GB
    printed = starling("check", *large).stdout
    for words in ("Warning: this machine would refuse to run it", "GB are free", "but not for this machine"):
        expect(words in printed, "check does not say", words, "\n", printed)
    result = starling("run", *large, "--out", out)
    expect_exit(result, 2)
    expect("memory" in result.stderr, result.stderr)
    expect(not out.exists(), "a refused run created", out)


def test_out_of_memory(directory):
    """What the system does not give is told in one message."""
    command = f"ulimit -v 400000; exec '{PROGRAM}' run {CASE} --threads 1 --set grid.spacing=0.04 --out '{directory}/out'"
    result = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=False)
    expect_exit(result, 1)
    expect("not enough memory" in result.stderr and "ulimit" in result.stderr, result.stderr)


def test_refusal(directory):
    out = directory / "out"
    expect_exit(starling("run", *SHORT, "--out", out), 0)
    (out / "notes.txt").write_text("mine", encoding="utf-8")
    (out / "waves.png").write_text("of starling plot", encoding="utf-8")
    before = {p: (p.stat().st_mtime_ns, p.stat().st_size) for p in out.iterdir()}
    result = starling("run", *SHORT, "--out", out)
    expect_exit(result, 2)
    expect("--force" in result.stderr, result.stderr)
    expect(before == {p: (p.stat().st_mtime_ns, p.stat().st_size) for p in out.iterdir()},
           "a refused run changed something")
    expect_exit(starling("run", *SHORT, "--out", out, "--force"), 0)
    expect((out / "notes.txt").read_text(encoding="utf-8") == "mine", "--force took a foreign file")
    expect(not (out / "waves.png").exists(), "--force left a picture of the run before")


def start_long_run(out):
    run = subprocess.Popen([PROGRAM, "run", *COARSE, "--set", "stop.steps=10000000", "--set",
                            "output.sample_every=1", "--out", str(out)], stdout=subprocess.PIPE,
                           stderr=subprocess.PIPE, text=True)
    wait_for(lambda: run.poll() is not None or
             (out / "series.csv").exists() and len(rows_of(out / "series.csv")) > 3)
    expect(run.poll() is None, "the run ended by itself")
    return run


def test_interrupt(directory):
    for number in (signal.SIGINT, signal.SIGTERM):
        out = directory / number.name
        run = start_long_run(out)
        expect_exit(starling("run", *SHORT, "--out", out, "--force"), 2)  # a second run
        expect("the run is still going on" in starling("resume", out).stderr, "resumed while it runs")
        run.send_signal(number)
        printed, errors = run.communicate(timeout=60)
        expect(run.returncode == 0, number, run.returncode, errors)
        expect("interrupted" in printed and f"go on: starling resume {out}\n" in printed, printed)
        summary = summary_of(out)
        expect(summary["reason"] == "interrupted", summary["reason"])
        expect(int(rows_of(out / "series.csv")[-1][1]) == summary["steps"], "last row")
        expect((out / "profile.csv").exists(), "no profile")
    out = directory / "killed"
    run = start_long_run(out)
    run.kill()
    run.communicate()
    expect((out / "wall.xdmf").read_text(encoding="utf-8").endswith("</Xdmf>\n"), "wall.xdmf")
    expect_exit(starling("run", *SHORT, "--out", out), 2)  # results stay protected
    expect_exit(starling("run", *SHORT, "--out", out, "--force"), 0)  # the lock went with the run


FRAMES = ["--set", "output.wall_every=0.1", "--set", "output.fluid_every=0.25"]


def tables_and_frames(out):
    names = ["series.csv", "profile.csv", "sections.csv", "theory.csv", "wall.xdmf", "fluid.xdmf"]
    names += sorted(str(p.relative_to(out)) for p in (out / "frames").iterdir())
    return {name: (out / name).read_bytes() for name in names if (out / name).exists()}


def expect_same_results(whole, parts):
    a, b = tables_and_frames(whole), tables_and_frames(parts)
    expect(a.keys() == b.keys(), sorted(a.keys() ^ b.keys()))
    for name, content in a.items():
        expect(content == b[name], name, "differs from the run that never stopped")


def test_resume(directory):
    """Stopped at steps of all kinds, gone on with 1 and 2 threads: the same bytes."""
    whole, parts = directory / "whole", directory / "parts"
    long = [*COARSE, *FRAMES]
    expect_exit(starling("run", *long, "--set", "stop.steps=83", "--out", whole), 0)
    expect_exit(starling("run", *long, "--set", "stop.steps=1", "--out", parts), 0)
    spent = 0
    for n, stop in enumerate((2, 7, 10, 23, 38, 50, 51, 64, 80, 83)):
        result = starling("resume", parts, "--set", f"stop.steps={stop}", "--threads", 1 + n % 2)
        expect_exit(result, 0)
        expect("Going on from step" in result.stdout, result.stdout)
        before, spent = spent, sum(summary_of(parts)["phase_seconds"].values())
        expect(spent > before, "the time in the phases is that of the last piece")
    expect_same_results(whole, parts)
    check_cost_of_resumed(parts)
    result = starling("resume", parts, "--set", "stop.steps=200", "--set", "output.fluid_region=plane_z")
    expect_exit(result, 2)
    expect("output.fluid_region and output.fluid_stride cannot change" in result.stderr, result.stderr)
    result = starling("resume", parts, "--set", "stop.steps=200", "--set", "wall.eps=0.01")
    expect_exit(result, 2)
    expect("wall.eps: was 0.02, is 0.01" in result.stderr, result.stderr)
    check_that_it_ended(parts, "stop.steps=166")
    expect_exit(starling("resume", directory), 2)  # no checkpoint
    expect_same_results(whole, parts)  # refusals change nothing
    for name in ("steady", "end time"):
        expect(name not in starling("resume", parts).stderr, name)


def check_cost_of_resumed(out):
    """Speed is that of the whole run, not of its last piece."""
    summary = summary_of(out)
    speed = summary["cells"] * summary["steps"] / summary["wall_seconds"]
    expect(abs(summary["cell_steps_per_second"] - speed) < 1e-6 * speed, summary)


def check_that_it_ended(directory, advice):
    """To resume is refused, without saying that it goes on, with a key that does make it go on."""
    result = starling("resume", directory)
    expect_exit(result, 2)
    expect(result.stdout == "" and f"--set {advice}" in result.stderr, result.stdout, result.stderr)


def test_resume_ended(directory):
    """After each kind of end the advice of resume is one that goes on."""
    for name, ends, advice in (
            ("steady", ["stop.steady_tolerance=0.1"], "stop.steady_tolerance=0.01"),
            ("end time", ["stop.end_time=0.1"], "stop.end_time=0.2")):
        out = directory / name
        settings = [word for end in [*ends, "stop.steps="] for word in ("--set", end)]
        expect_exit(starling("run", *COARSE, *settings, "--out", out), 0)
        expect(summary_of(out)["reason"] == name, summary_of(out)["reason"])
        check_that_it_ended(out, advice)
        expect_exit(starling("resume", out, "--set", advice), 0)


def test_resume_after_wall_clock(directory):
    """The limit on real time counts from the moment of resuming: a step at least is taken."""
    out = directory / "out"
    expect_exit(starling("run", *COARSE, "--set", "stop.wall_clock=1e-6", "--set", "stop.steady_tolerance=",
                         "--set", "stop.end_time=", "--out", out), 0)
    for steps in (2, 3):
        expect_exit(starling("resume", out), 0)
        expect(summary_of(out)["reason"] == "wall clock", summary_of(out)["reason"])
        expect(summary_of(out)["steps"] == steps, summary_of(out)["steps"])


COLLAPSE = [str(SOURCE / "cases" / "collapse_mode3.toml"), "--set", "grid.spacing=0.25", "--set",
            "vessel.rigid_outlet=0.55"]

PULSATILE = [*COARSE, *(word for setting in (
    "drive.ramp=0.2", "inlet_waveform.amplitude=300", "inlet_waveform.period=1",
    "inlet_waveform.sine=[1, 0.3]", "external_waveform.amplitude=20", "external_waveform.times=[0, 0.6]",
    "external_waveform.values=[0, 1]", "external_waveform.period=0.5", "time.cycle_samples=12",
    "stop.steady_tolerance=")
    for word in ("--set", setting))]


def test_files_of_the_user(directory):
    """Files that a user has put beside those of a run stay, and do not stand in its way."""
    out = directory / "out"
    expect_exit(starling("run", *SHORT, *FRAMES, "--set", "checkpoint.steps=2", "--out", out), 0)
    names = ["checkpoints/step_0000000004_keep.h5", "checkpoints/step_mine.h5", "checkpoints/notes.new",
             "frames/wall_at_t06.vtp", "frames/wall_000009_copy.h5", "frames/breakdown_notes.txt",
             "frames/wall_best.h5"]
    for name in names:
        (out / name).write_text(name, encoding="utf-8")
    check_readable(out)
    expect_exit(starling("resume", out, "--set", "stop.steps=12"), 0)
    check_readable(out)
    expect_exit(starling("run", *SHORT, "--out", out, "--force"), 0)
    for name in names:
        expect((out / name).read_text(encoding="utf-8") == name, name)


def test_resume_anywhere(directory):
    """A tube that inflates, one that collapses and one that pulsates, each stopped at ten random
    steps: the same bytes."""
    random.seed(int(os.environ.get("STARLING_SEED", "1")))
    for name, case in (("inflation", COARSE), ("collapse", COLLAPSE), ("pulsatile", PULSATILE)):
        whole, parts = directory / (name + "_whole"), directory / name
        long = [*case, *FRAMES, "--set", "perturbation.amplitude=0.1", "--set", "perturbation.mode=3"]
        stops = sorted(random.sample(range(1, 160), 10)) + [160]
        expect_exit(starling("run", *long, "--set", "stop.steps=160", "--out", whole), 0)
        expect_exit(starling("run", *long, "--set", f"stop.steps={stops[0]}", "--out", parts), 0)
        for n, stop in enumerate(stops[1:]):
            expect_exit(starling("resume", parts, "--set", f"stop.steps={stop}", "--threads",
                                 1 + n % 2), 0)
        print(name, "stopped at", stops[:-1])
        expect_same_results(whole, parts)


def files_of(out):
    return {p.relative_to(out): p.read_bytes() for p in out.rglob("*") if p.is_file()}


def test_resume_damaged(directory):
    out = directory / "out"
    expect_exit(starling("run", *SHORT, "--set", "checkpoint.steps=2", "--out", out), 0)
    latest = (out / "checkpoints" / "latest").resolve()
    content = latest.read_bytes()
    for damaged, words in ((content[:len(content) // 2], "truncated"), (b"", "no checkpoint"),
                           (content[:9000] + b"x" + content[9001:], "damaged")):
        latest.write_bytes(damaged)
        result = starling("resume", out, "--set", "stop.steps=8")
        expect_exit(result, 2)
        expect(words in result.stderr and "--from" in result.stderr, result.stderr)
    lost = (out / "series.csv").read_bytes()
    (out / "series.csv").unlink()
    before = files_of(out)
    expect_exit(starling("resume", out, "--from", latest.parent / "step_0000000004.h5", "--set",
                         "stop.steps=8"), 2)
    expect(files_of(out) == before, "a refused resume changed something")
    (out / "series.csv").write_bytes(lost)
    (out / "wall.xdmf").unlink()
    expect("wall.xdmf: is missing" in starling("info", out).stdout, "info")
    offered = re.search(r"--from (\S+)", result.stderr)[1]
    result = starling("resume", out, "--from", offered, "--set", "stop.steps=8")
    expect_exit(result, 0)
    expect("wall.xdmf: does not list all frames" in result.stderr, result.stderr)
    expect_exit(starling("run", *SHORT, "--set", "stop.steps=8", "--out", directory / "whole"), 0)
    expect_same_results(directory / "whole", out)


def test_resume_beside_damage(directory):
    """A frame that cannot be read is told; a case.toml cut off is refused, its copy is at hand."""
    out = directory / "out"
    expect_exit(starling("run", *SHORT, *FRAMES, "--set", "output.wall_every=0.02", "--out", out), 0)
    (out / "frames" / "wall_000001.h5").unlink()
    cut = out / "frames" / "wall_000002.h5"
    cut.write_bytes(cut.read_bytes()[:5000])
    result = starling("resume", out, "--quiet", "--set", "stop.steps=7")
    expect_exit(result, 0)
    for words in ("wall_000001.h5: no such frame", "wall_000002.h5: is truncated"):
        expect(words in result.stderr, "should say", words, "but says", result.stderr)
    expect("series.csv" not in result.stderr and summary_of(out)["mean_leak_over_Q"] is not None, result.stderr)
    series = (out / "series.csv").read_text(encoding="utf-8")
    (out / "series.csv").write_text(series.replace(",2,", ",2?,", 1), encoding="utf-8")
    result = starling("resume", out, "--quiet", "--set", "stop.steps=8")
    expect_exit(result, 0)
    expect("series.csv: row 2 holds '2?'; the run goes on" in result.stderr, result.stderr)
    expect(summary_of(out)["mean_leak_over_Q"] is None, "a mean of the rows before the damaged one")
    case = out / "case.toml"
    content = case.read_bytes()
    for size in (200, content.index(b"\n[output]") + 1, content.rindex(b"\n#") + 1):
        case.write_bytes(content[:size])  # in a line, and what alone would be a valid case
        before = files_of(out)
        result = starling("resume", out, "--set", "stop.steps=9")
        expect_exit(result, 2)
        expect("the checkpoint holds the case" in result.stderr and str(case) in result.stderr, result.stderr)
        expect(files_of(out) == before, "a refused resume changed something")
    case.unlink()
    expect_exit(starling("resume", out, "--set", "stop.steps=9"), 0)
    expect_exit(starling("check", case), 0)


def start_until_the_disk_is_full(*arguments):
    """A run that now waits for room, and what it has said so far."""
    run = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                           text=True)
    said = ""
    while "trying again for a minute" not in said:
        line = run.stderr.readline()
        expect(line, "ended:", said)
        said += line
    return run, said


def without_patience(*arguments):
    """A run on a full disk, stopped while it waits for room: it ends at once."""
    run, said = start_until_the_disk_is_full(*arguments)
    run.send_signal(signal.SIGTERM)
    said += run.communicate(timeout=60)[1]
    return subprocess.CompletedProcess(arguments, run.returncode, "", said)


def check_that_it_waits_for_room(case, disk, whole):
    """Room is made while a run waits for it: it goes on as if there had always been enough."""
    filler = disk / "filler"
    filler.write_bytes(bytes(60 * 2**20 - sum(p.stat().st_size for p in disk.rglob("*") if p.is_file()) - 700_000))
    run, _ = start_until_the_disk_is_full("run", *case, "--out", disk / "patient")
    filler.unlink()
    errors = run.communicate(timeout=120)[1]
    expect(run.returncode == 0, errors)
    expect_same_results(whole, disk / "patient")


def test_directory_lost(directory):
    """Moved away while it is written to: the state is kept there. Replaced: the other run is left alone."""
    out, moved = directory / "a b", directory / "moved to"
    run = start_long_run(out)
    wait_for(lambda: len(rows_of(out / "series.csv")) > 60)
    out.rename(moved)
    errors = run.communicate(timeout=60)[1]
    expect(run.returncode == 1 and f"was moved to {moved}" in errors, run.returncode, errors)
    expect(f"go on: starling resume '{moved}'\n" in errors and not out.exists(), errors)
    expect(not (moved / ".starling.lock").exists(), "a lock is left")
    check_readable(moved)
    expect_exit(starling("resume", moved, "--set", "stop.steps=70"), 0)
    run = start_long_run(out)
    out.rename(directory / "removed")
    other = start_long_run(out)
    errors = run.communicate(timeout=60)[1]
    expect(run.returncode == 1 and "was moved" in errors, run.returncode, errors)
    expect((out / ".starling.lock").exists(), "the lock of the other run was removed")
    other.send_signal(signal.SIGTERM)
    other.communicate(timeout=60)
    expect(other.returncode == 0 and check_readable(out), "the other run")


def test_full_disk(directory):
    """A disk too small for the run: a message, no crash, what was written is whole; then on."""
    disk, whole = directory / "disk", directory / "whole"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=6m", "tmpfs", disk], check=False,
                      capture_output=True).returncode != 0:
        print("skipped: needs the right to mount a small disk")
        sys.exit(SKIPPED)
    try:
        out = disk / "out"
        case = [*COARSE, "--set", "output.wall_every=0.05", "--set", "stop.steps=60"]
        result = without_patience("run", *case, "--set", "checkpoint.steps=10", "--out", out)
        expect_exit(result, 1)
        expect("No space left on device" in result.stderr, result.stderr)
        expect(f"free space on the disk, then: starling resume {out}" in result.stderr, result.stderr)
        check_readable(out)
        expect_exit(starling("run", *case, "--out", whole), 0)
        subprocess.run(["mount", "-o", "remount,size=60m", disk], check=True)
        expect_exit(starling("resume", out), 0)
        expect_same_results(whole, out)
        check_that_it_waits_for_room(case, disk, whole)
    finally:
        subprocess.run(["umount", disk], check=True)


def test_full_disk_at_the_end(directory):
    """The last checkpoint does not fit: the smaller results are written; a breakdown is told."""
    disk, whole = directory / "disk", directory / "whole"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=3m", "tmpfs", disk], check=False,
                      capture_output=True).returncode != 0:
        print("skipped: needs the right to mount a small disk")
        sys.exit(SKIPPED)
    try:
        out, filler = disk / "out", disk / "filler"
        filler.write_bytes(bytes(2 * 2**20))
        result = starling("run", *SHORT, "--set", "output.fluid=false", "--quiet", "--out", out)
        expect_exit(result, 1)
        for words in ("has ended (steps)", "step_0000000005.h5", "No space left", "--force"):
            expect(words in result.stderr, "should say", words, "but says", result.stderr)
        expect(summary_of(out)["steps"] == 5, "summary")
        check_tables(out)
        check_readable(out)
        result = starling("run", *COARSE, "--set", "time.step=0.06", "--set", "output.fluid=false",
                          "--set", "checkpoint.steps=20", "--quiet", "--out", out, "--force")
        expect_exit(result, 3)
        for words in ("the run goes on", "warning: cannot write", "try: a smaller time step", "(vertex"):
            expect(words in result.stderr, "should say", words, "but says", result.stderr)
        expect(summary_of(out)["reason"].startswith("numerical error"), "summary")
        subprocess.run(["mount", "-o", "remount,size=9m", disk], check=True)
        filler.write_bytes(bytes(4 * 2**20))
        case = [*SHORT, "--set", "output.wall_every=0.02", "--set", "checkpoint.keep=1"]
        result = starling("run", *case, "--set", "checkpoint.steps=3", "--out", out, "--force")
        expect_exit(result, 1)
        expect(f"starling resume {out}" in result.stderr, result.stderr)
        filler.unlink()
        expect_exit(starling("resume", out), 0)
        expect_exit(starling("run", *case, "--out", whole), 0)
        expect_same_results(whole, out)
    finally:
        subprocess.run(["umount", disk], check=True)


def test_flushed(directory):
    """Rows and frames that belong to a checkpoint are on the disk itself before it has its name."""
    calls, out = directory / "calls", directory / "out"
    trace = subprocess.run(["strace", "-f", "-y", "-e", "trace=fsync,rename", "-o", calls, PROGRAM, "run",
                            *SHORT, *FRAMES, "--set", "output.wall_every=0.05", "--set", "checkpoint.steps=3",
                            "--out", out], capture_output=True, check=False) if have_strace() else None
    if trace is None:
        print("skipped: strace is not installed or not allowed")
        sys.exit(SKIPPED)
    expect(trace.returncode == 0, trace.stderr)
    flushed = set()
    for line in calls.read_text().splitlines():
        if done := re.search(r"fsync\(\d+<(.+)>\) += 0", line):
            flushed.add(str(pathlib.Path(done[1]).relative_to(out.resolve())))
        if "step_0000000003.h5.new" in line and "rename" in line:
            break
    expect(flushed >= {"series.csv", "frames", "frames/wall_000000.h5", "frames/fluid_000000.h5", ".",
                       "checkpoints/sound_0000000003.h5.new", "checkpoints/step_0000000003.h5.new"}, flushed)
    last = calls.read_text()[calls.read_text().rindex("summary.json.new"):]
    for name in ("summary.json", "profile.csv", "sections.csv", "fluid_000001.h5"):
        expect(re.search(rf"fsync\(\d+<[^>]*{name}>\)", last), name, last)


def have_strace():
    try:
        return subprocess.run(["strace", "-f", "true"], capture_output=True, check=False).returncode == 0
    except FileNotFoundError:
        return False


def test_kill_at_the_end(directory):
    """Killed after the last checkpoint, before the last results: resuming writes them."""
    out = directory / "out"
    expect_exit(starling("run", *SHORT, *FRAMES, "--out", directory / "whole"), 0)
    expect_exit(starling("run", *SHORT, *FRAMES, "--out", out), 0)
    (out / "summary.json").unlink()
    (out / "profile.csv").unlink()
    last = sorted((out / "frames").iterdir())[-1]
    (out / "frames" / (last.name + ".new")).write_bytes(last.read_bytes()[:1000])
    expect_exit(starling("resume", out), 0)
    expect_same_results(directory / "whole", out)
    expect(summary_of(out)["steps"] == 5, summary_of(out))


def test_kill(directory):
    """Killed at random moments and resumed each time: the same bytes, nothing lost."""
    out = directory / "killed"
    stop = ["--set", "stop.steps=400"]
    case = [*COARSE, *FRAMES, "--set", "checkpoint.steps=7"]
    expect_exit(starling("run", *case, *stop, "--out", directory / "whole"), 0)
    random.seed(int(os.environ.get("STARLING_SEED", "1")))
    arguments, kills = ["run", *case, *stop, "--out", out], 0
    for _ in range(int(os.environ.get("STARLING_KILLS", "10"))):
        run = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE)
        time.sleep(random.uniform(0.02, 0.5))
        run.kill()
        errors = run.communicate()[1].decode()
        if run.returncode != -signal.SIGKILL:
            expect(run.returncode in (0, 2) and ("nothing to do" in errors or not errors), errors)
            break
        kills += 1
        if (out / "checkpoints" / "latest").exists():
            arguments = ["resume", out]
        elif out.exists():
            arguments = ["run", *case, *stop, "--out", out, "--force"]
        if check_readable(out) is not None and (out / "wall.xdmf").exists():
            check_last_frame(out)
    print("killed", kills, "times")
    result = starling(*arguments)
    expect(result.returncode == 0 or "nothing to do" in result.stderr, result.stderr)
    expect_same_results(directory / "whole", out)
    expect(not list(out.rglob("*.new")), list(out.rglob("*.new")))


def check_last_frame(out):
    """The frames go up to where the run was killed: at most one and a step behind the last row."""
    rows = rows_of(out / "series.csv")
    times = [float(t) for t in re.findall('<Time Value="([^"]+)"', (out / "wall.xdmf").read_text())]
    if len(rows) > 1:
        last, dt = float(rows[-1][0]), float(rows[-1][2])
        expect(times[-1] >= last - 0.1 - dt, "frames up to", times[-1], "of", last)


def check_readable(out):
    """Every frame that wall.xdmf names is there, and all that is there is whole."""
    xdmf = out / "wall.xdmf"
    if xdmf.exists():
        text = xdmf.read_text(encoding="utf-8")
        expect(text.endswith("</Xdmf>\n"), "wall.xdmf")
        for name in set(re.findall(r">([^<:]+\.h5):", text)):
            expect((out / name).exists(), name, "is missing")
    result = starling("info", out)
    if "no results" in result.stderr or "no such file" in result.stderr:
        return None  # killed before there was anything
    expect_exit(result, 0)
    expect("All files are whole." in result.stdout, result.stdout)
    return result.stdout


def test_info(directory):
    out = directory / "out"
    expect_exit(starling("run", *SHORT, *FRAMES, "--set", "checkpoint.steps=2", "--out", out), 0)
    printed = check_readable(out)
    for words in ("ended (steps)", "steps 0 to 5", "2 frames, t = 0, 0.1", "checkpoints   3",
                  f"Go further: starling resume {out} --set stop.steps=10"):
        expect(words in printed, "info does not say", words, "\n", printed)
    latest = starling("info", out / "checkpoints" / "latest").stdout
    expect("step 5" in latest and "whole" in latest and "Inflation" in latest, latest)
    frame = starling("info", out / "frames" / "wall_000001.h5").stdout
    for words in ("a frame of the wall", "points", "vectors", "R_0", "whole"):
        expect(words in frame, "info does not say", words, "\n", frame)
    index = starling("info", out / "wall.h5")
    expect_exit(index, 0)
    expect("2 frames, t = 0, 0.1" in index.stdout and "whole" in index.stdout, index.stdout)
    for path in (out / "series.csv", directory, directory / "none"):
        expect_exit(starling("info", path), 2)


def check_missing(out, path):
    """A file that must be there is missed; that to resume is advised only where it is not refused."""
    path.unlink()
    result = starling("info", out)
    expect_exit(result, 2)
    expect(f"  {path.name}: is missing" in result.stdout, path, "\n", result.stdout)
    if path.name == "series.csv":
        expect("To resume is not possible: " in result.stdout, result.stdout)
        expect("series.csv: is missing" in starling("resume", out, "--set", "stop.steps=9").stderr, path)
    else:
        expect("starling resume" in result.stdout, path, result.stdout)


def test_info_damaged(directory):
    """Each damaged file is found, named, and the checkpoint that is whole is offered."""
    out = directory / "out"
    expect_exit(starling("run", *SHORT, *FRAMES, "--set", "checkpoint.steps=2", "--out", out), 0)
    whole = {p: p.read_bytes() for p in out.rglob("*") if p.is_file() and not p.is_symlink()}
    latest = (out / "checkpoints" / "latest").resolve()
    for path, content in whole.items():
        half = len(content) // 2 + 1
        if path.name == "case.toml":  # at the end of a line
            half = content.index(b"\n[output]") + 1
        path.write_bytes(content[:half])
        result = starling("info", out)
        expect_exit(result, 2)
        expect(f"{path.relative_to(out)}: " in result.stdout, path, "\n", result.stdout)
        if path.suffix == ".csv" and path.name != "series.csv":
            path.write_bytes(content[:content.rindex(b"\n", 0, half) + 1])  # at the end of a line
            expect_exit(starling("info", out), 2)
        if path.parent == out and path.name != "summary.json":  # without that it has not ended
            check_missing(out, path)
        if path == latest:
            expect("--from" in result.stdout, result.stdout)
        if path.parent.name in ("frames", "checkpoints"):
            result = starling("info", path)
            expect_exit(result, 2)
            expect("truncated" in result.stdout, result.stdout)
        path.write_bytes(content)
    (out / "frames" / "wall_000001.h5").unlink()
    expect("wall.xdmf: names frames/wall_000001.h5, which is missing" in
           starling("info", out).stdout, "missing frame")


def test_info_while_running(directory):
    out = directory / "out"
    run = start_long_run(out)
    expect("a run is writing to it now" in starling("info", out).stdout, "running")
    run.kill()
    run.communicate()
    printed = check_readable(out)
    expect("has not ended" in printed, printed)


def test_export(directory):
    out = directory / "out"
    expect_exit(starling("run", *SHORT, *FRAMES, "--set", "stop.steps=8", "--out", out), 0)
    t = summary_of(out)["t"]
    for name, arguments, words in (
            ("wall.vtp", [], f"the wall at t = {t:.6g} R_0/U_c, step 8"),
            ("early.vtp", ["--time", "0.09"], "t = 0.1 R_0/U_c, step 5, the frame nearest to the 0.09"),
            ("exact.csv", ["--time", "0.1"], "exactly the time asked for"),
            ("late.vtp", ["--time", "1e300"], "step 8, the frame nearest to the 1e300"),
            ("first.csv", ["--time=-1e300"], "step 0, the frame nearest to the -1e300"),
            ("fluid.vti", [], "pressure [rho U_c^2], velocity [U_c]"),
            ("fluid.csv", ["--what", "fluid"], "the fluid at")):
        result = starling("export", out, "--out", directory / name, *arguments)
        expect_exit(result, 0)
        expect(words in result.stdout, name, "should say", words, "but says", result.stdout)
        expect((directory / name).stat().st_size > 1000, name)
    rows = rows_of(directory / "exact.csv")
    expect(len(rows) == summary_of(out)["vertices"] + 1 and rows[0][0] == "x [R_0]", rows[0])
    expect(len(rows_of(directory / "fluid.csv")) == summary_of(out)["cells"] + 1, "cells")
    one = starling("export", out / "frames" / "wall_000000.h5", "--out", directory / "first.vtp")
    expect("t = 0 R_0/U_c, step 0" in one.stdout, one.stdout, one.stderr)
    one = starling("export", out / "frames" / "fluid_000000.h5", "--out", directory / "fluid_first.csv")
    expect("the fluid at t = 0 " in one.stdout, one.stdout, one.stderr)
    before = (directory / "wall.vtp").read_bytes()
    for arguments, words in (
            (["--out", directory / "wall.vtp"], "--force"), (["--out", directory / "a.vtk"], ".vtp"),
            (["--out", directory / "a.vtp", "--what", "fluid"], "hold the wall"),
            (["--out", directory / "a.vtp", "--time", "soon"], "number"),
            (["--out", directory / "a.vtp", "--time", "nan"], "number")):
        result = starling("export", out, *arguments)
        expect_exit(result, 2)
        expect(words in result.stderr, arguments, "should say", words, "but says", result.stderr)
    expect_exit(starling("export", directory, "--out", directory / "a.vtp"), 2)
    expect(not (directory / "a.vtp").exists(), "a refused export wrote a file")
    expect((directory / "wall.vtp").read_bytes() == before, "a refused export replaced a file")
    expect_exit(starling("export", out, "--out", directory / "wall.vtp", "--force"), 0)
    last = sorted((out / "frames").glob("wall_*.h5"))[-1]
    last.write_bytes(last.read_bytes()[:5000])
    passed = starling("export", out, "--out", directory / "wall.vtp", "--force")
    expect(f"passed over: {last}: is truncated" in passed.stdout, passed.stdout)


def test_read_only(directory):
    """A directory that cannot be written to: a message, and nothing changes."""
    disk = directory / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=30m", "tmpfs", disk], check=False,
                      capture_output=True).returncode != 0:
        print("skipped: needs the right to mount a small disk")
        sys.exit(SKIPPED)
    try:
        out = disk / "out"
        expect_exit(starling("run", *SHORT, "--out", out), 0)
        subprocess.run(["mount", "-o", "remount,ro", disk], check=True)
        before = {p: p.stat().st_mtime_ns for p in disk.rglob("*")}
        for arguments in (["run", *SHORT, "--out", disk / "new"],
                          ["run", *SHORT, "--out", out, "--force"],
                          ["resume", out, "--set", "stop.steps=9"]):
            result = starling(*arguments)
            expect_exit(result, 2)
            expect("Read-only file system" in result.stderr, result.stderr)
            expect(str(disk) in result.stderr, "the directory is not named", result.stderr)
        expect_exit(starling("export", out, "--out", disk / "wall.vtp"), 1)
        expect(before == {p: p.stat().st_mtime_ns for p in disk.rglob("*")}, "something changed")
        check_readable(out)  # reading needs no right to write
        expect_exit(starling("export", out, "--out", directory / "wall.vtp"), 0)
    finally:
        subprocess.run(["umount", disk], check=True)


def test_numerical_error(directory):
    out = directory / "out"
    result = starling("run", *COARSE, "--set", "time.step=3", "--set", "stop.steps=1000", "--out",
                      out)
    expect_exit(result, 3)
    for words in ("try: a smaller time step", f"look: starling plot {out} draws {out}/breakdown.png"):
        expect(words in result.stderr, result.stderr)
    summary = summary_of(out)
    expect(summary["converged"] is False, summary)
    expect(summary["reason"].startswith("numerical error"), summary["reason"])
    expect(len(rows_of(out / "series.csv")) >= 2, "no sample")
    for name in ("profile.csv", "wall.xdmf", "fluid.xdmf"):
        expect((out / name).exists(), "no", name, "of the last sound state")
    profile = rows_of(out / "profile.csv")
    shear = 2  # columns of a cycle, which a steady drive has not
    expect(all(math.isfinite(float(value)) for row in profile[1:] for value in row[:-shear]),
           profile[1])
    frame = float(re.findall('<Time Value="([^"]+)"', (out / "fluid.xdmf").read_text())[-1])
    expect(frame == summary["t"], "the summary and the last frame are of different states")
    place = summary["breakdown"]
    expect(0 <= place["x"] <= 12.6 and abs(place["y"]) < 3 and abs(place["z"]) < 3, place)
    for name in ("breakdown_wall.xdmf", "breakdown_fluid.xdmf"):
        times = [float(t) for t in re.findall('<Time Value="([^"]+)"', (out / name).read_text())]
        expect(len(times) == 2 and times[0] == summary["t"] < times[1], name, times)
    part = starling("info", out / "frames" / "breakdown_wall_000001.h5").stdout
    for words in ("displacement", "elastic_force", "whole"):
        expect(words in part, part)
    expect_exit(starling("info", out), 0)
    if have_plot_packages():
        expect_exit(starling("plot", out), 0)
        expect((out / "breakdown.png").read_bytes().startswith(b"\x89PNG"), "no picture")
    expect_exit(starling("resume", out, "--set", "time.step=auto", "--accept-changes", "--set",
                         "stop.steps=3"), 0)
    expect(not list(out.glob("breakdown*")) and summary_of(out)["breakdown"] is None,
           "a run that went on keeps the breakdown")
    result = starling("check", *COARSE, "--set", "time.step=3")
    expect_exit(result, 0)
    expect("Warning" in result.stdout and "membrane stiffness" in result.stdout, result.stdout)


def test_breakdown_keeps_checkpoints(directory):
    """Those newer than the last sound state stay, and each is one to go on from."""
    out = directory / "out"
    expect_exit(starling("run", *COARSE, "--set", "output.wall_every=0.7", "--set", "time.step=0.07", "--set", "checkpoint.steps=10",
                         "--out", out), 3)
    folder = out / "checkpoints"
    steps = checkpoint_steps(folder)
    last = steps[-1]
    expect(steps[0] == 0 and steps[-2:] == [last - 10, last] and last >= 20, steps)
    expect((folder / "latest").resolve().name == checkpoint_name(last), "latest")
    expect(summary_of(out)["t"] == 0, "the summary is of the last sound state")
    expect(int(rows_of(out / "series.csv")[-1][1]) == last, "rows up to the breakdown")
    for source, step in (([], last), (["--from", folder / checkpoint_name(last - 10)], last - 10)):
        result = starling("resume", out, *source, "--set", "time.step=0.01", "--accept-changes", "--set",
                          f"stop.steps={step + 3}")
        expect_exit(result, 0)
        expect(f"Going on from step {step}" in result.stdout, result.stdout)
        check_readable(out)
    expect(checkpoint_steps(folder) == [last - 10, last - 7], checkpoint_steps(folder))


def checkpoint_name(step):
    return f"step_{step:010}.h5"


def checkpoint_steps(folder):
    return sorted(int(p.stem.split("_")[1]) for p in folder.glob("step_*"))


def test_end_time(directory):
    out = directory / "out"
    expect_exit(starling("run", *COARSE, "--set", "stop.end_time=0.2", "--set",
                         "output.wall_every=0.07", "--out", out), 0)
    expect(summary_of(out)["t"] == 0.2, summary_of(out)["t"])
    times = [float(t) for t in re.findall('<Time Value="([^"]+)"', (out / "wall.xdmf").read_text())]
    expect(times == [0, 0.07, 0.14, 0.2], times)


def test_warnings(directory):
    out = directory / "out"
    result = starling("run", *SHORT, "--set", "drive.pressure_ratio=0.01", "--set",
                      "drive.pressure_inlet=500", "--set", "coupling.scheme=printed", "--set",
                      "stop.steps=100", "--out", out)
    expect_exit(result, 0)
    leak = summary_of(out)["leak_over_Q"]
    expect(abs(leak) > 0.02, "this case no longer leaks: ", leak)
    for words in ("leak through the wall", "steady"):
        expect(any(words in w for w in summary_of(out)["warnings"]), words)
        expect(re.search(f"Warning: .*{words}", result.stdout), result.stdout)


def test_numerical_error_in_si(directory):
    """When and where come in the units of the case."""
    out = directory / "out"
    result = starling("run", SOURCE / "cases" / "microchannel_si.toml", "--set",
                      "grid.spacing=0.1 mm", "--set", "time.step=40 ms", "--out", out)
    expect_exit(result, 3)
    reason = summary_of(out)["reason"]
    found = re.match(r"numerical error: step (\d+), t = (\S+) s: .*", reason)
    expect(found and abs(float(found[2]) - 0.04 * int(found[1])) < 1e-6, reason)
    expect("time.step=auto" in reason, "no remedy for a fixed step", reason)
    place = re.search(r"at x = (\S+), y = \S+, z = \S+ m, theta = -?\d+ degrees \((vertex|cell) ", reason)
    expect(place and 0 <= float(place[1]) <= 6.28e-3, reason)
    expect("term: membrane stiffness" in reason, "the term is not named", reason)


def test_threads(directory):
    for threads in (1, 2):
        expect_exit(starling("run", *SHORT, "--set", "stop.steps=20", "--threads", threads,
                             "--out", directory / str(threads)), 0)
        expect(summary_of(directory / str(threads))["threads"] == threads, "threads")
    expect_same_results(directory / "1", directory / "2")


def check_axes_of_plots(out):
    """Pictures in SI use prefixes, and Hooke's law of Laplace beside another wall says so."""
    sys.path.insert(0, str(SOURCE / "tools"))
    sys.dont_write_bytecode = True
    plot = importlib.import_module("plot_run")
    for unit, largest, expected, drawn in (
            ("s", 0.037, "ms", 37), ("s", 3.7, "s", 3.7), ("m", 5.8e-4, "µm", 580),
            ("m^3/s", 5e-8, "µl/s", 50), ("Pa", 9e4, "kPa", 90), ("m", 0, "m", 0),
            ("R_0", 1e-4, "R_0", 1e-4), ("m", float("nan"), "m", None)):
        axis = plot.Axis(unit, [largest, largest / 2])
        expect(axis.unit == expected, unit, largest, "is drawn in", axis.unit)
        expect(drawn is None or abs(axis(largest) - drawn) < 1e-9 * drawn + 1e-12, axis(largest))
    expect(plot.law_of(out) == "hooke", plot.law_of(out))
    expect("Hooke" not in plot.laplace_label("hooke"), plot.laplace_label("hooke"))
    expect("Hookean wall" in plot.laplace_label("skalak"), plot.laplace_label("skalak"))


def check_shapes_of_plots(out):
    """History shows how a tube collapses; flow covers what lies just outside the wall."""
    plot, np = importlib.import_module("plot_run"), importlib.import_module("numpy")
    for narrowest, widest, expected in ((0.99, 1.3, ["radius"]), (0.6, 1, ["narrowest", "waves"]),
                                        (0.6, 1.1, ["radius", "narrowest", "waves"])):
        series = {"min_area_ratio": np.array([1, narrowest]), "R_max": np.array([1, widest])}
        names = [draw.__name__ for draw in plot.shape_panels(out, series)]
        expect(names == expected, narrowest, widest, names)
    x, theta = (a.ravel() for a in np.meshgrid([0, 1, 2], np.arange(40) * np.pi / 20))
    rest = np.stack([x, np.cos(theta), np.sin(theta)], axis=1)
    away = rest * [0, 1, 1] * (0.1 * x * np.cos(3 * theta))[:, None]
    waves = plot.largest_waves({"points": rest + away, "displacement": away}, range(2, 6))
    expect(np.allclose(waves, [0, 0.2, 0, 0], atol=1e-12), waves)
    wall = [np.array([[0, y], [4, y]]) for y in (-1.0, 1.0)]
    inside = plot.inside_wall(np.array([1, 3.5]), np.array([-1.5, -0.5, 0.9, 1.1]), wall)
    expect(inside.tolist() == [[False] * 2, [True] * 2, [True] * 2, [False] * 2], inside)
    point = np.zeros((7, 9), dtype=bool)
    point[3, 4] = True
    expect(plot.widened(point, 2).sum() == 13, plot.widened(point, 2))


def check_wall_history(out):
    """The rings of the last frame are those of profile.csv."""
    plot, np = importlib.import_module("plot_run"), importlib.import_module("numpy")
    t, x, radii, pressures, units = plot.wall_history(out / "wall.h5")
    profile = plot.read(out, "profile.csv")
    expect(np.allclose(t[:3], [0, 0.01, 0.02]), t)
    expect(radii.shape == pressures.shape == (len(t), len(x)), radii.shape)
    expect(np.allclose(x, profile["x"], atol=1e-5), x)
    expect(np.allclose(radii[-1], profile["R_mean"], atol=1e-6), radii[-1])
    expect(np.allclose(pressures[-1], profile["P_transmural"], rtol=1e-4, atol=1), pressures[-1])
    expect(units == ("R_0", "rho U_c^2"), units)


def have_plot_packages():
    return subprocess.run(["/usr/bin/python3", "-c", "import matplotlib, h5py, numpy"],
                          capture_output=True, check=False).returncode == 0


def test_fluid_region(directory):
    """Smaller frames of the fluid: named in the case as run, and pictures are drawn of them."""
    sizes = {}
    for region in ("box", "tube", "plane_y", "plane_z"):
        out = directory / region
        expect_exit(starling("run", *SHORT, "--set", f"output.fluid_region={region}", "--set",
                             f"output.fluid_stride={2 if region == 'plane_z' else 1}", "--out", out), 0)
        sizes[region] = (out / "frames" / "fluid_000000.h5").stat().st_size
        printed = starling("info", out / "frames" / "fluid_000000.h5").stdout
        cells = {"plane_y": "18 x 1 x 50", "plane_z": "1 x 9 x 25"}.get(region, "18 x 18 x 50")
        expect(f" {cells} vectors" in printed, region, printed)
        expect(("not finite" in printed) == (region == "tube"), region, printed)
        if have_plot_packages():
            result = starling("plot", out)
            expect(result.returncode == 0 and result.stderr == "", result.stderr)
    expect(sizes["plane_z"] < sizes["plane_y"] < sizes["tube"] < sizes["box"] / 3, sizes)


def test_plot(directory):
    if not have_plot_packages():
        print("skipped: python3-matplotlib, python3-numpy or python3-h5py is not installed")
        sys.exit(SKIPPED)
    out = directory / "out"
    expect_exit(starling("run", *SHORT, "--out", out), 0)
    result = starling("plot", out)
    expect_exit(result, 0)
    expect(result.stderr == "", result.stderr)
    check_axes_of_plots(out)
    check_shapes_of_plots(out)
    for name in ("history.png", "profiles.png", "tube.png", "flow.png"):
        expect((out / name).read_bytes().startswith(b"\x89PNG"), name)
    expect(not (out / "waves.png").exists(), "a picture over time of two frames")
    (out / "tube.png").unlink()
    (out / "tube.png").mkdir()  # cannot be written
    result = starling("plot", out)
    expect(result.returncode != 0 and "cannot write" in result.stderr, result.stderr)
    expect(not list(out.glob("*.png.new")), "left over")
    (out / "tube.png").rmdir()
    (out / "profile.csv").unlink()  # as after a kill
    (out / "summary.json").unlink()
    expect_exit(starling("plot", out), 0)
    often = directory / "often"
    expect_exit(starling("run", *SHORT, "--set", "stop.steps=13", "--set", "output.wall_every=0.01",
                         "--out", often), 0)
    expect("waves.png" in starling("plot", often).stdout, "no waves.png")
    check_wall_history(often)


FLUID_PHASES = ["momentum", "pressure"]
COUPLED_PHASES = ["wall force", "element search", "ghost nodes", "spread", *FLUID_PHASES, "wall motion"]


def check_timing(timing, repeats):
    expect(len(timing["repeats"]) == repeats, timing)
    expect(0 < timing["min"] == min(timing["repeats"]) <= timing["median"] <= max(timing["repeats"]),
           timing)


def check_bench_row(row, bench):
    phases = row["phase_seconds_per_step"]
    expect(list(phases) == (FLUID_PHASES if row["wall"] == "none" else COUPLED_PHASES), phases)
    step = row["seconds_per_step"]
    for timing in (step, *phases.values()):
        check_timing(timing, 2)
    for n, seconds in enumerate(step["repeats"]):
        parts = sum(p["repeats"][n] for p in phases.values())
        expect(math.isclose(parts, seconds, rel_tol=1e-9), row)
    rate = row["cell_steps_per_second"]
    expect(math.isclose(rate["max"], row["cells"] / step["min"]), row)
    expect(math.isclose(rate["median"], row["cells"] / step["median"]), row)
    triad = {t["threads"]: t["bytes_per_second"]["max"] for t in bench["machine"]["triad"]}
    share = rate["max"] * bench["traffic"]["bytes_per_cell_step"] / triad[row["threads"]]
    expect(math.isclose(row["share_of_bandwidth_bound"], share), row)
    check_bench_memory(row)


def check_bench_memory(row):
    cells, vertices = math.prod(row["grid"]), row["vertices"]
    expect(row["cells"] == cells and row["allocated_bytes"] > 100 * cells, row)
    if row["wall"] == "none":
        expect(vertices == 0 and row["bytes_per_vertex"] is None, row)
    else:
        expect(abs(vertices / float(row["wall"]) - 1) < 0.1 and row["bytes_per_vertex"] > 100, row)
    parts = cells * row["bytes_per_cell"] + vertices * (row["bytes_per_vertex"] or 0)
    expect(math.isclose(parts, row["allocated_bytes"], rel_tol=1e-6), row)


def test_bench(directory):
    """The table and the JSON of a small measurement; no speed is asked for."""
    path = directory / "bench.json"
    result = starling("bench", "--quick", "--grid", "32x24x24", "--grid", "24x20x18", "--wall", "none",
                      "--wall", "950", "--threads", "1", "--threads", "2", "--repeats", "2",
                      "--json", path)
    expect_exit(result, 0)
    bench = json.loads(path.read_text(encoding="utf-8"))
    expect(bench["format"] == "starling bench 1" and bench["version"] in starling("--version").stdout,
           bench)
    expect([t["threads"] for t in bench["machine"]["triad"]] == [1, 2], bench["machine"])
    passes = sum(k["reads"] + k["writes"] for k in bench["traffic"]["kernels"])
    expect(8 * passes == bench["traffic"]["bytes_per_cell_step"], bench["traffic"])
    expect([(r["grid"], r["wall"], r["threads"]) for r in bench["rows"]] ==
           [(g, w, t) for g in ([32, 24, 24], [24, 20, 18]) for w in ("none", "950") for t in (1, 2)],
           bench["rows"])
    for row in bench["rows"]:
        check_bench_row(row, bench)
        expect(f"{row['cell_steps_per_second']['max'] / 1e6:.1f} M cell-steps/s" in result.stdout,
               result.stdout)
    for words in ("4 of 4: 24x20x18, wall of 950", "in-place triad, 2 threads", "24x20x18, fluid alone",
                  *COUPLED_PHASES):
        expect(words in result.stdout, words, result.stdout)


def test_bench_refusal(directory):
    missing = directory / "missing" / "bench.json"
    for arguments, words in (
            (["--grid", "32x24"], '"32x24"'), (["--grid", "32x24x0"], "from 16"),
            (["--grid", "32x24x24x24"], "NXxNYxNZ"), (["--grid", "16x96x96"], "too short"),
            (["--wall", "many"], '"many"'), (["--wall", "199"], "from 200"), (["--wall", "-k"], '"-k"'),
            (["--grid", "90000x20000x20000"], "GB are free"), (["--json", missing], str(missing)),
            (["--threads", "0"], "--threads"), (["--repeats", "0"], "--repeats"), (["--qick"], '"--quick"')):
        result = starling("bench", "--quick", *arguments)
        expect_exit(result, 2)
        expect(words in result.stderr, arguments, "should say", words, "but says", result.stderr)
        expect(result.stdout == "", arguments, "printed", result.stdout)


def bench_file(path, scale, **changes):
    """A file of `starling bench` with made-up times."""
    def timing(seconds):
        return {"min": min(seconds), "median": sorted(seconds)[1], "repeats": seconds}

    row = {"grid": [32, 24, 24], "wall": "none", "threads": 1, "bytes_per_cell": 120,
           "cell_steps_per_second": {"max": 1e7 / scale, "median": 1e7 / scale},
           "seconds_per_step": timing([scale * s for s in (0.10, 0.13, 0.11)]),
           "phase_seconds_per_step": {"momentum": timing([0.05, 0.06, 0.07]),
                                      "pressure": timing([scale * s for s in (0.04, 0.045, 0.05)])}}
    triad = {"threads": 1, "bytes_per_second": {"max": 2e10, "median": 1.9e10}}
    bench = {"format": "starling bench 1", "version": "0", "rows": [{**row, **changes}],
             "machine": {"processors": 2, "load_before": 0, "load_after": 0, "triad": [triad]}}
    path.write_text(json.dumps(bench), encoding="utf-8")
    return path


def compare_bench(*files):
    return subprocess.run(["/usr/bin/python3", SOURCE / "tools" / "compare_bench", *files],
                          capture_output=True, text=True, check=False)


def test_compare_bench(directory):
    before = bench_file(directory / "before.json", 1)
    slower = bench_file(directory / "slower.json", 1.4)
    a_little = bench_file(directory / "a_little.json", 1.2)
    result = compare_bench(before, slower)
    expect_exit(result, 0)
    lines = {line.split()[0]: line for line in result.stdout.splitlines()}
    expect(lines["step"].split()[1:] == ["100.000", "140.000", "1.400", "1.400", "slower"], lines)
    expect(lines["momentum"].split()[3:] == ["1.000", "1.000"], lines)
    expect(lines["pressure"].endswith("slower"), lines)
    expect("10.0 M cell-steps/s -> 7.1 M cell-steps/s" in result.stdout, result.stdout)
    expect("faster" in compare_bench(slower, before).stdout, "the other way round")
    within = compare_bench(before, a_little).stdout
    expect("slower" not in within and "1.200" in within, within)
    expect_exit(starling("bench", "--quick", "--repeats", "1", "--json", directory / "real.json"), 0)
    itself = compare_bench(directory / "real.json", directory / "real.json")
    expect_exit(itself, 0)
    expect("wall motion" in itself.stdout and "slower" not in itself.stdout, itself.stdout)
    other = bench_file(directory / "other.json", 1, threads=2)
    broken = directory / "broken.json"
    broken.write_text('{"format": "starling bench 1"}', encoding="utf-8")
    no_bench = directory / "no_bench.json"
    no_bench.write_text("[]", encoding="utf-8")
    for file, words in ((other, "no row in common"), (broken, "incomplete"), (no_bench, "format"),
                        (directory / "missing.json", "missing.json")):
        result = compare_bench(before, file)
        expect_exit(result, 2)
        expect(words in result.stderr, result.stderr)


def main():
    scenarios = {name[5:]: function for name, function in globals().items()
                 if name.startswith("test_") and inspect.isfunction(function)}
    with tempfile.TemporaryDirectory() as directory:
        scenarios[sys.argv[3]](pathlib.Path(directory))


if __name__ == "__main__":
    main()
