#include "grid/boundary.hpp"

namespace starling {

namespace {

/// One plane: z periodic in every row, then the rows outside the y walls times `sign`.
void fill_plane(const Grid& g, View<Real> f, Index i, Real sign, bool on_y_faces)
{
    const Index ny = g.ny(), nz = g.nz();
    if (on_y_faces)
        for (Index k = 0; k < nz; ++k) f(i, 0, k) = f(i, ny, k) = 0;
    for (Index j = 0; j < ny; ++j) {
        f(i, j, -1) = f(i, j, nz - 1);
        f(i, j, nz) = f(i, j, 0);
    }
    for (Index k = -1; k <= nz; ++k) {
        f(i, -1, k) = on_y_faces ? -f(i, 1, k) : sign * f(i, 0, k);
        f(i, ny, k) = on_y_faces ? 0 : sign * f(i, ny - 1, k);
    }
}

/// Copies plane `from` times `sign` to plane `to`, halos included.
void copy_plane(const Grid& g, View<Real> f, Index to, Index from, Real sign)
{
    for (Index j = -1; j <= g.ny(); ++j)
        for (Index k = -1; k <= g.nz(); ++k) f(to, j, k) = sign * f(from, j, k);
}

} // namespace

void fill_velocity_halo(const Grid& g, Location c, ScalarField& field)
{
    const View<Real> f = field.view();
    const bool on_x = c == Location::u, on_y = c == Location::v;
    const Index planes = g.nx() + (on_x ? 1 : 0);
    for_planes(0, planes, [=, &g](Index i) { fill_plane(g, f, i, -1, on_y); });
    copy_plane(g, f, -1, on_x ? 1 : 0, 1);
    copy_plane(g, f, planes, g.nx() - 1, 1);
}

void fill_velocity_halo(const Grid& g, VectorField& u)
{
    for (Location c : components) fill_velocity_halo(g, c, u[c]);
}

void fill_increment_halo(const Grid& g, ScalarField& phi)
{
    const View<Real> f = phi.view();
    for_planes(0, g.nx(), [=, &g](Index i) { fill_plane(g, f, i, 1, false); });
    copy_plane(g, f, -1, 0, -1);
    copy_plane(g, f, g.nx(), g.nx() - 1, -1);
}

Array<Real> inside_share(const Grid& g)
{
    Array<Real> share(g.ny() * g.nz());
    for (Index j = 0; j < g.ny(); ++j)
        for (Index k = 0; k < g.nz(); ++k) {
            const Real y = g.y(Location::cell, j), z = g.z(Location::cell, k);
            share[j * g.nz() + k] = y * y + z * z < 1 ? 1 : 0;
        }
    return share;
}

} // namespace starling
