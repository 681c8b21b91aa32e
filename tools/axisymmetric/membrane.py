"""The wall: principal tensions of the four elastic laws, and the forces of a membrane of them.

Tensions are force per deformed length, Eqs. (10)-(13) of Krul & Bagchi (2024), of the stretches
lambda1 (along the tube) and lambda2 (around it). Numbers may be complex: derivatives are taken by
complex steps.
"""
import dataclasses

import numpy as np

from .elements import QUADRATIC, QUADRATIC_DERIVATIVE, WEIGHTS, on_elements, sum_to_nodes


@dataclasses.dataclass(frozen=True)
class Hooke:
    G_s: float
    nu_s: float = 0.5

    def tensions(self, lambda1, lambda2):
        k = self.G_s / (1 - self.nu_s)
        e1, e2 = lambda1**2 - 1, lambda2**2 - 1
        return k * (e1 + self.nu_s * e2), k * (e2 + self.nu_s * e1)


@dataclasses.dataclass(frozen=True)
class MooneyRivlin:
    G_s: float
    psi: float = 0.5

    def tensions(self, lambda1, lambda2):
        J = lambda1 * lambda2
        tau1 = self.G_s / J * (lambda1**2 - J**-2) * (self.psi + (1 - self.psi) * lambda2**2)
        tau2 = self.G_s / J * (lambda2**2 - J**-2) * (self.psi + (1 - self.psi) * lambda1**2)
        return tau1, tau2


def NeoHookean(G_s):
    return MooneyRivlin(G_s, psi=1.0)


@dataclasses.dataclass(frozen=True)
class Skalak:
    G_s: float
    C: float = 1.0

    def tensions(self, lambda1, lambda2):
        J = lambda1 * lambda2
        area = self.C * J**2 * (J**2 - 1)
        return (self.G_s / J * (lambda1**2 * (lambda1**2 - 1) + area),
                self.G_s / J * (lambda2**2 * (lambda2**2 - 1) + area))


def membrane_forces(law, mesh, R):
    """Virtual work per radian of the tensions for a unit dR at each node, [..., node]:

        integral of lambda2 tau1 (R'/lambda1) dR' + lambda1 tau2 dR  dx

    as points of the wall move radially only, so that lambda1 = sqrt(1 + R'^2) and lambda2 = R.
    `R` may have several radii of the tube, [..., node]."""
    h = mesh.h_x[:, None]
    nodal = on_elements(R)
    radius = nodal @ QUADRATIC.T
    slope = nodal @ QUADRATIC_DERIVATIVE.T / h
    lambda1 = np.sqrt(1 + slope**2)
    tau1, tau2 = law.tensions(lambda1, radius)
    along = WEIGHTS * radius * tau1 * slope / lambda1
    around = WEIGHTS * h * lambda1 * tau2
    return sum_to_nodes(along @ QUADRATIC_DERIVATIVE + around @ QUADRATIC)
