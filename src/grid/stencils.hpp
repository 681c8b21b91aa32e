#pragma once
/// Staggered finite-volume stencils, each written once for any component.
///
///         v(i,j+1)
///        +----^----+
///  u(i)  >  P(i,j) >  u(i+1)      u, v, w sit on the low faces of their cell
///        +----^----+
///          v(i,j)
#include <algorithm>

#include "grid/field.hpp"

namespace starling {

/// Divergence of u in cell (i, j, k).
struct DivergenceAtCell {
    View<const Real> u, v, w;
    Real inv_dx, inv_dy, inv_dz;

    DivergenceAtCell(const Grid& g, const VectorField& f)
        : u(f[Location::u].view()), v(f[Location::v].view()), w(f[Location::w].view()),
          inv_dx(1 / g.spacing().x), inv_dy(1 / g.spacing().y), inv_dz(1 / g.spacing().z)
    {
    }
    Real operator()(Index i, Index j, Index k) const
    {
        return (u(i + 1, j, k) - u(i, j, k)) * inv_dx + (v(i, j + 1, k) - v(i, j, k)) * inv_dy +
               (w(i, j, k + 1) - w(i, j, k)) * inv_dz;
    }
};

/// Seven-point Laplacian of a field at its own location; `f` has valid halos.
struct Laplacian {
    Real ax = 0, ay = 0, az = 0;

    explicit Laplacian(const Vec3& h)
        : ax(1 / (h.x * h.x)), ay(1 / (h.y * h.y)), az(1 / (h.z * h.z))
    {
    }
    Real operator()(View<const Real> f, Index n) const
    {
        const Real* p = f.data + n;
        const Index sx = f.stride_x, sy = f.stride_y;
        return ax * (p[sx] - 2 * p[0] + p[-sx]) + ay * (p[sy] - 2 * p[0] + p[-sy]) +
               az * (p[1] - 2 * p[0] + p[-1]);
    }
};

/// div(u c) at the node of component c, second-order central, conservative:
/// sum over d of [ (c + c_d)/2 (u_d + u_d shifted back along c)/2 ] over the faces of c's volume.
template <Location C>
struct Advection {
    View<const Real> c, u, v, w;
    Real qx, qy, qz; ///< 1/(4 spacing)

    Advection(const Grid& g, const VectorField& f)
        : c(f[C].view()), u(f[Location::u].view()), v(f[Location::v].view()),
          w(f[Location::w].view()), qx(0.25 / g.spacing().x), qy(0.25 / g.spacing().y),
          qz(0.25 / g.spacing().z)
    {
    }
    Real operator()(Index n) const
    {
        return qx * flux_difference(u, n, c.stride_x) + qy * flux_difference(v, n, c.stride_y) +
               qz * flux_difference(w, n, 1);
    }

private:
    /// Four times the difference of the fluxes through the two faces normal to d.
    Real flux_difference(View<const Real> u_d, Index n, Index d) const
    {
        const Index back = c.stride(axis(C));
        const Real* f = c.data + n;
        const Real* a = u_d.data + n;
        return (f[0] + f[d]) * (a[d] + a[d - back]) - (f[-d] + f[0]) * (a[0] + a[-back]);
    }
};

/// What `Advection` lacks at the nodes next to an end face x = 0 or L. On the face, where the halo,
/// even about it, has a divergence of its own, u div(u) is taken out, and u du/dx is upwind where
/// fluid leaves the box and none where it enters. What enters brings no v and no w. Deviation:
/// docs/numerics.md, "The ends".
template <Location C>
struct AdvectionAtEnd {
    View<const Real> c, u;
    Index inwards;   ///< from a node to its neighbour further from the face
    Index face;      ///< from a node of v or w to the u-face at the end
    Real outwards_h; ///< 1/spacing, negative at the inlet: the sign of a velocity that leaves

    AdvectionAtEnd(const Grid& g, const VectorField& f, bool inlet)
        : c(f[C].view()), u(f[Location::u].view()), inwards(inlet ? c.stride_x : -c.stride_x),
          face(inlet ? 0 : c.stride_x), outwards_h((inlet ? -1 : 1) / g.spacing().x)
    {
    }
    Real operator()(Index n) const
    {
        if constexpr (C == Location::u) {
            const Real leaving = c.data[n] * outwards_h;
            return (leaving + std::max(leaving, Real{0})) * (c.data[n] - c.data[n + inwards]);
        } else {
            const Real* at_face = u.data + n + face;
            const Real leaving = (at_face[0] + at_face[-c.stride(axis(C))]) / 2 * outwards_h;
            return std::max(-leaving, Real{0}) * c.data[n];
        }
    }
};

} // namespace starling
