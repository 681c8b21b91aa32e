"""Flow and membrane together.

Lubrication theory gives the first guess, followed up in load, and its derivatives the matrix of a
quasi-Newton method, which Broyden's updates improve. The solution is that of flow and membrane
alone.
"""
import dataclasses
import math

import numpy as np

from .elements import on_elements, sum_to_nodes, tube_mesh
from .flow import Flow
from .membrane import membrane_forces


class NoSolution(RuntimeError):
    """The iterations found no steady tube."""


def quadrature_weights(mesh):
    """Simpson's weight of each node along x."""
    return sum_to_nodes(mesh.h_x[:, None] * np.array([1, 4, 1]) / 6)


@dataclasses.dataclass
class Lubrication:
    """The tube with -dP/dx = g/R^4, on the same mesh."""

    case: object
    mesh: object

    def residual(self, R, load):
        """Force balance of the wall at its free nodes at a share `load` of the pressures."""
        step = np.diff(self.mesh.x) / 2
        d = R**-4
        P = np.zeros_like(R)
        np.cumsum(step * (d[..., 1:] + d[..., :-1]), -1, out=P[..., 1:])
        inlet, outlet = self.case.pressure_inlet, self.case.pressure_outlet
        P = inlet - (inlet - outlet) * P / P[..., -1:]
        pressed = load * quadrature_weights(self.mesh) * P * R
        return (membrane_forces(self.case.law, self.mesh, R) - pressed)[..., self.mesh.free]

    def jacobian(self, R, load):
        """Derivatives of the residual by complex steps: [residual, free node]."""
        tiny = 1e-30
        steps = np.eye(len(R))[self.mesh.free] * (1j * tiny)
        return self.residual(R + steps, load).imag.T / tiny

    def newton(self, R, load):
        """The radius at `load` from a guess, or None."""
        R = R.copy()
        for _ in range(12):
            change = np.linalg.solve(self.jacobian(R, load), self.residual(R, load))
            largest = np.abs(change / R[self.mesh.free]).max()
            if not math.isfinite(largest):
                return None
            R[self.mesh.free] -= change * min(1, 0.3 / max(largest, 1e-30))
            if largest < 1e-9:
                return R
        return None

    def solve(self):
        """Follows the tube from no load to the whole in steps that adapt."""
        R, load, step = np.ones(len(self.mesh.x)), 0.0, 0.25
        while load < 1:
            following = self.newton(R, min(load + step, 1))
            if following is None:
                step /= 2
                if step < 1e-4:
                    raise NoSolution(f"no steady tube beyond {load:.4f} of the pressures")
            else:
                R, load, step = following, min(load + step, 1), min(1.5 * step, 0.25)
        return R


@dataclasses.dataclass
class Solution:
    """A steady tube; lengths in R_0, pressures in rho U_c^2."""

    Q_over_Q0: float
    R_max: float
    x_R_max: float
    largest_slope: float
    x: np.ndarray  # ends of the elements along x, and there:
    R: np.ndarray
    P_axis: np.ndarray  # pressure on the axis
    wall_load: np.ndarray  # radial force on the wall per deformed circumference and length along x
    steps: int  # of the coupled iteration


def largest_radius(mesh, R):
    """The largest value of the piecewise parabolas R(x), and its place."""
    a, b, c = np.moveaxis(on_elements(R), -1, 0)
    bend = 2 * (a - 2 * b + c)
    with np.errstate(divide="ignore", invalid="ignore"):
        s = np.where(bend < 0, np.clip((3 * a - 4 * b + c) / (2 * bend), 0, 1), 0)
    values = a + s * (4 * b - 3 * a - c) + s**2 * bend
    best = np.argmax(values)
    return values[best], mesh.element_x[best] + s[best] * mesh.h_x[best]


class Coupling:
    """Iterates on radius and flow at once: one step of Newton's method of the flow, one of a
    quasi-Newton method of the wall."""

    most_steps, converged = 40, 1e-9

    def __init__(self, case, mesh):
        self.case, self.mesh, self.flow = case, mesh, Flow(mesh)
        guess = Lubrication(case, mesh)
        self.R = guess.solve()
        self.inverse = np.linalg.inv(guess.jacobian(self.R, 1))
        self.U, self.load, self.steps = None, None, 0

    def residual(self, density):
        self.U, self.load = self.flow.between_pressures(
            self.R, self.case.pressure_inlet, self.case.pressure_outlet, density, self.U)
        return (membrane_forces(self.case.law, self.mesh, self.R) - self.load)[self.mesh.free]

    def update_inverse(self, step, change):
        """Broyden's update: the inverse maps the change of the residual to the step."""
        mapped = self.inverse @ change
        self.inverse += np.outer(step - mapped, step @ self.inverse) / (step @ mapped)

    def solve(self, density):
        """Moves R and U to the solution at this density; False if that fails."""
        free = self.mesh.free
        residual = self.residual(density)
        for n in range(self.most_steps):
            step = -self.inverse @ residual
            largest = np.abs(step / self.R[free]).max()
            if not math.isfinite(largest):
                return False
            if largest < self.converged:
                return True
            step *= min(1, 0.1 / largest)
            self.R[free] += step
            self.steps += 1
            before, residual = residual, self.residual(density)
            if n > 1:
                self.update_inverse(step, residual - before)
        return False

    def follow(self):
        """Raises the density from 0 (Stokes flow) to Re, in one step if that works."""
        if not self.solve(0):
            raise NoSolution("the Stokes flow in the tube did not converge")
        density, step = 0.0, self.case.reynolds
        while density < self.case.reynolds:
            kept = self.R.copy(), self.U.copy(), self.inverse.copy()
            following = min(density + step, self.case.reynolds)
            if self.solve(following):
                density, step = following, 2 * step
            else:
                self.R, self.U, self.inverse = kept
                step /= 2
                if step < 0.05 * self.case.reynolds:
                    raise NoSolution(f"no steady flow found beyond Re = {density:.4g}")


def solve_tube(case, along=120, across=8):
    """The steady tube of a case on a mesh of `along` elements between the clamps and `across` the
    radius. Raises NoSolution."""
    coupling = Coupling(case, tube_mesh(case, along, across))
    coupling.follow()
    mesh, flow, R = coupling.mesh, coupling.flow, coupling.R
    R_max, x_R_max = largest_radius(mesh, R)
    in_rho_U2 = 1 / case.reynolds
    load = coupling.load / (R * quadrature_weights(mesh))
    return Solution(
        Q_over_Q0=flow.flow_rate(coupling.U) / (math.pi / 2), R_max=R_max, x_R_max=x_R_max,
        largest_slope=np.abs(np.diff(R) / np.diff(mesh.x)).max(), x=mesh.element_x, R=R[::2],
        P_axis=case.pressure_external + in_rho_U2 * flow.pressure(coupling.U)[:, 0],
        wall_load=case.pressure_external + in_rho_U2 * load[::2], steps=coupling.steps)
