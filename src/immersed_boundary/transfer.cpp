#include "immersed_boundary/transfer.hpp"

#include <limits>

namespace starling {

namespace {

constexpr std::int32_t max_index = std::numeric_limits<std::int32_t>::max();

bool reaches(const Stencil4& s, Index plane)
{
    const Index m = plane - s.first;
    return m >= 0 && m < 4 && s.weight[static_cast<std::size_t>(m)] != 0;
}

} // namespace

Transfer::Transfer(const Grid& g, const Tube& tube, KernelPair kernels, RingRange spreading)
    : grid_(g), tube_(&tube), kernels_(kernels), spreading_(spreading),
      stencils_(static_cast<Index>(tube.X.size())), scratch_(g)
{
    const Real h = g.spacing().x;
    for (Real x : tube.ring_x)
        ring_stencils_.push_back({delta_weights(kernels.across, (x - g.x(Location::cell, 0)) / h),
                                  delta_weights(kernels.along, (x - g.x(Location::u, 0)) / h)});
    for (Location c : {Location::cell, Location::u}) {
        auto& reach = reach_[c == Location::u];
        reach.resize(static_cast<std::size_t>(g.nx() + 1));
        for (Index i = 0; i <= g.nx(); ++i) {
            auto& range = reach[static_cast<std::size_t>(i)];
            for (Index r = spreading.begin; r < spreading.end; ++r)
                if (reaches(stencil_x(c, r), i)) {
                    if (range.end == 0) range.begin = r;
                    range.end = r + 1;
                }
        }
    }
    reached_.begin[0] = reached_.end[0] = 0;
    if (spreading.begin < spreading.end) {
        reached_.begin[0] = stencil_x(Location::cell, spreading.begin).first;
        reached_.end[0] = stencil_x(Location::u, spreading.end - 1).first + 4;
    }
}

const Stencil4& Transfer::stencil_x(Location c, Index ring) const
{
    const RingStencils& s = ring_stencils_[static_cast<std::size_t>(ring)];
    return c == Location::u ? s.x_face : s.x_cell;
}

bool Transfer::update(const Array<Vec3>& x)
{
    const Vec3 h = grid_.spacing(), origin = grid_.origin();
    const Real inv_y = 1 / h.y, inv_z = 1 / h.z;
    const Real top_y = static_cast<Real>(grid_.ny() - 2), top_z = static_cast<Real>(grid_.nz() - 2);
    VertexStencils* stencils = stencils_.data();
    const Vec3* position = x.data();
    const KernelPair kernels = kernels_;
    Index bad = 0;
    std::int32_t y_low = max_index, y_high = 0, z_low = max_index, z_high = 0;
#pragma omp parallel for schedule(static) reduction(+ : bad) reduction(min : y_low, z_low) \
    reduction(max : y_high, z_high)
    for (Index v = tube_->first(spreading_.begin); v < tube_->first(spreading_.end); ++v) {
        const Real s_y = (position[v].y - origin.y) * inv_y,
                   s_z = (position[v].z - origin.z) * inv_z;
        if (!(s_y > 2 && s_y < top_y && s_z > 2 && s_z < top_z)) {
            ++bad;
            continue;
        }
        VertexStencils& s = stencils[v];
        s = {delta_weights(kernels.across, s_y - 0.5), delta_weights(kernels.along, s_y),
             delta_weights(kernels.across, s_z - 0.5), delta_weights(kernels.along, s_z)};
        y_low = std::min(y_low, s.y_cell.first);
        y_high = std::max(y_high, s.y_face.first);
        z_low = std::min(z_low, s.z_cell.first);
        z_high = std::max(z_high, s.z_face.first);
    }
    reached_.begin = {reached_.begin[0], y_low, z_low};
    reached_.end = {reached_.end[0], y_high + 4, z_high + 4};
    return bad == 0;
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
    const View<Real> out = F.view();
    for_each(grid_.unknowns(c), [=](Index i, Index j, Index k) { out(i, j, k) = 0; });
    if (kernels_.sharpening == 0) return gather(c, f, out);
    const View<Real> blunt = scratch_.view();
    const Box b = support(c, 1);
    // one node more than the box: what is sharpened reads its neighbours
    for_each({{b.begin[0] - 1, b.begin[1] - 1, b.begin[2] - 1},
              {b.end[0] + 1, b.end[1] + 1, b.end[2] + 1}},
             [=](Index i, Index j, Index k) { blunt(i, j, k) = 0; });
    gather(c, f, blunt);
    sharpen(b, blunt, out);
}

void Transfer::sharpen(const Box& b, View<const Real> from, View<Real> to) const
{
    const Real a = kernels_.sharpening, centre = 1 + 6 * a;
    for_each(b, [=](Index i, Index j, Index k) {
        to(i, j, k) = centre * from(i, j, k) -
                      a * (from(i - 1, j, k) + from(i + 1, j, k) + from(i, j - 1, k) +
                           from(i, j + 1, k) + from(i, j, k - 1) + from(i, j, k + 1));
    });
}

void Transfer::gather(Location c, const Array<Vec3>& f, View<Real> F) const
{
    const Real inv_volume = 1 / grid_.cell_volume();
    const auto& reach = reach_[c == Location::u];
    const auto component = [c](const Vec3& a) {
        return c == Location::u ? a.x : c == Location::v ? a.y : a.z;
    };
    for_range(0, static_cast<Index>(reach.size()), [&, F](Index i) {
        const RingRange range = reach[static_cast<std::size_t>(i)];
        for (Index ring = range.begin; ring < range.end; ++ring) {
            const Stencil4& sx = stencil_x(c, ring);
            const Real weight_x = inv_volume * sx.weight[static_cast<std::size_t>(i - sx.first)];
            for (Index v = tube_->first(ring); v < tube_->first(ring + 1); ++v) {
                const Stencil4 &sy = stencil_y(c, stencils_[v]), &sz = stencil_z(c, stencils_[v]);
                const Real force = weight_x * component(f[v]);
                for (std::size_t m = 0; m < 4; ++m) {
                    Real* row = &F(i, sy.first + static_cast<Index>(m), sz.first);
                    const Real a = force * sy.weight[m];
                    for (std::size_t n = 0; n < 4; ++n) row[n] += a * sz.weight[n];
                }
            }
        }
    });
}

void Transfer::interpolate(Location c, const ScalarField& u_field, Array<Vec3>& velocity)
{
    if (kernels_.sharpening != 0) sharpen(support(c, 0), u_field.view(), scratch_.view());
    const View<const Real> u = kernels_.sharpening != 0 ? scratch_.view() : u_field.view();
    Vec3* out = velocity.data();
    for_range(tube_->moving_begin(), tube_->moving_end(), [&, u, out](Index v) {
        const Stencil4& sx = stencil_x(c, v / tube_->ring_size);
        const Stencil4 &sy = stencil_y(c, stencils_[v]), &sz = stencil_z(c, stencils_[v]);
        Real sum = 0;
        for (std::size_t l = 0; l < 4; ++l) {
            if (sx.weight[l] == 0) continue;
            Real plane = 0;
            for (std::size_t m = 0; m < 4; ++m) {
                const Real* row = &u(sx.first + static_cast<Index>(l),
                                     sy.first + static_cast<Index>(m), sz.first);
                Real line = 0;
                for (std::size_t n = 0; n < 4; ++n) line += sz.weight[n] * row[n];
                plane += sy.weight[m] * line;
            }
            sum += sx.weight[l] * plane;
        }
        (c == Location::u ? out[v].x : c == Location::v ? out[v].y : out[v].z) = sum;
    });
}

} // namespace starling
