"""Waves of the wall, from the frames of a run, against linear theory (docs/theory.md, "Waves").

The dispersion relation stands here a second time, on SciPy's Bessel functions, apart from the
program's own."""
import functools
import math
import pathlib
import sys

import h5py
import numpy
from scipy.interpolate import CubicSpline
from scipy.special import iv, ive, kv

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

import measures  # noqa: E402
from plot_run import middle_layers, wall_history  # noqa: E402


def inside(q):
    return ive(1, q) / ive(0, q)


def outside(q, R_b):
    if abs(q.real) * (R_b - 1) > 40:
        return kv(1, q) / kv(0, q)
    N = kv(0, q) * iv(1, q * R_b) + iv(0, q) * kv(1, q * R_b)
    return (kv(1, q) * iv(1, q * R_b) - iv(1, q) * kv(1, q * R_b)) / N


class Tube:
    """Linear waves of the undeformed Hookean tube of a dimensionless case."""

    def __init__(self, case):
        fluid, vessel, wall, grid = (case[n] for n in ("fluid", "vessel", "wall", "grid"))
        self.reynolds, self.vessel = fluid["reynolds"], vessel
        self.c = 1 / math.sqrt(self.reynolds * wall["eps"] * (1 - wall["poisson_ratio"]))
        self.R_b = math.sqrt(grid["width_y"] * grid["width_z"] / math.pi)
        self.long_wave_speed = self.c * math.sqrt(1 - 1 / self.R_b**2)

    def inertia(self, k, omega):
        l = numpy.sqrt(k * k - 1j * omega * self.reynolds)
        return (1 / (inside(k) - k / l * inside(l))
                + 1 / (outside(k, self.R_b) - k / l * outside(l, self.R_b)))

    def wave_number(self, omega, guess=None):
        """Complex k of exp(i (k x - omega t))."""
        return newton(lambda k: omega**2 * k * self.inertia(k, omega) - 2 * self.c**2 * k * k,
                      guess or omega / self.long_wave_speed * (1 + 0.1j))

    def frequency(self, k):
        """Complex omega of a wave that swings."""
        def mismatch(omega):
            return omega**2 * self.inertia(complex(k), omega) - 2 * self.c**2 * k

        return newton(mismatch, k * self.long_wave_speed * (1 - 0.1j))

    @property
    def mode(self):
        """Wave number of the slowest mode between the ends."""
        v = self.vessel
        ends = v["rigid_inlet"], v["rigid_outlet"]
        length = v["length"] - sum(ends)
        low, high = 0, math.pi / length
        for _ in range(60):
            k = (low + high) / 2
            low, high = ((k, high) if k * length + sum(math.atan(k * l) for l in ends) < math.pi
                         else (low, k))
        return low


def newton(f, z):
    for _ in range(60):
        h = 1e-5 * z
        change = 2 * h * f(z) / (f(z + h) - f(z - h))
        z -= change
        if abs(change) < 1e-10 * abs(z):
            return z
    return complex(math.nan, math.nan)


class PressureWave:
    """A run of cases/pressure_wave.toml: how the pulse travels between two stations, and how it
    comes back to the second from the outlet clamp."""

    spacing = 0.02  # in time, of the signals
    stations = 7.0, 19.0
    highest_omega = 1.5  # of what is kept of the signals

    def __init__(self, result):
        self.tube = Tube(result.case)
        self.t, self.x, radii, _, _ = wall_history(result.directory / "wall.h5")
        self.displacement = radii - radii[0]
        self.clamp = self.x[-1] - result.case["vessel"]["rigid_outlet"]
        self.time = numpy.arange(0, self.t[-1], self.spacing)
        self.omega = 2 * math.pi * numpy.fft.rfftfreq(self.count, self.spacing)
        first, second = self.stations
        self.frequencies = int(numpy.searchsorted(self.omega, self.highest_omega))
        self.incident, arrived = self.before(first), self.before(second)
        distance = second - first
        predicted = self.sent(self.incident, distance)
        self.speed = distance / self.delay(self.incident, arrived)
        self.predicted_speed = distance / self.delay(self.incident, predicted)
        self.amplitude, self.predicted_amplitude = (s.max() / self.incident.max()
                                                    for s in (arrived, predicted))
        back = 2 * (self.clamp - second)
        returned, expected = self.after(second), self.reflected(arrived, back)
        self.return_speed = back / self.delay(arrived, -returned)
        self.predicted_return_speed = back / self.delay(arrived, -expected)
        self.returned, self.predicted_return = (s.min() / arrived.max()
                                                for s in (returned, expected))

    @property
    def count(self):
        return 2 ** math.ceil(math.log2(4 * len(self.time)))

    def signal(self, station):
        return CubicSpline(self.t, [numpy.interp(station, self.x, u) for u in self.displacement])(
            self.time)

    def front(self, station):
        """When the fastest part of the reflected pulse passes the station."""
        return (2 * self.clamp - station) / self.tube.long_wave_speed

    def before(self, station):
        return numpy.where(self.time < self.front(station), self.signal(station), 0)

    def after(self, station):
        return numpy.where(self.time < self.front(station), 0, self.signal(station))

    @functools.cached_property
    def wave_numbers(self):
        k, last = numpy.zeros(len(self.omega), dtype=complex), None
        for n in range(1, self.frequencies):
            last = k[n] = self.tube.wave_number(self.omega[n], last)
        return k

    def filtered(self, signal, response):
        """`response` is for exp(-i omega t), NumPy's spectrum for exp(i omega t)."""
        spectrum = numpy.fft.rfft(signal, self.count) * numpy.conj(response)
        spectrum[self.frequencies:] = 0
        return numpy.fft.irfft(spectrum)[:len(signal)]

    def sent(self, signal, distance):
        return self.filtered(signal, numpy.exp(1j * self.wave_numbers * distance))

    def reflected(self, signal, distance):
        k, l = self.wave_numbers, self.tube.vessel["rigid_outlet"]
        return self.filtered(signal, -(1 + 1j * k * l) / (1 - 1j * k * l)
                             * numpy.exp(1j * k * distance))

    def delay(self, early, late):
        """Time by which `early` is late in `late`: largest cross-correlation."""
        product = (numpy.fft.rfft(late, self.count)
                   * numpy.conj(numpy.fft.rfft(early, self.count)))
        product[self.frequencies:] = 0
        c = numpy.fft.irfft(product)
        n = int(c[:len(early)].argmax())
        return self.spacing * (n - 0.5 * (c[n + 1] - c[n - 1]) / (c[n + 1] - 2 * c[n] + c[n - 1]))


