"""What is measured on the results of a run."""
import csv
import functools
import json
import math
import pathlib
import sys
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

from axisymmetric.case import make_case  # noqa: E402
from axisymmetric.tube import NoSolution, solve_tube  # noqa: E402

Q_0 = math.pi / 2  # flow rate through the undeformed tube at the baseline pressure drop


@functools.cache
def axisymmetric_tube(case, elements):
    """Q/Q_0 and R_max of the axisymmetric solution (docs/theory.md); NaN where none is found."""
    try:
        tube = solve_tube(case, *elements)
    except NoSolution:
        return math.nan, math.nan
    return tube.Q_over_Q0, tube.R_max


class Result:
    """The files of a finished run (docs/results.md). `elements` are those of the axisymmetric
    solution beside it, as of tools/axisymmetric_tube."""

    def __init__(self, directory, elements=(120, 8)):
        self.directory = pathlib.Path(directory)
        self.elements = elements
        self.summary = json.loads((self.directory / "summary.json").read_text(encoding="utf-8"))

    @functools.cached_property
    def case(self):
        return tomllib.loads((self.directory / "case.toml").read_text(encoding="utf-8"))

    @functools.cached_property
    def profile(self):
        return columns(self.directory / "profile.csv")

    def __getitem__(self, key):
        return self.summary[key]

    @property
    def broke_down(self):
        return self.summary["reason"].startswith("numerical error")

    @property
    def spacing(self):
        """Edge of a cube of the volume of a cell: counts are rounded, so it is near the nominal."""
        grid = self.case["grid"]
        box = self.case["vessel"]["length"] * grid["width_y"] * grid["width_z"]
        return (box / self.summary["cells"]) ** (1 / 3)

    @property
    def flow_error(self):
        """Q_mid over that of the one-dimensional model, minus 1."""
        return self.summary["theory"]["Q_relative_difference"]

    @property
    def displacement_error(self):
        """R_max - 1 over that of the one-dimensional model, minus 1."""
        return self.summary["theory"]["displacement_relative_difference"]

    @property
    def axisymmetric_flow_error(self):
        """Q_mid over that of the axisymmetric solution of the same case, minus 1."""
        return self["Q_mid_over_Q0"] / axisymmetric_tube(make_case(self.case), self.elements)[0] - 1

    @property
    def axisymmetric_displacement_error(self):
        """R_max - 1 over that of the axisymmetric solution of the same case, minus 1."""
        R_max = axisymmetric_tube(make_case(self.case), self.elements)[1]
        return (self["R_max"] - 1) / (R_max - 1) - 1


def columns(path):
    """Columns of a CSV file by the name before the unit."""
    with open(path, newline="", encoding="utf-8") as stream:
        header, *rows = list(csv.reader(stream))
    values = zip(*([float(x) for x in row] for row in rows))
    return {title.split(" [")[0]: list(v) for title, v in zip(header, values)}


def second_order_radius(P_bar):
    """Law of Laplace of second order, Eq. (52); P_bar is the transmural pressure over E'h."""
    return P_bar + math.sqrt(1 + P_bar**2)


def radius_deviation(result):
    """Largest relative deviation of the radius of a Hookean tube from Eq. (52) with the simulated
    pressure on the axis, from the largest radius + 0.5 to the end of the deforming part - 0.5."""
    fluid, vessel, wall = (result.case[s] for s in ("fluid", "vessel", "wall"))
    nu = wall["poisson_ratio"]
    G_s = 1 / (fluid["reynolds"] * wall["eps"])
    stiffness = 2 * (1 + nu) * G_s / (1 - nu**2)  # E'h
    P_ext = result.case["drive"]["pressure_external"]
    x, R, P = (result.profile[c] for c in ("x", "R_mean", "P_centre"))
    begin = x[max(range(len(R)), key=R.__getitem__)] + 0.5
    end = vessel["length"] - vessel["rigid_outlet"] - 0.5
    deviations = [abs(R[n] / second_order_radius((P[n] - P_ext) / stiffness) - 1)
                  for n in range(len(x)) if begin <= x[n] <= end]
    return max(deviations, default=math.nan)


def out_of_roundness(result):
    """Largest distance of the wall from the axisymmetric shape of its rings' mean radii."""
    p = result.profile
    return max(max(largest - mean, mean - smallest)
               for smallest, mean, largest in zip(p["R_min"], p["R_mean"], p["R_max"]))


def spread_of_radii(result):
    """Largest difference between the largest and the smallest radius of a ring."""
    return max(b - a for a, b in zip(result.profile["R_min"], result.profile["R_max"]))


def zig_zag(result):
    """Largest amplitude of the wave of two rings, which the fluid cannot see: the fourth
    difference of the rings' mean radii over 16, away from the clamps."""
    x, R = result.profile["x"], result.profile["R_mean"]
    vessel = result.case["vessel"]
    begin, end = vessel["rigid_inlet"] + 0.5, vessel["length"] - vessel["rigid_outlet"] - 0.25
    return max(abs(R[n - 2] - 4 * R[n - 1] + 6 * R[n] - 4 * R[n + 1] + R[n + 2]) / 16
               for n in range(2, len(x) - 2) if begin <= x[n] <= end)


def order(errors, spacings):
    """Order between the first and the last; NaN if there is none."""
    if spacings[0] == spacings[-1] or 0 in (errors[0], errors[-1]):
        return math.nan
    return math.log(abs(errors[0] / errors[-1])) / math.log(spacings[0] / spacings[-1])


def limit_of_second_order(values, spacings):
    """a of the least-squares fit a + b Delta^2 (Richardson's limit for two values)."""
    n = len(values)
    h2 = [h * h for h in spacings]
    if max(h2) == min(h2):
        return math.nan
    mean_h, mean_f = sum(h2) / n, sum(values) / n
    slope = (sum((h - mean_h) * (f - mean_f) for h, f in zip(h2, values))
             / sum((h - mean_h) ** 2 for h in h2))
    return mean_f - slope * mean_h
