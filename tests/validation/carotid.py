"""A run of cases/carotid.toml against the lumped and the one-dimensional linear theory of its artery."""
import math

import numpy

import measures
from womersley import bessel


def value(text):
    """The number of "0.24 mm" and the like, in SI."""
    scales = {"mm": 1e-3, "m": 1, "s": 1, "ms": 1e-3, "kPa": 1e3, "Pa": 1, "ml/s": 1e-6, "m^3/s": 1,
              "kg/m^3": 1, "mPa s": 1e-3, "Pa s": 1, "Pa s/m^3": 1, "m^3/Pa": 1, "N m": 1,
              "ml/min": 1e-6 / 60, "mmHg s/ml": 133.322387415e6, "ml/mmHg": 1e-6 / 133.322387415,
              "mmHg": 133.322387415, "N/m": 1}
    number, unit = text.split(" ", 1)
    return float(number) * scales[unit]


class Carotid:
    """Pressures over the last period, in Pa, and those of theory at the same times."""

    harmonics = 10

    def __init__(self, result):
        self.case = result.case
        series = {n: numpy.array(v) for n, v in measures.columns(result.directory / "series.csv").items()}
        inlet = self.case["inlet_flow"]
        self.period = value(inlet["period"])
        t = series["t"]
        last = t > t[-1] - self.period
        self.t = t[last] - t[last][0]
        self.P_in, self.P_out, self.leak, Q_in = (series[n][last] for n in ("P_in", "P_out", "leak", "Q_in"))
        self.mean_flow = self.mean(Q_in)
        self.leak_share = self.mean(self.leak) / self.mean_flow
        powers = {n: self.mean(series[f"power_{n}"][last]) for n in ("in", "residual")}
        self.power_left_over = powers["residual"] / powers["in"]
        vessel, wall, fluid = (self.case[n] for n in ("vessel", "wall", "fluid"))
        self.R_0, self.L = value(vessel["radius"]), value(vessel["length"])
        self.rho, self.mu = value(fluid["density"]), value(fluid["viscosity"])
        self.stiffness = 2 * value(wall["surface_shear_modulus"]) / (1 - wall["poisson_ratio"])
        self.Z = [value(self.case["windkessel"][n]) for n in ("R1", "R2")]
        self.C = value(self.case["windkessel"]["C"])
        self.distal = value(self.case["windkessel"]["pressure_distal"])
        self.R, self.compliance = self.at_pressure(self.distal + sum(self.Z) * self.flow(0))

    def at_pressure(self, P):
        """Radius and dA/dP at a pressure, by the law of Laplace of second order, Eq. (52)."""
        P_bar = P * self.R_0 / self.stiffness
        slope = 1 + P_bar / math.sqrt(1 + P_bar**2)
        R = self.R_0 * measures.second_order_radius(P_bar)
        return R, 2 * math.pi * R * slope * self.R_0**2 / self.stiffness

    def mean(self, values):
        return numpy.trapezoid(values, self.t) / self.t[-1] if hasattr(numpy, "trapezoid") \
            else numpy.trapz(values, self.t) / self.t[-1]

    def flow(self, n):
        """Complex amplitude of harmonic n of the flow at the inlet, exp(i n w t)."""
        inlet = self.case["inlet_flow"]
        if n == 0:
            return value(inlet["mean"])
        return value(inlet["amplitude"]) * complex(inlet["cosine"][n - 1], -inlet["sine"][n - 1])

    def load(self, omega):
        R1, R2 = self.Z
        return R1 + R2 / (1 + 1j * omega * R2 * self.C)

    def line(self, omega):
        """Pressures at inlet and outlet over the flow at the inlet: Womersley's friction, thin wall."""
        alpha = self.R * math.sqrt(omega * self.rho / self.mu)
        z = 1j**1.5 * alpha
        series = (1j * omega * self.rho / (math.pi * self.R**2)
                  / (1 - 2 * bessel(1, z) / (z * bessel(0, z))))
        shunt = 1j * omega * self.compliance
        gamma, characteristic = (series * shunt) ** 0.5, (series / shunt) ** 0.5
        g, load = gamma * self.L, self.load(omega)
        cosh, sinh = numpy.cosh(g), numpy.sinh(g)
        over = cosh + load / characteristic * sinh  # Q_in/Q_out
        return (load * cosh + characteristic * sinh) / over, load / over

    def sum(self, steady, response):
        omega = 2 * math.pi / self.period
        P = steady + 0 * self.t
        for n in range(1, self.harmonics + 1):
            P = P + (response(n * omega) * self.flow(n) * numpy.exp(1j * n * omega * self.t)).real
        return P

    def one_dimensional(self):
        """P_in and P_out of the one-dimensional model, linear about the mean pressure."""
        at_outlet = self.distal + sum(self.Z) * self.flow(0)
        poiseuille = 8 * self.mu * self.L / (math.pi * self.R**4) * self.flow(0)
        return (self.sum(at_outlet + poiseuille, lambda w: self.line(w)[0]),
                self.sum(at_outlet, lambda w: self.line(w)[1]))

    def lumped(self):
        """One pressure: the vessel is a compliance before the Windkessel."""
        return self.sum(self.distal + sum(self.Z) * self.flow(0),
                        lambda w: 1 / (1j * w * self.compliance * self.L + 1 / self.load(w)))
