"""What is measured on tubes that collapse, from the files of a run."""
import h5py
import numpy
import scipy.integrate
import scipy.optimize

from measures import columns


class Wall:
    """The wall in the frames of a run; vertices keep their x and the order around their ring."""

    def __init__(self, result):
        with h5py.File(result.directory / "wall.h5", "r", locking=False) as file:
            self.triangles = file["triangles"][...]
            frames = list(file["frames"].values())
            self.times = numpy.array([f.attrs["t"] for f in frames])
            self.points = [f["points"][...].astype(float) for f in frames]
            self.rest = self.points[-1] - frames[-1]["displacement"][...]

    def ring(self, x):
        """Vertices of the ring that is nearest to x, in the order around it."""
        rows = self.rest[:, 0]
        nearest = rows[abs(rows - x).argmin()]
        ring = numpy.flatnonzero(abs(rows - nearest) < 1e-5)
        return ring[numpy.argsort(numpy.arctan2(*self.rest[ring, :0:-1].T))]


def polygon_area(points):
    y, z = points[:, 1], points[:, 2]
    return abs(numpy.dot(y, numpy.roll(z, -1)) - numpy.dot(z, numpy.roll(y, -1))) / 2


def triangle_angles_and_areas(points, triangles):
    """Smallest angle of each triangle in degrees, and its area."""
    corners = points[triangles]
    edges = numpy.roll(corners, -1, 1) - corners
    lengths = numpy.linalg.norm(edges, axis=2)
    following = numpy.roll(edges, 1, 1)
    cosines = -(edges * following).sum(2) / (lengths * numpy.roll(lengths, 1, 1))
    areas = numpy.linalg.norm(numpy.cross(edges[:, 0], edges[:, 1]), axis=1) / 2
    return numpy.degrees(numpy.arccos(numpy.clip(cosines, -1, 1))).min(1), areas


class MeshQuality:
    """Of the wall's triangles at the end of a run: smallest angle in degrees, and the range of the
    areas over those at rest."""

    def __init__(self, result):
        wall = Wall(result)
        angles, areas = triangle_angles_and_areas(wall.points[-1], wall.triangles)
        at_rest = triangle_angles_and_areas(wall.rest, wall.triangles)
        self.smallest_angle, self.smallest_angle_at_rest = angles.min(), at_rest[0].min()
        ratio = areas / at_rest[1]
        self.smallest_area, self.largest_area = ratio.min(), ratio.max()


def distance_between(result, other):
    """Largest distance between the same vertex of two walls of the same mesh at the end."""
    first, second = Wall(result), Wall(other)
    return numpy.linalg.norm(first.points[-1] - second.points[-1], axis=1).max()


def balance(result):
    """|Q_in - Q_out - dV/dt| and |dV/dt| of the last sample over |Q_mid|."""
    last = {name: values[-1] for name, values in columns(result.directory / "series.csv").items()}
    return abs(last["leak"] / last["Q_mid"]), abs(last["dV_dt"] / last["Q_mid"])


class Resistor:
    """Pressure on the axis over Delta P_0 and area over that at rest along a run of
    cases/starling_resistor.toml."""

    def __init__(self, result):
        vessel, fluid = result.case["vessel"], result.case["fluid"]
        self.x, P, areas, Q = (numpy.array(result.profile[c]) for c in ("x", "P_centre", "area", "Q"))
        drop = 4 * vessel["length"] / fluid["reynolds"]
        self.pressure, self.area = P / drop, areas / areas[0]
        before = self.x < vessel["rigid_inlet"]
        behind = self.x > vessel["length"] - vessel["rigid_outlet"] + 2
        slopes = [numpy.polyfit(self.x[part], P[part], 1)[0] for part in (before, behind)]
        steepest = min(numpy.gradient(P, self.x))
        self.steepness = [steepest / slope for slope in slopes]
        poiseuille = -8 * Q[behind].mean() / (numpy.pi * fluid["reynolds"])
        self.outlet_slope_error = slopes[1] / poiseuille - 1


class TubeLaw:
    """A long tube whose external pressure rises in steps by a waveform, its ends at no pressure. At
    the end of each step, where the tube has come to rest: pressure over E_b/R_0^3, and area of the
    middle section over that at rest."""

    def __init__(self, result):
        case = result.case
        E_b = case["wall"]["bending"] / (case["fluid"]["reynolds"] * case["wall"]["eps"])
        wave, wall = case["external_waveform"], Wall(result)
        ring = wall.ring(case["vessel"]["length"] / 2)
        at_rest = polygon_area(wall.rest[ring])
        self.points = []  # (pressure, area)
        values = wave["values"]
        for n in range(1, len(values)):
            if values[n] == values[n - 1]:
                frame = abs(wall.times - wave["times"][n] * wave["time_scale"]).argmin()
                pressure = case["drive"]["pressure_external"] + wave["amplitude"] * values[n]
                self.points.append((pressure / E_b,
                                    polygon_area(wall.points[frame][ring]) / at_rest))


class BuckledRing:
    """The inextensible ring that has buckled into n lobes (docs/theory.md, which `starling theory`
    evaluates by a code of its own): pressure over E_b/R_0^3 against area over that at rest."""

    def __init__(self, lobes, smallest_area=0.3):
        c, p = 1.5 - lobes**2, lobes**2 - 1.0  # the circle
        self.pressures, self.areas = [p], [1.0]
        tip = 1.0  # curvature of the tip of a lobe
        while self.areas[-1] > smallest_area:
            tip += 0.04 * lobes
            c, p = scipy.optimize.fsolve(lambda cp: _half_lobe(lobes, tip, *cp)[1:3], (c, p))
            square = _half_lobe(lobes, tip, c, p)[3]
            self.pressures.append(p)
            self.areas.append((lobes * square / (2 * numpy.pi) - c) / p)

    def pressure(self, area):
        return numpy.interp(-area, -numpy.array(self.areas), self.pressures)

    def area(self, pressure):
        return numpy.interp(pressure, self.pressures, self.areas)


def _half_lobe(lobes, tip, c, p):
    """From the tip of a lobe to the waist: curvature there, its derivative and the angle short of
    pi/n, which both vanish in equilibrium, and the integral of the square of the curvature."""
    def slope(_, y):
        return [y[1], p + c * y[0] - y[0]**3 / 2, y[0], y[0]**2]

    end = scipy.integrate.solve_ivp(slope, (0, numpy.pi / lobes), [tip, 0, 0, 0], rtol=1e-9,
                                    atol=1e-11).y[:, -1]
    return [end[0], end[1], end[2] - numpy.pi / lobes, end[3]]
