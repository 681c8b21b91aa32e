"""Runs of Starling: what is asked of the program, and making it once."""
import concurrent.futures
import dataclasses
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]


@dataclasses.dataclass(frozen=True)
class Run:
    """A case file with overrides. `threads` 0 stands for the number of the command line."""

    name: str
    case: str  # relative to the source directory
    settings: tuple  # of "section.key=value"
    threads: int = 0
    coarse: tuple = ("grid.spacing=0.3", "vessel.rigid_outlet=0.65")  # for quick()

    def arguments(self, directory, threads):
        sets = [part for s in self.settings for part in ("--set", s)]
        return ["run", self.case, "--out", str(directory), "--threads",
                str(self.threads or threads), *sets]

    def quick(self):
        """The same run on a coarse grid for a few steps: it shows nothing but that it runs."""
        few = ("stop.steps=4", "output.sample_every=1")
        return dataclasses.replace(self, settings=self.settings + self.coarse + few)


def make_run(name, case, threads=0, **settings):
    """Settings as section__key=value."""
    pairs = tuple(f"{key.replace('__', '.')}={value}" for key, value in settings.items())
    return Run(name, case, pairs, threads)


def printable(run, binary, out, threads):
    """The command as one types it in the source directory, folded at 100 columns."""
    lines = [binary]
    words = run.arguments(f"{out}/{run.name}", threads)
    pairs = []
    while words:  # an option stays with its value
        count = 2 if words[0].startswith("--") or words[0] == "run" else 1
        pairs.append(" ".join(shlex.quote(w) for w in words[:count]))
        words = words[count:]
    for pair in pairs:
        if len(lines[-1]) + len(pair) > 95:
            lines.append("    " + pair)
        else:
            lines[-1] += " " + pair
    return " \\\n".join(lines)


def version_of(binary):
    """What `starling --version` prints, in the form of summary.json."""
    text = subprocess.run([binary, "--version"], capture_output=True, text=True, check=True).stdout
    return text.strip().removeprefix("starling ")


def sha256(path):
    return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()


def note_of(out, run):
    """The file beside a finished run that says what it was made of."""
    return out / f"{run.name}.request.json"


def is_finished(out, run):
    """Whether a run, of whatever version, ended in an orderly way."""
    return note_of(out, run).exists() and (out / run.name / "summary.json").exists()


class Runner:
    """Makes runs below `out`, several at a time. With `keep` a finished run is not made again if
    its case, its overrides, its threads and the version of the program are the same; a version
    with uncommitted changes must be the same binary as well."""

    def __init__(self, binary, out, threads=2, jobs=1, keep=False, log=sys.stderr):
        self.binary = str(pathlib.Path(binary).resolve())
        self.out = pathlib.Path(out)
        self.threads, self.jobs, self.keep, self.log = threads, jobs, keep, log
        self.version = version_of(self.binary)
        self.done = self.total = 0

    def make(self, runs):
        """Returns the names of the runs that the program refused (bad input, crash)."""
        self.out.mkdir(parents=True, exist_ok=True)
        self.total = len(runs)
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            return [run.name for run, good in zip(runs, pool.map(self._one, runs)) if not good]

    def _one(self, run):
        directory = self.out / run.name
        note = note_of(self.out, run)
        request = self._request(run)
        if self.keep and is_finished(self.out, run) and _read(note) == request:
            return self._report(run, "kept")
        note.unlink(missing_ok=True)
        # The directory is given in full: the program runs in the source directory.
        command = [self.binary, *run.arguments(directory.resolve(), self.threads), "--force",
                   "--quiet"]
        result = subprocess.run(command, cwd=SOURCE, capture_output=True, text=True, check=False,
                                env={**os.environ, "OMP_WAIT_POLICY": "passive"})
        if result.returncode not in (0, 3):  # 3: it broke down, which the summary tells
            self._report(run, f"FAILED (exit code {result.returncode})\n{result.stderr}")
            return False
        note.write_text(json.dumps(request, indent=1), encoding="utf-8")
        summary = _read(directory / "summary.json")
        return self._report(run, f"{summary['reason']} after {summary['steps']} steps, "
                                 f"{summary['wall_seconds']:.1f} s")

    def _request(self, run):
        request = {"case": sha256(SOURCE / run.case), "settings": list(run.settings),
                   "threads": run.threads or self.threads, "version": self.version}
        if "+" in self.version:
            request["binary"] = sha256(self.binary)
        return request

    def _report(self, run, text):
        self.done += 1
        print(f"[{self.done}/{self.total}] {run.name}: {text}", file=self.log, flush=True)
        return True


def _read(path):
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
