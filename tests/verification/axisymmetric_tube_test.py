#!/usr/bin/python3
"""The independent reference of the clamped tube, tools/axisymmetric_tube, against exact flows.

usage: axisymmetric_tube_test.py PROGRAM [TEST...]
"""
import csv
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "tools"))

import numpy as np  # noqa: E402

from axisymmetric.case import CaseError, read_case  # noqa: E402
from axisymmetric.elements import Mesh  # noqa: E402
from axisymmetric.flow import Flow  # noqa: E402
from axisymmetric.tube import NoSolution, solve_tube  # noqa: E402

PROGRAM = sys.argv.pop(1)
TOOL = SOURCE / "tools" / "axisymmetric_tube"
CASE = SOURCE / "cases" / "inflation.toml"


def uniform(begin, end, along, across):
    return Mesh(np.linspace(begin, end, along + 1), np.linspace(0, 1, across + 1))


def converged_flow(flow, R, density, drop):
    """Solution and wall force with the pressure `drop` along the tube, by Newton's method."""
    U = None
    for _ in range(20):
        before, (U, force) = U, flow.between_pressures(R, drop, 0, density, U)
        if before is not None and np.abs(U - before).max() < 1e-11 * np.abs(U).max():
            return U, force
    raise AssertionError("Newton's method did not converge")


class Poiseuille(unittest.TestCase):
    def test_is_exact_at_any_density(self):
        """Velocity, flow rate, pressure and force on the wall of a rigid tube to round-off."""
        mesh, length = uniform(0, 3, 5, 3), 3
        for density in (0, 50):
            flow = Flow(mesh)
            U, force = converged_flow(flow, np.ones(len(mesh.x)), density, 4 * length)
            u, v = flow.velocity(U)
            self.assertLess(np.abs(u - (1 - mesh.eta**2)).max(), 1e-11)
            self.assertLess(np.abs(v).max(), 1e-11)
            self.assertAlmostEqual(flow.flow_rate(U), math.pi / 2, places=11)
            pressure = 4 * (length - mesh.element_x)
            self.assertLess(np.abs(flow.pressure(U) - pressure[:, None]).max(), 1e-10)
            self.assertAlmostEqual(force.sum(), 2 * length**2, places=10)  # integral of pressure


class Cone:
    """Stokes flow of viscosity 1 towards the apex of a cone or away from it: purely radial,
    u = (cos^2 theta - cos^2 alpha)/rho^2, p = (2/3)(3 cos^2 theta - 1)/rho^3 (Harrison 1920)."""

    def __init__(self, half_angle):
        self.tan, self.cos2 = math.tan(half_angle), math.cos(half_angle) ** 2

    def velocity(self, x, r):
        rho2 = x**2 + r**2
        speed = (x**2 / rho2 - self.cos2) / rho2
        return speed * x / np.sqrt(rho2), speed * r / np.sqrt(rho2)

    def pressure(self, x, r):
        rho2 = x**2 + r**2
        return 2 / 3 * (3 * x**2 / rho2 - 1) / rho2**1.5

    def wall_load(self, x):
        """Radial load per area 2 pi R dx: p(R) + shear (1/rho) du/dtheta times the slope."""
        rho = x * math.sqrt(1 + self.tan**2)
        d_theta = -2 * self.tan * self.cos2 / rho**2  # -2 sin cos/rho^2
        p = self.pressure(x, x * self.tan)
        # Traction on the fluid's side of the wall with the normal (-sin, cos): stress theta-theta
        # is -p + 2 u/rho = -p, stress rho-theta is (1/rho) du/dtheta.
        return p - d_theta / rho * self.tan


