"""How tight the wall is, and what the fluid outside does, from the files of a run."""
import h5py
import numpy
from scipy.spatial import KDTree

import measures


class Tightness:
    def __init__(self, result):
        self.result = result
        series = measures.columns(result.directory / "series.csv")
        self.series = {name: numpy.array(values) for name, values in series.items()}
        self.Q = self.series["Q_mid"][-1]

    @property
    def transient(self):
        """Largest leak at a sample over the largest |Q_in - Q_out|."""
        s = self.series
        return abs(s["leak"]).max() / abs(s["Q_in"] - s["Q_out"]).max()

    @property
    def sections(self):
        """Largest difference of Q(x) from Q(0) at the end, over Q: what passed the wall up to x."""
        Q = numpy.array(self.result.profile["Q"])
        return abs(Q - Q[0]).max() / self.Q

    @property
    def exterior_flow(self):
        return self.series["Q_exterior"][-1] / self.Q

    @property
    def power_left_over(self):
        """At the end, over the power that enters."""
        return self.series["power_residual"][-1] / self.series["power_in"][-1]

    @property
    def exterior_pressure(self):
        """Largest deviation from the external pressure where the wall, outside, is farther away than 3
        spacings, over the inlet pressure."""
        drive = self.result.case["drive"]
        with h5py.File(self.result.directory / "fluid.h5", "r", locking=False) as file:
            x, r, P = cells(file)
        outside = distance_outside(self.result.profile, x, r) > 3 * self.result.spacing
        off = abs(P[outside] - drive["pressure_external"]).max()
        return off / abs(drive["pressure_inlet"] - drive["pressure_external"])


def distance_outside(profile, x, r):
    """Distance from a round wall, 0 inside; through its mean radii, refined by lines."""
    fine = numpy.linspace(profile["x"][0], profile["x"][-1], 2000)
    R = numpy.interp(fine, profile["x"], profile["R_mean"])
    outside = r > numpy.interp(x, fine, R)
    distance = numpy.zeros_like(r)
    distance[outside] = KDTree(numpy.column_stack([fine, R])).query(
        numpy.column_stack([x[outside], r[outside]]))[0]
    return distance


def cells(file):
    """x, distance from the axis and pressure of the cells of the last frame of fluid.h5."""
    frame = list(file["frames"].values())[-1]
    P = frame["pressure"][...].astype(float)
    centre = [origin + (numpy.arange(n) + 0.5) * h  # arrays of a frame run over z, y, x
              for origin, n, h in zip(frame.attrs["origin"], P.shape[::-1], frame.attrs["spacing"])]
    z, y, x = numpy.meshgrid(*reversed(centre), indexing="ij")
    return x, numpy.hypot(y, z), P