class Oscillation:
    """A run of cases/oscillation_damped.toml: the swing of the enclosed volume.

    `swing` is the first maximum less the minimum behind it, `period` the time between the first two
    maxima, `decay_time` from the first two such swings; NaN where there are not so many. `stream` is
    the mean speed half way between the first two maxima."""

    noise = 0.002  # of the final widening: extremes nearer to each other do not count

    def __init__(self, result):
        tube = Tube(result.case)
        series = measures.columns(result.directory / "series.csv")
        t, volume, flow = (numpy.array(series[n]) for n in ("t", "volume", "Q_mid"))
        turns = self.turns(volume, self.noise * (volume[-1] - volume[0]))
        V = volume[turns]
        self.swings = len(turns) // 2
        self.swing = V[0] - V[1] if len(turns) > 1 else math.nan
        self.period = t[turns[2]] - t[turns[0]] if len(turns) > 2 else math.nan
        self.decay_time = (self.period / math.log((V[0] - V[1]) / (V[2] - V[3]))
                           if len(turns) > 3 else math.nan)
        omega = tube.frequency(tube.mode)
        self.small_period, self.small_decay_time = 2 * math.pi / omega.real, -1 / omega.imag
        first = slice(turns[0], turns[2]) if len(turns) > 2 else slice(0, 0)
        self.stream = flow[first].mean() / math.pi if len(turns) > 2 else math.nan
        self.slowed_period = self.small_period / (1 - (self.stream * tube.mode / omega.real) ** 2)

    @staticmethod
    def turns(values, noise):
        """Indices of maxima and minima by turns, from the first maximum on."""
        found, sign, best = [], 1, 0
        for n, value in enumerate(values):
            if sign * (value - values[best]) > 0:
                best = n
            elif sign * (values[best] - value) > noise:
                found.append(best)
                sign, best = -sign, n
        return found


class Sustained:
    """A run of cases/oscillation_sustained.toml, from the first minimum of its volume on.

    `backflow` gives, for each frame of the fluid from then on, its time and the share of the plane of
    the axis inside the tube where the flow goes back; `periods` the times between maxima."""

    noise = 0.1  # of the largest widening: extremes nearer to each other do not count

    def __init__(self, result):
        series = measures.columns(result.directory / "series.csv")
        t, volume = (numpy.array(series[n]) for n in ("t", "volume"))
        turns = Oscillation.turns(volume, self.noise * (volume.max() - volume[0]))
        self.maxima, self.minima = turns[0::2], turns[1::2]
        self.periods = numpy.diff(t[self.maxima])
        settled = slice(self.minima[0], self.minima[-1] + 1)
        numbers = {n: numpy.array(v)[settled] for n, v in series.items()}
        self.at_start = volume[0]
        self.volumes = volume[self.minima].min(), volume[self.maxima].max()
        self.widest = numbers["R_max"].max()
        self.x_widest = numbers["x_R_max"][numbers["R_max"].argmax()]
        self.narrowest = numbers["R_max"].min()
        self.flows = numbers["Q_in"].min(), numbers["Q_in"].max()
        self.mean_flow = integral(numbers["t"], numbers["Q_mid"]) / numpy.ptp(numbers["t"])
        self.power_left_over = (integral(numbers["t"], numbers["power_residual"])
                                / integral(numbers["t"], numbers["power_in"]))
        self.leak = (integral(numbers["t"], numpy.abs(numbers["leak"]))
                     / integral(numbers["t"], numpy.abs(numbers["Q_mid"])))
        self.backflow = self.returning(result.directory, t[self.minima[0]])

    @staticmethod
    def returning(directory, begin):
        times, x, radii, _, _ = wall_history(directory / "wall.h5")
        found = []
        with h5py.File(directory / "fluid.h5", "r", locking=False) as file:
            for _, frame in sorted(file["frames"].items()):
                time = float(frame.attrs["t"])
                if time < begin or frame["velocity"].shape[0] > 2:
                    continue
                origin, spacing = frame.attrs["origin"], frame.attrs["spacing"]
                u = middle_layers(frame["velocity"], origin, spacing, 2)
                along = origin[0] + spacing[0] * (numpy.arange(u.shape[1]) + 0.5)
                across = origin[1] + spacing[1] * (numpy.arange(u.shape[0]) + 0.5)
                R = numpy.interp(along, x, radii[numpy.abs(times - time).argmin()])
                inside_tube = numpy.abs(across)[:, None] < R[None, :]
                found.append((time, (inside_tube & (u < 0)).sum() / inside_tube.sum()))
        return found


def integral(t, values):
    return float(numpy.sum((t[1:] - t[:-1]) * (values[1:] + values[:-1]) / 2))
