"""Shape functions on the unit interval, Gauss points, and the mesh of a tube."""
import math

import numpy as np


def linear(s):
    """Values of the two linear shape functions at the points s: [point, function]."""
    return np.stack([1 - s, s], -1)


def quadratic(s):
    """Values of the three quadratic shape functions (nodes 0, 1/2, 1): [point, function]."""
    return np.stack([(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)], -1)


def quadratic_derivative(s):
    """Their derivatives: [point, function]."""
    return np.stack([4 * s - 3, 4 - 8 * s, 4 * s - 1], -1)


# Three Gauss points on the unit interval, exact for polynomials of degree 5.
GAUSS = (1 + math.sqrt(0.6) * np.array([-1, 0, 1])) / 2
WEIGHTS = np.array([5, 8, 5]) / 18
LINEAR, QUADRATIC = linear(GAUSS), quadratic(GAUSS)
QUADRATIC_DERIVATIVE = quadratic_derivative(GAUSS)


def on_elements(nodal):
    """Values at the nodes of quadratic elements in a row, [..., node], as [..., element, 3]."""
    return np.stack([nodal[..., :-2:2], nodal[..., 1:-1:2], nodal[..., 2::2]], -1)


def sum_to_nodes(local):
    """The transpose of `on_elements`: adds [..., element, 3] up at the nodes."""
    total = np.zeros((*local.shape[:-2], 2 * local.shape[-2] + 1), local.dtype)
    total[..., :-2:2] += local[..., 0]
    total[..., 1:-1:2] += local[..., 1]
    total[..., 2::2] += local[..., 2]
    return total


def with_midpoints(ends):
    """Nodes of quadratic elements between `ends`."""
    nodes = np.empty(2 * len(ends) - 1)
    nodes[::2], nodes[1::2] = ends, (ends[1:] + ends[:-1]) / 2
    return nodes


def clustered(length, count):
    """Points from 0 to `length`, about 100 times denser at both ends than in the middle."""
    beta = 3
    s = np.linspace(-1, 1, count + 1)
    return length / 2 * (1 + np.tanh(beta * s) / math.tanh(beta))


def graded(length, smallest):
    """Points from 0 to `length`, growing from an element of about `smallest`."""
    power = 1.8
    count = max(4, math.ceil((length / smallest) ** (1 / power)))
    return length * np.linspace(0, 1, count + 1) ** power


class Mesh:
    """Rectangles in (x, eta) with eta = r/R: `element_x` and `element_eta` are their edges, `x`
    and `eta` the nodes of their quadratic functions. `free` are the nodes x where the wall moves."""

    def __init__(self, element_x, element_eta, free=slice(0, 0)):
        self.element_x, self.element_eta = element_x, element_eta
        self.x, self.eta = with_midpoints(element_x), with_midpoints(element_eta)
        self.h_x, self.h_eta = np.diff(element_x), np.diff(element_eta)
        self.free = free


def tube_mesh(case, along, across):
    """`along` elements between the clamps and `across` the radius, smallest at the clamps and at
    the wall: stress is singular in the corner where the slope jumps."""
    between = clustered(case.length - case.rigid_inlet - case.rigid_outlet, along)
    inlet = case.rigid_inlet - graded(case.rigid_inlet, between[1])[:0:-1]
    outlet = case.length - case.rigid_outlet + graded(case.rigid_outlet, between[1])[1:]
    first = len(inlet)
    element_x = np.concatenate([inlet, case.rigid_inlet + between, outlet])
    return Mesh(element_x, 1 - np.linspace(1, 0, across + 1) ** 2,
                slice(2 * first + 1, 2 * (first + along)))
