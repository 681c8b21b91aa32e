"""Steady axisymmetric Navier-Stokes equations by Taylor-Hood finite elements.

Velocity (u, v) along (x, r) is biquadratic and pressure p bilinear on rectangles in (x, eta),
which r = eta R(x) maps onto the tube; R is quadratic on each element. The viscosity is 1. Stress
enters as -p I + grad u + grad u^T, so that the force on a boundary where the velocity is given is
the residual there.

Unknowns: u at all nodes (node = i * (nodes across) + j), then v, then p at corners of elements.
"""
import math

import numpy as np
import scipy.sparse
import scipy.sparse.linalg

from .elements import GAUSS, LINEAR, QUADRATIC, QUADRATIC_DERIVATIVE, WEIGHTS, on_elements


def products(first, second):
    """Tensor-product functions: [point x function, ...] as [point pair, function pair]."""
    return np.einsum("ai,bj->abij", first, second).reshape(9, -1)


VALUE = products(QUADRATIC, QUADRATIC)
D_S = products(QUADRATIC_DERIVATIVE, QUADRATIC)
D_T = products(QUADRATIC, QUADRATIC_DERIVATIVE)
PRESSURE = products(LINEAR, LINEAR)


class Flow:
    """The equations on one mesh; the radius is an argument."""

    def __init__(self, mesh):
        self.mesh = mesh
        nx, nr = len(mesh.h_x), len(mesh.h_eta)
        self.across = 2 * nr + 1
        self.nodes = len(mesh.x) * self.across
        self.size = 2 * self.nodes + (nx + 1) * (nr + 1)
        i, j = (index.ravel() for index in np.indices((nx, nr)))
        self.element_i, self.element_j = i, j
        of_velocity = np.stack([(2 * i + a) * self.across + 2 * j + b
                                for a in range(3) for b in range(3)], 1)
        of_pressure = np.stack([(i + a) * (nr + 1) + j + b
                                for a in range(2) for b in range(2)], 1)
        self.unknowns = np.concatenate(
            [of_velocity, self.nodes + of_velocity, 2 * self.nodes + of_pressure], 1)
        self.wall = np.arange(len(mesh.x)) * self.across + self.across - 1
        self.axis = self.wall - (self.across - 1)
        self.inlet, self.outlet = np.arange(self.across), self.wall[-1] - np.arange(self.across)

    def geometry(self, R):
        """At the Gauss points, [element, point]: weight of the volume per radian, radius, and
        the derivatives of the velocity's functions along x and r, [element, point, function]."""
        i, j = self.element_i, self.element_j
        h_x, h_eta = self.mesh.h_x[i, None], self.mesh.h_eta[j, None]
        nodal = on_elements(R)
        R_at = np.repeat(nodal @ QUADRATIC.T, 3, -1)[i]
        R_s = np.repeat(nodal @ QUADRATIC_DERIVATIVE.T, 3, -1)[i]
        eta = self.mesh.element_eta[j, None] + h_eta * np.tile(GAUSS, 3)
        weight = np.outer(WEIGHTS, WEIGHTS).ravel() * h_x * h_eta * R_at**2 * eta
        d_r = D_T / (h_eta * R_at)[..., None]
        d_x = (D_S - (R_s * eta)[..., None] * d_r) / h_x[..., None]
        return weight, R_at * eta, d_x, d_r

    def system(self, R, density, U):
        """Matrix and right-hand side, without boundary conditions, of Newton's method for the
        next solution about U."""
        weight, r, d_x, d_r = self.geometry(R)
        value = np.broadcast_to(VALUE, d_x.shape)
        pressure = np.broadcast_to(PRESSURE, (*d_x.shape[:2], 4))
        around = value / r[..., None]

        def integral(test, trial):
            return (test * weight[..., None]).transpose(0, 2, 1) @ trial

        xx, rr, rx = integral(d_x, d_x), integral(d_r, d_r), integral(d_r, d_x)
        K = np.zeros((len(weight), 22, 22))
        u, v, p = slice(0, 9), slice(9, 18), slice(18, 22)
        K[:, u, u] = 2 * xx + rr
        K[:, u, v] = rx
        K[:, v, u] = rx.transpose(0, 2, 1)
        K[:, v, v] = 2 * rr + xx + 2 * integral(around, around)
        K[:, u, p] = -integral(d_x, pressure)
        K[:, v, p] = -integral(d_r + around, pressure)
        K[:, p, u] = K[:, u, p].transpose(0, 2, 1)
        K[:, p, v] = K[:, v, p].transpose(0, 2, 1)
        f = np.zeros((len(weight), 22))
        if density > 0 and U.any():
            K_c, f_c = self.convection(U, value, d_x, d_r, integral)
            K += density * K_c
            f += density * f_c
        rows, columns = np.repeat(self.unknowns, 22, 1), np.tile(self.unknowns, (1, 22))
        shape = (self.size, self.size)
        return (scipy.sparse.csr_matrix((K.ravel(), (rows.ravel(), columns.ravel())), shape),
                np.bincount(self.unknowns.ravel(), f.ravel(), self.size))

    def convection(self, U, value, d_x, d_r, integral):
        """(u . grad) u linearised about U, per unit density: matrices and right-hand sides."""
        old = [U[self.unknowns[:, 9 * c : 9 * c + 9], None] for c in (0, 1)]
        at = [(value @ o)[..., 0] for o in (c.transpose(0, 1, 2) for c in old)]
        gradient = [[(d @ o)[..., 0] for d in (d_x, d_r)] for o in old]
        carried = at[0][..., None] * d_x + at[1][..., None] * d_r
        K, f = np.zeros((len(d_x), 22, 22)), np.zeros((len(d_x), 22))
        for a in (0, 1):
            test = slice(9 * a, 9 * a + 9)
            K[:, test, test] += integral(value, carried)
            for b in (0, 1):
                K[:, test, 9 * b : 9 * b + 9] += integral(value, gradient[a][b][..., None] * value)
            force = at[0] * gradient[a][0] + at[1] * gradient[a][1]
            f[:, test] = integral(value, force[..., None])[..., 0]
        return K, f

    def solve(self, R, fixed, values, force, density=0, U=None):
        """One step of Newton's method about U (none: Stokes flow): the solution with the unknowns
        `fixed` at `values` under the nodal forces `force`, and the residual, which is the force
        that holds the fixed ones."""
        U = np.zeros(self.size) if U is None else U
        matrix, right = self.system(R, density, U)
        right += force
        free = np.setdiff1d(np.arange(self.size), fixed)
        solution = np.zeros(self.size)
        solution[fixed] = values
        rows = matrix[free]
        solution[free] = scipy.sparse.linalg.spsolve(
            rows[:, free].tocsc(), (right - matrix @ solution)[free])
        return solution, matrix @ solution - right

    def end_weights(self):
        """Integral of each function over a section of radius 1, per radian: [node across]."""
        h = self.mesh.h_eta[:, None]
        eta = self.mesh.element_eta[:-1, None] + h * GAUSS
        total = np.zeros(self.across)
        local = (WEIGHTS * h * eta) @ QUADRATIC
        for b in range(3):
            total[b : b + 2 * len(h) - 1 : 2] += local[:, b]
        return total

    def between_pressures(self, R, inlet, outlet, density=0, U=None):
        """One step of Newton's method for the flow in a tube with R = 1 at its ends, whose
        pressures are given there (and no radial velocity): the solution, and the radial force of
        the fluid on the wall per radian, [node x]."""
        nodes = self.nodes
        fixed = np.unique(np.concatenate([self.wall, nodes + self.wall, nodes + self.axis,
                                          nodes + self.inlet, nodes + self.outlet]))
        force = np.zeros(self.size)
        force[self.inlet] = inlet * self.end_weights()
        force[self.outlet[::-1]] = -outlet * self.end_weights()
        solution, residual = self.solve(R, fixed, 0, force, density, U)
        return solution, -residual[nodes + self.wall]

    def flow_rate(self, solution):
        """Through the inlet, of radius 1."""
        return 2 * math.pi * self.end_weights() @ solution[self.inlet]

    def velocity(self, solution):
        """(u, v) at the nodes: two arrays [node x, node across]."""
        return solution[: 2 * self.nodes].reshape(2, len(self.mesh.x), self.across)

    def pressure(self, solution):
        """At the corners of the elements, [x, eta]."""
        return solution[2 * self.nodes :].reshape(len(self.mesh.element_x), -1)
