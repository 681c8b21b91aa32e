#include "immersed_boundary/transfer.hpp"

namespace starling {

namespace {

template <std::size_t n>
using Width = std::integral_constant<std::size_t, n>;

/// Calls f with the number of nodes in y and z that can have weight for component c.
template <class F>
void with_widths(const KernelPair& kernels, Location c, F f)
{
    const auto call = [&](auto along, auto across) {
        switch (c) {
        case Location::u: return f(across, across);
        case Location::v: return f(along, across);
        default: return f(across, along);
        }
    };
    if (node_count(kernels.across) == 3)
        call(Width<4>{}, Width<3>{});
    else
        call(Width<4>{}, Width<4>{});
}

Real Vec3::*component_of_vector(Location c)
{
    return c == Location::u ? &Vec3::x : c == Location::v ? &Vec3::y : &Vec3::z;
}

/// The weights of nodes beyond the ends 0 and `last` at the mirror images of these nodes: about the
/// end face of a tube for cells, about the node on it for faces. `count` nodes can have weight.
Stencil4 fold_at_ends(const Stencil4& s, Index last, std::size_t count, bool cells)
{
    const Index width = static_cast<Index>(count);
    Stencil4 folded{static_cast<std::int32_t>(std::clamp<Index>(s.first, 0, last + 1 - width)), {}};
    for (Index m = 0; m < width; ++m) {
        Index n = s.first + m;
        if (n < 0) n = cells ? -1 - n : -n;
        if (n > last) n = 2 * last - n + (cells ? 1 : 0);
        folded.weight[static_cast<std::size_t>(n - folded.first)] +=
            s.weight[static_cast<std::size_t>(m)];
    }
    return folded;
}

/// Copies to the halos of the end planes their mirror images, in the rows of the box.
void mirror_at_ends(const Grid& g, Location c, const Box& b, View<Real> f)
{
    const Index image = c == Location::u ? 1 : 0, last = g.unknowns(c).end[0] - 1;
    for (Index j = b.begin[1]; j < b.end[1]; ++j)
        for (Index k = b.begin[2]; k < b.end[2]; ++k) {
            f(-1, j, k) = f(image, j, k);
            f(last + 1, j, k) = f(last - image, j, k);
        }
}

/// Zeros in the rows of plane i, and in the halos between them.
void clear_plane(const Box& b, Index i, View<Real> f)
{
    std::fill(&f(i, b.begin[1], b.begin[2]), &f(i, b.end[1] - 1, b.end[2]), 0);
}

/// to = S from in plane i of the box.
void sharpen_plane(Real a, const Box& b, Index i, View<const Real> from, View<Real> to)
{
    const Real centre = 1 + 6 * a;
    for (Index j = b.begin[1]; j < b.end[1]; ++j) {
#pragma omp simd
        for (Index k = b.begin[2]; k < b.end[2]; ++k)
            to(i, j, k) = centre * from(i, j, k) -
                          a * (from(i - 1, j, k) + from(i + 1, j, k) + from(i, j - 1, k) +
                               from(i, j + 1, k) + from(i, j, k - 1) + from(i, j, k + 1));
    }
}

} // namespace

Transfer::Transfer(const Grid& g, const Tube& tube, KernelPair kernels, RingRange acting)
    : grid_(g), tube_(&tube), kernels_(kernels),
      acting_(acting), y_{Array<Stencil4>(static_cast<Index>(tube.X.size())),
                          Array<Stencil4>(static_cast<Index>(tube.X.size()))},
      z_(y_), scratch_(g)
{
    const Real h = g.spacing().x;
    for (Real x : tube.ring_x)
        ring_stencils_.push_back(
            {fold_at_ends(delta_weights(kernels.across, (x - g.x(Location::cell, 0)) / h),
                          g.nx() - 1, node_count(kernels.across), true),
             fold_at_ends(delta_weights(kernels.along, (x - g.x(Location::u, 0)) / h), g.nx(),
                          node_count(kernels.along), false)});
    reached_.begin[0] = reached_.end[0] = 0;
    if (acting.begin < acting.end) {
        reached_.begin[0] = stencil_x(Location::cell, acting.begin).first;
        reached_.end[0] = stencil_x(Location::u, acting.end - 1).first + 4;
    }
}

const Stencil4& Transfer::stencil_x(Location c, Index ring) const
{
    const RingStencils& s = ring_stencils_[static_cast<std::size_t>(ring)];
    return c == Location::u ? s.x_face : s.x_cell;
}

Transfer::Extent Transfer::extent(const Array<Vec3>& x, Real Vec3::*coordinate, Real origin, Real h,
                                  Index cells) const
{
    const Vec3* position = x.data();
    const Real inverse = 1 / h, top = static_cast<Real>(cells - 2);
    Real low = top, high = 2;
    Index bad = 0;
#pragma omp parallel for schedule(static) reduction(+ : bad) reduction(min : low) \
    reduction(max : high)
    for (Index v = tube_->first(acting_.begin); v < tube_->first(acting_.end); ++v) {
        const Real s = (position[v].*coordinate - origin) * inverse;
        bad += !(s > 2 && s < top);
        low = std::min(low, s);
        high = std::max(high, s);
    }
    return {low, high, bad == 0};
}

void Transfer::weigh(const Array<Vec3>& x, Real Vec3::*coordinate, Real origin, Real h,
                     Stencils& stencils)
{
    const Vec3* position = x.data();
    Stencil4 *along = stencils.along.data(), *across = stencils.across.data();
    const Real inverse = 1 / h;
    const KernelPair kernels = kernels_;
    for_range(tube_->first(acting_.begin), tube_->first(acting_.end), [=](Index v) {
        const Real s = (position[v].*coordinate - origin) * inverse;
        across[v] = delta_weights(kernels.across, s - 0.5);
        along[v] = delta_weights(kernels.along, s);
    });
}

bool Transfer::update(const Array<Vec3>& x)
{
    if (acting_.begin == acting_.end) return true; // reaches no node
    const Vec3 h = grid_.spacing(), origin = grid_.origin();
    const Extent y = extent(x, &Vec3::y, origin.y, h.y, grid_.ny());
    const Extent z = extent(x, &Vec3::z, origin.z, h.z, grid_.nz());
    if (!y.inside || !z.inside) return false;
    weigh(x, &Vec3::y, origin.y, h.y, y_);
    weigh(x, &Vec3::z, origin.z, h.z, z_);
    const auto first = [&](Real s) { return delta_weights(kernels_.across, s - 0.5).first; };
    const auto last = [&](Real s) { return delta_weights(kernels_.along, s).first; };
    reached_.begin = {reached_.begin[0], first(y.low), first(z.low)};
    reached_.end = {reached_.end[0], last(y.high) + 4, last(z.high) + 4};
    return true;
}

Box Transfer::support(Location c, Index margin) const
{
    const Box all = grid_.unknowns(c);
    Box b = reached_;
    for (std::size_t d = 0; d < 3; ++d) {
        b.begin[d] = std::max(b.begin[d] - margin, all.begin[d]);
        b.end[d] = std::min(b.end[d] + margin, all.end[d]);
    }
    return b;
}

void Transfer::spread(Location c, const Array<Vec3>& f, ScalarField& F)
{
    const View<Real> out = F.view(), blunt = scratch_.view();
    const Box all = grid_.unknowns(c);
    if (kernels_.sharpening == 0) return gather(c, f, all, out);
    const Box b = support(c, 1);
    // one node more than the box: what is sharpened reads its neighbours
    const Box around = {{b.begin[0] - 1, b.begin[1] - 1, b.begin[2] - 1},
                        {b.end[0] + 1, b.end[1] + 1, b.end[2] + 1}};
    gather(c, f, around, blunt);
    mirror_at_ends(grid_, c, around, blunt);
    const Real a = kernels_.sharpening;
    for_planes(all.begin[0], all.end[0], [=](Index i) {
        clear_plane(all, i, out);
        if (i >= b.begin[0] && i < b.end[0]) sharpen_plane(a, b, i, blunt, out);
    });
}

// Each thread has some planes and visits the rings in their reach once: vertex after vertex it adds
// to all of its planes, so that sums do not wait for what was just stored.
void Transfer::gather(Location c, const Array<Vec3>& f, const Box& b, View<Real> F) const
{
    const Index blocks = max_threads(), planes = b.end[0] - b.begin[0];
    for_planes(0, blocks, [=, this, &f, &b](Index block) {
        const Index first = b.begin[0] + planes * block / blocks;
        const Index last = b.begin[0] + planes * (block + 1) / blocks;
        for (Index i = first; i < last; ++i) clear_plane(b, i, F);
        for (Index ring = acting_.begin; ring < acting_.end; ++ring) {
            const Index x_first = stencil_x(c, ring).first;
            const Index begin = std::max<Index>({first, 0, x_first});
            const Index end = std::min({last, grid_.nx() + 1, x_first + 4});
            if (begin < end) add_ring(c, ring, f, begin, end, F);
        }
    });
}

void Transfer::add_ring(Location c, Index ring, const Array<Vec3>& f, Index begin, Index end,
                        View<Real> F) const
{
    const Real inv_volume = 1 / grid_.cell_volume();
    const Stencil4& x = stencil_x(c, ring);
    std::array<Real, 4> weight_x;
    for (std::size_t l = 0; l < 4; ++l) weight_x[l] = inv_volume * x.weight[l];
    const auto component = component_of_vector(c);
    with_widths(kernels_, c, [&](auto ny, auto) {
        for (VertexIndex v = tube_->first(ring); v < tube_->first(ring + 1); ++v) {
            const Stencil4 y = stencils_y(c)[v], z = stencils_z(c)[v];
            const Real force = f[v].*component;
            for (Index i = begin; i < end; ++i) {
                const Real plane_force = weight_x[static_cast<std::size_t>(i - x.first)] * force;
                Real* row = &F(i, y.first, z.first);
                for (std::size_t m = 0; m < ny; ++m, row += F.stride_y) {
                    const Real row_force = plane_force * y.weight[m];
                    for (std::size_t n = 0; n < 4; ++n) row[n] += row_force * z.weight[n];
                }
            }
        }
    });
}

void Transfer::interpolate(Location c, const ScalarField& u_field, Array<Vec3>& velocity)
{
    View<const Real> u = u_field.view();
    if (kernels_.sharpening != 0) {
        const View<Real> sharp = scratch_.view();
        const Box b = support(c, 0);
        const Real a = kernels_.sharpening;
        for_planes(b.begin[0], b.end[0], [=](Index i) { sharpen_plane(a, b, i, u, sharp); });
        u = sharp;
    }
    const auto component = component_of_vector(c);
    Vec3* out = velocity.data();
    const std::size_t nx = node_count(c == Location::u ? kernels_.along : kernels_.across);
    with_widths(kernels_, c, [&](auto ny, auto nz) {
        for_range(tube_->first(acting_.begin), tube_->first(acting_.end), [=, this](Index v) {
            const Stencil4& x = stencil_x(c, v / tube_->ring_size);
            const Stencil4 &y = stencils_y(c)[v], &z = stencils_z(c)[v];
            Real sum = 0;
            for (std::size_t l = 0; l < nx; ++l) {
                Real plane = 0;
                const Real* row = &u(x.first + static_cast<Index>(l), y.first, z.first);
                for (std::size_t m = 0; m < ny; ++m, row += u.stride_y) {
                    Real line = 0;
                    for (std::size_t n = 0; n < nz; ++n) line += z.weight[n] * row[n];
                    plane += y.weight[m] * line;
                }
                sum += x.weight[l] * plane;
            }
            out[v].*component = sum;
        });
    });
}

} // namespace starling