class StokesFlowInACone(unittest.TestCase):
    """Exact velocities on the boundary, 40 degrees of half angle."""

    @staticmethod
    def displacement(x):
        """Vanishes at the ends, where nodal forces hold the section too; no change of volume."""
        def bump(x):
            return np.sin(math.pi * (x - 1)) ** 2

        s = np.linspace(1, 2, 4001)
        mean = np.trapz(s**2 * bump(s), s) / np.trapz(s * bump(s), s)
        return bump(x) * (x - mean)

    def errors(self, count):
        """Largest error of velocity and of pressure, and that of the work of the wall's load."""
        cone = Cone(math.radians(40))
        mesh = uniform(1, 2, count, count)
        flow, R = Flow(mesh), mesh.x * cone.tan
        x, r = np.repeat(mesh.x, len(mesh.eta)), np.outer(R, mesh.eta).ravel()
        u, v = cone.velocity(x, r)
        corners = np.outer(mesh.element_x * cone.tan, mesh.element_eta)
        p = cone.pressure(mesh.element_x[:, None], corners)
        ends = np.concatenate([flow.wall, flow.inlet, flow.outlet])
        fixed = np.concatenate([ends, flow.nodes + ends, flow.nodes + flow.axis,
                                [2 * flow.nodes]])
        fixed, first = np.unique(fixed, return_index=True)
        exact = np.concatenate([u, v, p.ravel()])
        solution, residual = flow.solve(R, fixed, exact[fixed], 0)
        load = -residual[flow.nodes + flow.wall]
        # work of the load, free of the constant by which the one given pressure errs
        work = load @ self.displacement(mesh.x)
        s = np.linspace(1, 2, 4001)
        exact_work = np.trapz(cone.wall_load(s) * s * cone.tan * self.displacement(s), s)
        return (np.abs(solution - exact)[: 2 * flow.nodes].max(),
                np.abs(flow.pressure(solution) - p).max() / p.max(),
                abs(work / exact_work - 1))

    def test_velocity_and_pressure_converge_at_their_orders(self):
        coarse, fine = self.errors(8), self.errors(16)
        orders = [math.log2(a / b) for a, b in zip(coarse, fine)]
        print("orders of velocity, pressure, load:", orders, "errors:", fine)
        self.assertGreater(orders[0], 2.7)
        self.assertGreater(orders[1], 1.7)
        self.assertGreater(orders[2], 2.5)
        self.assertLess(fine[0], 1e-4)
        self.assertLess(fine[2], 1e-4)


class Inertia(unittest.TestCase):
    def test_pressure_recovers_as_perturbation_theory_says(self):
        """In a long tube of small slope, inertia adds (Q/pi)^2 (1 - 1/R^4) to the pressure, to
        first order in Re times slope."""
        length = 200
        mesh = uniform(0, length, 100, 4)
        R = 1 + 0.1 * np.sin(math.pi * mesh.x / length) ** 2
        flow = Flow(mesh)
        stokes, _ = converged_flow(flow, R, 0, 4 * length)
        moving, _ = converged_flow(flow, R, 1, 4 * length)
        Q_stokes, Q = flow.flow_rate(stokes), flow.flow_rate(moving)
        added = flow.pressure(moving)[:, 0] - Q / Q_stokes * flow.pressure(stokes)[:, 0]
        # Pressures are given at both ends, where the added part vanishes.
        expected = (Q / math.pi) ** 2 * (1 - R[::2] ** -4)
        print("relative error:", np.abs(added - expected).max() / expected.max())
        self.assertLess(np.abs(added - expected).max() / expected.max(), 0.02)


class Wall(unittest.TestCase):
    def theory(self, *overrides):
        """Q/Q_0 and the largest radius of the one-dimensional model."""
        sets = [part for o in overrides for part in ("--set", o)]
        text = subprocess.run([PROGRAM, "theory", str(CASE), *sets], capture_output=True,
                              text=True, check=True).stdout
        number = {line[:40].strip(): float(line[40:].split()[0])
                  for line in text.splitlines() if "Q/Q_0  " in line or "largest radius  " in line}
        return number["Q/Q_0"], number["largest radius"]

    def test_long_tubes_of_all_laws_agree_with_the_one_dimensional_model(self):
        """Slopes matter only next to the clamps, so tensions, forces and Poiseuille flow decide.
        Without Poisson's ratio, psi or C of the case the radius would differ by several per cent."""
        for law in ("law=hooke", "law=hooke wall.poisson_ratio=0.2", "law=neo-hookean",
                    "law=mooney-rivlin wall.psi=0.3", "law=skalak wall.skalak_C=2"):
            settings = [*("wall." + law).replace(" ", "#").split("#"), "vessel.length=80",
                        "wall.eps=0.001", "drive.pressure_ratio=1.5"]
            if "hooke wall" not in law:
                settings.insert(0, "wall.poisson_ratio=")
            Q, R_max = self.theory(*settings)
            tube = solve_tube(read_case(CASE, settings), 80, 4)
            print(law, tube.Q_over_Q0 / Q - 1, R_max, (tube.R_max - 1) / (R_max - 1) - 1)
            self.assertGreater(R_max, 1.05)
            self.assertAlmostEqual(tube.Q_over_Q0 / Q, 1, delta=4e-4)
            self.assertAlmostEqual((tube.R_max - 1) / (R_max - 1), 1, delta=4e-4)

    def test_only_pressure_differences_matter(self):
        case = ["drive.pressure_ratio=1"]
        a = solve_tube(read_case(CASE, case), 16, 2)
        b = solve_tube(read_case(CASE, case + ["drive.pressure_outlet=70",
                                               "drive.pressure_external=70"]), 16, 2)
        self.assertAlmostEqual(a.Q_over_Q0, b.Q_over_Q0, places=10)
        self.assertAlmostEqual(a.R_max, b.R_max, places=10)
        self.assertLess(np.abs(b.P_axis - a.P_axis - 70).max(), 1e-6)
        self.assertLess(np.abs(b.wall_load - a.wall_load - 70).max(), 1e-6)


