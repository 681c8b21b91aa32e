#include "immersed_boundary/section_flow.hpp"

#include "immersed_boundary/bracket.hpp"
#include "immersed_boundary/delta.hpp"

namespace starling {

namespace {

/// Integral of the quadratic B-spline from minus infinity to s.
Real quadratic_bspline_below(Real s)
{
    if (s <= -1.5) return 0;
    if (s >= 1.5) return 1;
    if (s < -0.5) return (s + 1.5) * (s + 1.5) * (s + 1.5) / 6;
    if (s > 0.5) return 1 - (1.5 - s) * (1.5 - s) * (1.5 - s) / 6;
    return 0.5 + s * (0.75 - s * s / 3);
}

/// Weights along x, and with the second difference along x taken off, of six nodes.
struct AlongX6 {
    Index first;
    std::array<Real, 6> blunt{}, sharp{};
};

AlongX6 weights_along_x(Real s)
{
    constexpr Real a = composite_bsplines.sharpening;
    const Stencil4 stencil = delta_weights(composite_bsplines.along, s);
    AlongX6 w{stencil.first - 1};
    std::copy(stencil.weight.begin(), stencil.weight.end(), w.blunt.begin() + 1);
    for (std::size_t n = 0; n < 6; ++n) {
        const Real before = n > 0 ? w.blunt[n - 1] : 0, after = n < 5 ? w.blunt[n + 1] : 0;
        w.sharp[n] = (1 + 6 * a) * w.blunt[n] - a * (before + after);
    }
    return w;
}

} // namespace

SectionFlow::SectionFlow(const Grid& g, const Tube& tube)
    : grid_(g), section_(tube), covered_(static_cast<std::size_t>(g.nz()))
{
}

void SectionFlow::add_spans(Real y, Real z_begin, Real z_end)
{
    const Real h = grid_.spacing().z, z0 = grid_.origin().z;
    const Real width = grid_.spacing().y / static_cast<Real>(sub_rows);
    const auto [j, b] = bracket((y - grid_.y(Location::u, 0)) / grid_.spacing().y, -1, grid_.ny());
    const auto cell = [&](Real z) {
        return std::clamp<Index>(static_cast<Index>(std::floor((z - z0) / h)), 0, grid_.nz() - 1);
    };
    for (Index k = cell(z_begin); k <= cell(z_end); ++k) {
        const Real low = std::max(z_begin, z0 + h * static_cast<Real>(k));
        const Real high = std::min(z_end, z0 + h * static_cast<Real>(k + 1));
        if (high <= low) continue;
        const Real centre = 0.5 * (low + high);
        const auto [n, c] = bracket((centre - grid_.z(Location::u, 0)) / h, -1, grid_.nz());
        spans_.push_back({k, j, n, b, c, width * (high - low)});
        covered_[static_cast<std::size_t>(k)] += width * (high - low);
    }
}

template <class Add>
void SectionFlow::for_weights(const Array<Vec3>& x, Index i, Add add)
{
    const Real full = grid_.spacing().y * grid_.spacing().z;
    const auto is_full = [&](Index k) {
        return covered_[static_cast<std::size_t>(k)] > full * (1 - 1e-9);
    };
    section_.cut(x, grid_.x(Location::u, i));
    for (Index j = 0; j < grid_.ny(); ++j) {
        std::fill(covered_.begin(), covered_.end(), 0);
        spans_.clear();
        for (Index m = 0; m < sub_rows; ++m) {
            const Real y = grid_.origin().y + grid_.spacing().y * (static_cast<Real>(j) +
                                                                   (static_cast<Real>(m) + 0.5) /
                                                                       static_cast<Real>(sub_rows));
            const auto& z = section_.crossings(y);
            for (std::size_t n = 0; n + 1 < z.size(); n += 2) add_spans(y, z[n], z[n + 1]);
        }
        // Mean over a whole face from its centre and the neighbours, to fourth order.
        for (Index k = 0; k < grid_.nz(); ++k) {
            if (!is_full(k)) continue;
            add(j, k, full * 5 / 6);
            for (Index d : {-1, 1}) {
                add(j + d, k, full / 24);
                add(j, k + d, full / 24);
            }
        }
        for (const Span& s : spans_) {
            if (is_full(s.k)) continue;
            add(s.j, s.n, s.area * (1 - s.b) * (1 - s.c));
            add(s.j, s.n + 1, s.area * (1 - s.b) * s.c);
            add(s.j + 1, s.n, s.area * s.b * (1 - s.c));
            add(s.j + 1, s.n + 1, s.area * s.b * s.c);
        }
    }
}

Real SectionFlow::inside(const ScalarField& field, const Array<Vec3>& x, Index i)
{
    const View<const Real> u = field.view();
    Real flow = 0;
    for_weights(x, i, [&](Index j, Index k, Real weight) { flow += weight * u(i, j, k); });
    return flow;
}

// Weight of a node: the integral of its kernel over the section, exact along z.
template <class Add>
void SectionFlow::for_reconstruction_weights(const Array<Vec3>& x, Real plane_x, Add add)
{
    const Real h = grid_.spacing().z, sub = grid_.spacing().y / static_cast<Real>(sub_rows);
    section_.cut(x, plane_x);
    for (Index m = 0; m < grid_.ny() * sub_rows; ++m) {
        const Real from_bottom = sub * (static_cast<Real>(m) + 0.5);
        const Stencil4 rows =
            delta_weights(Kernel::quadratic_bspline, from_bottom / grid_.spacing().y - 0.5);
        const auto& z = section_.crossings(grid_.origin().y + from_bottom);
        for (std::size_t n = 0; n + 1 < z.size(); n += 2) {
            const Real begin = (z[n] - grid_.z(Location::u, 0)) / h;
            const Real end = (z[n + 1] - grid_.z(Location::u, 0)) / h;
            const auto first = static_cast<Index>(std::floor(begin - 0.5));
            const auto last = static_cast<Index>(std::floor(end + 1.5));
            for (Index k = first; k <= last; ++k) {
                const Real length = h * (quadratic_bspline_below(end - static_cast<Real>(k)) -
                                         quadratic_bspline_below(begin - static_cast<Real>(k)));
                for (Index l = 0; l < 3; ++l)
                    add(rows.first + l, k, sub * rows.weight[static_cast<std::size_t>(l)] * length);
            }
        }
    }
}

Real SectionFlow::reconstructed(const ScalarField& field, const Array<Vec3>& x, Real plane_x)
{
    const View<const Real> u = field.view();
    const AlongX6 w = weights_along_x((plane_x - grid_.x(Location::u, 0)) / grid_.spacing().x);
    const auto along = [&](Index j, Index k, const std::array<Real, 6>& weight) {
        Real sum = 0;
        for (Index n = 0; n < 6; ++n) {
            const Index i = w.first + n, last = grid_.nx(); // mirrored at the end faces
            sum += weight[static_cast<std::size_t>(n)] * u(i < 0      ? -i
                                                           : i > last ? 2 * last - i
                                                                      : i,
                                                           j, k);
        }
        return sum;
    };
    Real flow = 0;
    for_reconstruction_weights(x, plane_x, [&](Index j, Index k, Real weight) {
        Real beside = 0;
        for (Index d : {-1, 1}) beside += along(j + d, k, w.blunt) + along(j, k + d, w.blunt);
        flow += weight * (along(j, k, w.sharp) - composite_bsplines.sharpening * beside);
    });
    return flow;
}

Array<Real> SectionFlow::weights(const Array<Vec3>& x, Index i)
{
    Array<Real> sums(grid_.ny() * grid_.nz());
    for_weights(x, i, [&](Index j, Index k, Real weight) { sums[j * grid_.nz() + k] += weight; });
    return sums;
}

Real SectionFlow::total(const ScalarField& field, Index i) const
{
    const View<const Real> u = field.view();
    Real sum = 0;
    for (Index j = 0; j < grid_.ny(); ++j)
        for (Index k = 0; k < grid_.nz(); ++k) sum += u(i, j, k);
    return sum * grid_.spacing().y * grid_.spacing().z;
}

Real interpolate_at(const Grid& g, Location where, const ScalarField& field, const Vec3& p)
{
    const View<const Real> f = field.view();
    const Vec3 origin = g.position(where, 0, 0, 0), h = g.spacing();
    const auto [i, a] = bracket((p.x - origin.x) / h.x, -1, g.nx());
    const auto [j, b] = bracket((p.y - origin.y) / h.y, -1, g.ny());
    const auto [k, c] = bracket((p.z - origin.z) / h.z, -1, g.nz());
    Real sum = 0;
    for (Index l = 0; l < 8; ++l) {
        const Index di = l / 4, dj = l / 2 % 2, dk = l % 2;
        sum += (di ? a : 1 - a) * (dj ? b : 1 - b) * (dk ? c : 1 - c) * f(i + di, j + dj, k + dk);
    }
    return sum;
}

} // namespace starling
