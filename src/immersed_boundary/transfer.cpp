#include "immersed_boundary/transfer.hpp"

#include "core/pack.hpp"

namespace starling {

namespace {

/// Calls f with the number of rows along y that can have weight for component c, and with whether
/// weights are sharpened, both as types.
template <class F>
void with_shape(const KernelPair& kernels, Location c, F f)
{
    using Three = std::integral_constant<std::size_t, 3>;
    using Four = std::integral_constant<std::size_t, 4>;
    const bool three = node_count(c == Location::v ? kernels.along : kernels.across) == 3;
    const auto call = [&](auto rows) {
        if (kernels.sharpening == 0)
            f(rows, std::false_type{});
        else
            f(rows, std::true_type{});
    };
    if (three)
        call(Three{});
    else
        call(Four{});
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

/// The factors of a vertex's weights along one direction, node by node: D, with one node without
/// weight on both sides, and T = -a delta^2 D, which is what sharpening adds.
struct Factors {
    Pack8 D{}, T{};

    Factors(const Stencil4& s, Real a)
    {
        const Pack4 none{}, w = load4(s.weight.data());
        D = __builtin_shufflevector(none, w, 0, 4, 5, 6, 7, 0, 0, 0);
        const Pack8 before = __builtin_shufflevector(none, w, 0, 0, 4, 5, 6, 7, 0, 0);
        const Pack8 after = __builtin_shufflevector(none, w, 4, 5, 6, 7, 0, 0, 0, 0);
        T = a * (2 * D - before - after);
    }
};

/// Calls f(m, p, q) for rows m = 0, ... of a plane, the first of them one before that of the
/// stencil: the weights of its nodes are p D_z + q T_z. `ny` rows have weight before sharpening.
template <std::size_t ny, bool sharp, class F>
void for_rows(Real D_x, Real sharp_x, const Factors& y, F f)
{
    constexpr int inner_end = static_cast<int>(ny) + 1;
    if (!sharp || D_x == 0) {
        for (int m = 1; m < inner_end; ++m) f(m, sharp_x * y.D[m], Real{0});
        return;
    }
    for (int m = 0; m <= inner_end; ++m) f(m, sharp_x * y.D[m] + D_x * y.T[m], D_x * y.D[m]);
}

/// Asks for the rows of some planes that a stencil would reach.
template <class T>
void prefetch_rows(View<T> f, Index begin, Index end, const Stencil4& y, const Stencil4& z)
{
    for (Index i = begin; i < end; ++i)
        for (Index m = -1; m <= 4; ++m) prefetch_stencil(&f(i, y.first + m, z.first - 1), 6);
}

} // namespace

Transfer::Transfer(const Grid& g, const Tube& tube, KernelPair kernels, RingRange acting)
    : grid_(g), tube_(&tube), kernels_(kernels),
      acting_(acting), y_{Array<Stencil4>(static_cast<Index>(tube.X.size())),
                          Array<Stencil4>(static_cast<Index>(tube.X.size()))},
      z_(y_)
{
    const Real h = g.spacing().x;
    for (Real x : tube.ring_x) {
        const Stencil4 cells =
            fold_at_ends(delta_weights(kernels.across, (x - g.x(Location::cell, 0)) / h),
                         g.nx() - 1, node_count(kernels.across), true);
        const Stencil4 faces =
            fold_at_ends(delta_weights(kernels.along, (x - g.x(Location::u, 0)) / h), g.nx(),
                         node_count(kernels.along), false);
        at_cells_.push_back(plane_weights(cells, g.nx() - 1, 0));
        at_faces_.push_back(plane_weights(faces, g.nx(), 1));
    }
}

// `image`: the plane whose values the halo of the first plane holds.
Transfer::PlaneWeights Transfer::plane_weights(const Stencil4& s, Index last, Index image) const
{
    const Factors x(s, kernels_.sharpening);
    PlaneWeights w{s.first - 1, {}, {}, {}};
    for (int l = 0; l < planes; ++l) {
        const auto n = static_cast<std::size_t>(l);
        w.blunt[n] = x.D[l];
        w.interpolate[n] = w.spread[n] = x.D[l] + x.T[l];
        // what is spread is sharpened with mirror images in the halos
        const Index plane = w.first + l;
        if (plane == 0) w.spread[n] -= kernels_.sharpening * s.at(image);
        if (plane == last) w.spread[n] -= kernels_.sharpening * s.at(last - image);
    }
    return w;
}

const Transfer::PlaneWeights& Transfer::weights_x(Location c, Index ring) const
{
    return (c == Location::u ? at_faces_ : at_cells_)[static_cast<std::size_t>(ring)];
}

Index Transfer::end_of_next_ring(Location c, Index ring) const
{
    return weights_x(c, std::min(ring + 1, acting_.end - 1)).first + planes;
}

bool Transfer::fits(const Array<Vec3>& x, Real Vec3::*coordinate, Real origin, Real h,
                    Index cells) const
{
    const Vec3* position = x.data();
    const Real inverse = 1 / h, top = static_cast<Real>(cells - 2);
    Index bad = 0;
#pragma omp parallel for schedule(static) reduction(+ : bad)
    for (Index v = tube_->first(acting_.begin); v < tube_->first(acting_.end); ++v) {
        const Real s = (position[v].*coordinate - origin) * inverse;
        bad += !(s > 2 && s < top);
    }
    return bad == 0;
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
    const Vec3 h = grid_.spacing(), origin = grid_.origin();
    if (!fits(x, &Vec3::y, origin.y, h.y, grid_.ny())) return false;
    if (!fits(x, &Vec3::z, origin.z, h.z, grid_.nz())) return false;
    weigh(x, &Vec3::y, origin.y, h.y, y_);
    weigh(x, &Vec3::z, origin.z, h.z, z_);
    return true;
}

// Each thread has some planes and visits the rings in their reach once: vertex after vertex it adds
// to all of its planes, so that sums do not wait for what was just stored.
void Transfer::spread(Location c, const Array<Vec3>& f, ScalarField& F_field) const
{
    const View<Real> F = F_field.view();
    const Index blocks = max_threads(), unknown_planes = grid_.unknowns(c).end[0];
    for_planes(0, blocks, [=, this, &f](Index block) {
        const Index first = unknown_planes * block / blocks;
        const Index last = unknown_planes * (block + 1) / blocks;
        for (Index ring = acting_.begin; ring < acting_.end; ++ring) {
            const Index reached = weights_x(c, ring).first;
            const Index begin = std::max(first, reached), end = std::min(last, reached + planes);
            if (begin < end) add_ring(c, ring, f, begin, end, F);
        }
    });
}

void Transfer::add_ring(Location c, Index ring, const Array<Vec3>& f, Index begin, Index end,
                        View<Real> F) const
{
    const Real inv_volume = 1 / grid_.cell_volume(), a = kernels_.sharpening;
    const PlaneWeights& x = weights_x(c, ring);
    const auto component = component_of_vector(c);
    const Index next_end = end == x.first + planes ? end_of_next_ring(c, ring) : end;
    with_shape(kernels_, c, [&](auto ny, auto sharp) {
        for (VertexIndex v = tube_->first(ring); v < tube_->first(ring + 1); ++v) {
            const Stencil4 &s_y = stencils_y(c)[v], &s_z = stencils_z(c)[v];
            prefetch_rows(F, end, next_end, s_y, s_z);
            const Factors y(s_y, a), z(s_z, a);
            const Real force = inv_volume * (f[v].*component);
            const Pack8 D_z = force * z.D, T_z = force * z.T;
            for (Index i = begin; i < end; ++i) {
                const auto l = static_cast<std::size_t>(i - x.first);
                if (x.spread[l] == 0) continue;
                Real* first = &F(i, s_y.first - 1, s_z.first - 1);
                for_rows<ny, sharp>(x.blunt[l], x.spread[l], y, [&](int m, Real p, Real q) {
                    Real* row = first + m * F.stride_y;
                    store8(load8(row) + (p * D_z + q * T_z), row);
                });
            }
        }
    });
}

void Transfer::interpolate(Location c, const ScalarField& u_field, Array<Vec3>& velocity) const
{
    const View<const Real> u = u_field.view();
    const Real a = kernels_.sharpening;
    const auto component = component_of_vector(c);
    Vec3* out = velocity.data();
    with_shape(kernels_, c, [&](auto ny, auto sharp) {
        for_range(tube_->first(acting_.begin), tube_->first(acting_.end), [=, this](Index v) {
            const Index ring = v / tube_->ring_size;
            const PlaneWeights& x = weights_x(c, ring);
            const Stencil4 &s_y = stencils_y(c)[v], &s_z = stencils_z(c)[v];
            prefetch_rows(u, x.first + planes, end_of_next_ring(c, ring), s_y, s_z);
            const Factors y(s_y, a), z(s_z, a);
            Pack8 with_D{}, with_T{};
            for (std::size_t l = 0; l < planes; ++l) {
                if (x.interpolate[l] == 0) continue;
                const Real* first =
                    &u(x.first + static_cast<Index>(l), s_y.first - 1, s_z.first - 1);
                for_rows<ny, sharp>(x.blunt[l], x.interpolate[l], y, [&](int m, Real p, Real q) {
                    const Pack8 row = load8(first + m * u.stride_y);
                    with_D += p * row;
                    with_T += q * row;
                });
            }
            const Pack8 terms = with_D * z.D + with_T * z.T;
            Real sum = 0;
            for (int n = 0; n < 6; ++n) sum += terms[n];
            out[v].*component = sum;
        });
    });
}

} // namespace starling