class Coupled(unittest.TestCase):
    def test_converges_with_the_mesh(self):
        """Inflation by half at a slope of 0.9: the difference of meshes falls by more than three."""
        case = read_case(CASE, ["drive.pressure_ratio=3"])
        tubes = [solve_tube(case, n, m) for n, m in ((15, 2), (30, 4), (60, 8))]
        Q = [t.Q_over_Q0 for t in tubes]
        R = [t.R_max for t in tubes]
        print("Q/Q_0:", Q, "R_max:", R)
        self.assertLess(abs(Q[2] - Q[1]), abs(Q[1] - Q[0]) / 3)
        self.assertLess(abs(R[2] - R[1]), abs(R[1] - R[0]) / 3)
        self.assertLess(abs(Q[2] / Q[1] - 1), 2e-3)

    def test_follows_a_softening_wall_up_in_load(self):
        """A neo-Hookean tube at ratio 3 is found from no load, and says so beyond its limit."""
        soft = ["wall.law=neo-hookean", "wall.eps=0.01"]
        tube = solve_tube(read_case(CASE, soft + ["drive.pressure_ratio=3"]), 24, 3)
        self.assertAlmostEqual(tube.R_max, 1.78, delta=0.01)
        with self.assertRaises(NoSolution):
            solve_tube(read_case(CASE, soft + ["drive.pressure_ratio=12"]), 24, 3)

    def test_inertia_widens_the_tube_smoothly(self):
        """The larger Re at the same eps and ratio, the more pressure is recovered where it is wide."""
        def tube(Re):
            return solve_tube(read_case(CASE, [f"fluid.reynolds={Re}",
                                               "drive.pressure_ratio=1"]), 24, 3)
        R = [tube(Re).R_max for Re in (0.1, 1, 10)]
        self.assertLess(R[0], R[1])
        self.assertLess(R[1], R[2])


class Tool(unittest.TestCase):
    def run_tool(self, *arguments):
        return subprocess.run([str(TOOL), *map(str, arguments)], capture_output=True, text=True,
                              check=False)

    def test_prints_and_writes_what_it_computes(self):
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory) / "tube.csv"
            result = self.run_tool(CASE, "--set", "drive.pressure_ratio=1", "--elements", 24, 3,
                                   "--csv", path)
            self.assertEqual(result.returncode, 0, result.stderr)
            with open(path, newline="", encoding="utf-8") as stream:
                header, *rows = csv.reader(stream)
        self.assertEqual(header[0], "x [R_0]")
        values = np.array(rows, float)
        self.assertEqual((values[0, 0], values[0, 1]), (0, 1))
        self.assertAlmostEqual(values[0, 2], 4 * 4 * math.pi / 0.1, delta=0.01)
        number = {line[:22].strip(): float(line[22:]) for line in result.stdout.splitlines()}
        self.assertAlmostEqual(number["largest radius"], values[:, 1].max(), delta=2e-3)
        self.assertAlmostEqual(number["Q/Q_0"], 1.45, delta=0.01)

    def test_refuses_other_cases(self):
        for override in ("units=si", "vessel.rigid=true", "wall.law=rubber", "wall.eps=soft",
                         "wall.bending=0.01", "drive.pressure_external=100",
                         "drive.pressure_ratio=-1", "wall"):
            result = self.run_tool(CASE, "--set", override)
            self.assertEqual(result.returncode, 2, override)
            self.assertIn("axisymmetric_tube: ", result.stderr)
        with self.assertRaises(CaseError):
            read_case(SOURCE / "no_such_case.toml")


if __name__ == "__main__":
    unittest.main(verbosity=2)
