#include "immersed_boundary/section_flow.hpp"

#include "immersed_boundary/bracket.hpp"

namespace starling {

namespace {

/// Mean over a face of the velocity with the value u(i, j, k) in its centre, to fourth order.
Real cell_mean(View<const Real> u, Index i, Index j, Index k)
{
    const Real neighbours = u(i, j - 1, k) + u(i, j + 1, k) + u(i, j, k - 1) + u(i, j, k + 1);
    return u(i, j, k) + (neighbours - 4 * u(i, j, k)) / 24;
}

} // namespace

SectionFlow::SectionFlow(const Grid& g, const Tube& tube)
    : grid_(g), section_(tube), covered_(static_cast<std::size_t>(g.nz())),
      integral_(static_cast<std::size_t>(g.nz()))
{
}

/// Adds one sub-row's piece of the inside to the cells it crosses.
void SectionFlow::add_span(View<const Real> u, Index i, Real y, Real z_begin, Real z_end)
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
        const Real value = (1 - b) * ((1 - c) * u(i, j, n) + c * u(i, j, n + 1)) +
                           b * ((1 - c) * u(i, j + 1, n) + c * u(i, j + 1, n + 1));
        const Real area = width * (high - low);
        covered_[static_cast<std::size_t>(k)] += area;
        integral_[static_cast<std::size_t>(k)] += area * value;
    }
}

Real SectionFlow::inside(const ScalarField& field, const Array<Vec3>& x, Index i)
{
    const View<const Real> u = field.view();
    const Real full = grid_.spacing().y * grid_.spacing().z;
    section_.cut(x, grid_.x(Location::u, i));
    Real flow = 0;
    for (Index j = 0; j < grid_.ny(); ++j) {
        std::fill(covered_.begin(), covered_.end(), 0);
        std::fill(integral_.begin(), integral_.end(), 0);
        for (Index m = 0; m < sub_rows; ++m) {
            const Real y = grid_.origin().y + grid_.spacing().y * (static_cast<Real>(j) +
                                                                   (static_cast<Real>(m) + 0.5) /
                                                                       static_cast<Real>(sub_rows));
            const auto& z = section_.crossings(y);
            for (std::size_t n = 0; n + 1 < z.size(); n += 2) add_span(u, i, y, z[n], z[n + 1]);
        }
        for (Index k = 0; k < grid_.nz(); ++k) {
            const auto n = static_cast<std::size_t>(k);
            flow += covered_[n] > full * (1 - 1e-9) ? full * cell_mean(u, i, j, k) : integral_[n];
        }
    }
    return flow;
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
