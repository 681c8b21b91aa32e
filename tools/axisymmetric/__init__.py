"""Axisymmetric steady flow in the clamped compliant tube, by finite elements fitted to the wall.

An independent reference for inflation: no grid, no immersed boundary and no lubrication theory in
common with Starling. Modules: case (the case file), elements (shape functions, mesh), flow
(Navier-Stokes), membrane (the wall), tube (both together).

Inside, pressures are in mu U_c/R_0 and relative to the pressure outside: the viscosity is then 1,
the density Re and the wall's modulus G_s = 1/eps. The tool is described in docs/theory.md.
"""
