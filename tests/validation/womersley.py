"""Womersley's flow through a rigid tube, against a run of cases/womersley.toml."""
import cmath
import csv
import math

import numpy


def bessel(order, z):
    """J_0 or J_1 of a complex number by its power series."""
    term = total = (z / 2) ** order
    for n in range(1, 60):
        term *= -(z / 2) ** 2 / (n * (n + order))
        total += term
    return total


def flow_amplitude(alpha, gradient):
    """Complex amplitude of Q for a pressure gradient -gradient cos(t), in R_0 = U_c = rho = 1."""
    z = cmath.sqrt(1j) * 1j * alpha
    return math.pi * gradient / 1j * (1 - 2 * bessel(1, z) / (z * bessel(0, z)))


def first_harmonic(t, values, period):
    """Complex amplitude of cos, by least squares over the last period."""
    t, values = numpy.array(t), numpy.array(values)
    last = t > t[-1] - period
    phase = 2 * math.pi * t[last] / period
    shapes = numpy.stack([numpy.cos(phase), numpy.sin(phase), numpy.ones_like(phase)], axis=1)
    cosine, sine, _ = numpy.linalg.lstsq(shapes, values[last], rcond=None)[0]
    return complex(cosine, -sine)


class Womersley:
    """Errors of the first harmonic of a run."""

    def __init__(self, result):
        drive = result.case["inlet_waveform"]
        gradient = drive["amplitude"] * drive["cosine"][0] / result.case["vessel"]["length"]
        self.alpha = math.sqrt(result.case["fluid"]["reynolds"] * 2 * math.pi / drive["period"])
        exact = flow_amplitude(self.alpha, gradient)
        with open(result.directory / "series.csv", encoding="utf-8") as stream:
            header, *rows = csv.reader(stream)
        columns = {name.split(" [")[0]: [float(row[n]) for row in rows]
                   for n, name in enumerate(header)}

        def harmonic(name):
            return first_harmonic(columns["t"], columns[name], drive["period"])

        ratio = harmonic("Q_mid") / exact
        self.amplitude_error = abs(ratio) - 1
        self.phase_error = math.degrees(cmath.phase(ratio))
        self.leak = abs(harmonic("leak")) / abs(exact)
