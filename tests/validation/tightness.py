"""How tight the wall is, and what the fluid outside does, from the files of a run."""
import functools

import h5py
import numpy
from scipy.spatial import KDTree

import measures

REACH = (3**2 + 2.5**2 + 2.5**2) ** 0.5  # of the wall's forces in spacings: sharpened B-splines
GHOSTS = 2.5  # spacings within which ghost nodes and nodes at rest lie


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
    def end(self):
        """Leak of the last sample over Q."""
        return self.series["leak"][-1] / self.Q

    def largest_after(self, t):
        """Largest leak of a sample from then on, over Q half way at that time."""
        s = self.series
        late = s["t"] >= min(t, s["t"][-1])
        return abs(s["leak"][late] / s["Q_mid"][late]).max()

    @property
    def sections(self):
        """Largest flow that has passed the wall between the inlet and a section, over Q."""
        return abs(numpy.array(self.result.profile["leak"])).max() / abs(self.Q)

    @property
    def quadrature(self):
        """Largest difference of Q(x) from Q(0) at the end, over Q: leak and the error of Q."""
        Q = numpy.array(self.result.profile["Q"])
        return abs(Q - Q[0]).max() / abs(self.Q)

    @property
    def power_left_over(self):
        """At the end, over the power that enters."""
        return self.series["power_residual"][-1] / self.series["power_in"][-1]

    @functools.cached_property
    def fluid(self):
        """Distance outside the wall, pressure and u times the face of the cells of the last frame
        of fluid.h5; arrays run over z, y, x."""
        with h5py.File(self.result.directory / "fluid.h5", "r", locking=False) as file:
            frame = list(file["frames"].values())[-1]
            P = frame["pressure"][...].astype(float)
            u = frame["velocity"][..., 0].astype(float)
            h, origin = frame.attrs["spacing"], frame.attrs["origin"]
        centres = [o + (numpy.arange(n) + 0.5) * d for o, n, d in zip(origin, P.shape[::-1], h)]
        z, y, x = numpy.meshgrid(*reversed(centres), indexing="ij")
        distance = distance_outside(self.result.profile, x, numpy.hypot(y, z))
        return distance / self.result.spacing, P, u * h[1] * h[2]

    @property
    def exterior_flow(self):
        """Largest flow of a section outside the ghost nodes, over Q."""
        distance, _, flow = self.fluid
        return abs(numpy.where(distance > GHOSTS, flow, 0).sum(axis=(0, 1))).max() / abs(self.Q)

    def exterior_pressure(self, spacings):
        """Largest deviation from the external pressure farther outside than so many spacings, over
        the inlet pressure."""
        drive = self.result.case["drive"]
        distance, P, _ = self.fluid
        off = abs(P[distance > spacings] - drive["pressure_external"]).max()
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
