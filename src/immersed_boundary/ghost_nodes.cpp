#include "immersed_boundary/ghost_nodes.hpp"

#include <bit>
#include <cstring>
#include <numeric>

#include "core/pack.hpp"
#include "immersed_boundary/bracket.hpp"
#include "wall/cross_section.hpp"

namespace starling {

namespace {

bool in_memory_order(const NearNode& a, const NearNode& b)
{
    if (a.i != b.i) return a.i < b.i;
    return a.j != b.j ? a.j < b.j : a.k < b.k;
}

bool same_node(const NearNode& a, const NearNode& b)
{
    return a.i == b.i && a.j == b.j && a.k == b.k;
}

/// First and last of the nodes beside those between which a fraction s is taken; a node without
/// weight does not count, or symmetry would hang on round-off.
std::pair<Index, Index> neighbours_of_cell(Index cell, Real s)
{
    return {s > 1 - 1e-9 ? cell : cell - 1, s < 1e-9 ? cell + 1 : cell + 2};
}

/// The next node that is marked; there must be one.
const std::uint8_t* next_marked(const std::uint8_t* mask)
{
    std::uint64_t eight = 0;
    for (;; mask += sizeof(eight)) {
        std::memcpy(&eight, mask, sizeof(eight));
        if (eight != 0) break;
    }
    while (!*mask) ++mask;
    return mask;
}

/// Four flags in a row, turned over, as one number.
std::uint32_t outside_of_four(const std::uint8_t* inside)
{
    std::uint32_t flags = 0;
    std::memcpy(&flags, inside, sizeof(flags));
    return flags ^ 0x01010101;
}

/// Those of four flags that stand from `first` to `last`.
std::uint32_t between(Index first, Index last)
{
    std::array<std::uint8_t, 4> chosen{};
    for (Index n = first; n <= last; ++n) chosen[static_cast<std::size_t>(n)] = 1;
    return std::bit_cast<std::uint32_t>(chosen);
}

/// Weights of four nodes in a row with which the cell between the inner two interpolates, at a
/// fraction of its width, values, central differences over two spacings, and second differences.
struct InCell {
    Pack4 value, slope, bend;

    explicit InCell(Real s)
        : value{0, 1 - s, s, 0}, slope{s - 1, -s, 1 - s, s}, bend{1 - s, 3 * s - 2, 1 - 3 * s, s}
    {
    }
};

/// Sum of the weights times the second differences xx, yy, zz, yz, zx, xy of u, interpolated in the
/// cell from the node q on: row by row along z, whose three sums wait for the end.
Real second_differences(View<const Real> u, const Real* q, const std::array<Real, 3>& fraction,
                        const std::array<Real, 6>& weight)
{
    const InCell x(fraction[0]), y(fraction[1]), z(fraction[2]);
    Pack4 values{}, slopes{}, bends{};
    for (int l = 0; l < 4; ++l) {
        const Pack4 of_value = weight[0] * x.bend[l] * y.value + weight[1] * x.value[l] * y.bend +
                               weight[5] / 4 * x.slope[l] * y.slope;
        const Pack4 of_slope =
            weight[3] / 4 * x.value[l] * y.slope + weight[4] / 4 * x.slope[l] * y.value;
        const Pack4 of_bend = weight[2] * x.value[l] * y.value;
        for (int m = 0; m < 4; ++m) {
            const Real* nodes = q + (l - 1) * u.stride_x + (m - 1) * u.stride_y - 1;
            if (l == 3) prefetch_stencil(nodes + u.stride_x, 4);
            const Pack4 row = load4(nodes);
            values += of_value[m] * row;
            slopes += of_slope[m] * row;
            bends += of_bend[m] * row;
        }
    }
    const Pack4 terms = values * z.value + slopes * z.slope + bends * z.bend;
    return (terms[0] + terms[1]) + (terms[2] + terms[3]);
}

} // namespace

GhostNodes::GhostNodes(const Grid& g, const Tube& tube, Location component,
                       std::vector<char> active_planes)
    : grid_(g), tube_(&tube), component_(component), active_planes_(std::move(active_planes)),
      nodes_(g.unknowns(component)), mask_(g), near_begin_(static_cast<std::size_t>(g.nx() + 2), 0),
      ghost_begin_(static_cast<std::size_t>(g.nx() + 2), 0),
      plane_begin_(static_cast<std::size_t>(g.nx() + 2), 0)
{
    if (std::ranges::find(active_planes_, 1) != active_planes_.end())
        index_ = Field<std::int32_t>(g);
}

bool GhostNodes::exists(std::int32_t i, std::int32_t j, std::int32_t k) const
{
    return i >= nodes_.begin[0] && i < nodes_.end[0] && j >= nodes_.begin[1] && j < nodes_.end[1] &&
           k >= nodes_.begin[2] && k < nodes_.end[2] && active_planes_[static_cast<std::size_t>(i)];
}

template <class F>
void GhostNodes::for_neighbours(const NearNode& n, F f) const
{
    constexpr std::array<std::array<int, 3>, 6> steps = {
        {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};
    for (const auto& [di, dj, dk] : steps)
        if (exists(n.i + di, n.j + dj, n.k + dk)) f(n.i + di, n.j + dj, n.k + dk);
}

bool GhostNodes::touches_other_side(const Field<std::uint8_t>& inside, const NearNode& n) const
{
    const auto flags = inside.view();
    const std::uint8_t own = flags(n.i, n.j, n.k);
    bool touches = false;
    for_neighbours(n, [&](Index i, Index j, Index k) { touches |= flags(i, j, k) != own; });
    return touches;
}

void GhostNodes::classify_planes(const Array<Vec3>& x, Field<std::uint8_t>& inside)
{
    inside.fill(0);
    const auto flags = inside.view();
    CrossSection section(*tube_);
    for (Index i = nodes_.begin[0]; i < nodes_.end[0]; ++i) {
        if (!active_planes_[static_cast<std::size_t>(i)]) continue;
        section.cut(x, grid_.x(component_, i));
        for (Index j = nodes_.begin[1]; j < nodes_.end[1]; ++j) {
            const auto& z = section.crossings(grid_.y(component_, j));
            for (Index k = nodes_.begin[2]; k < nodes_.end[2]; ++k) {
                const Real z_k = grid_.z(component_, k);
                const auto below = std::upper_bound(z.begin(), z.end(), z_k) - z.begin();
                flags(i, j, k) = below % 2 != 0;
            }
        }
    }
}

void GhostNodes::initialise(const Array<Vec3>& x, const InterceptSearch& search, GhostState& s)
{
    classify_planes(x, s.inside);
    s.near_wall.clear();
    CrossSection section(*tube_);
    for (Index i = nodes_.begin[0]; i < nodes_.end[0]; ++i) {
        if (!active_planes_[static_cast<std::size_t>(i)]) continue;
        section.cut(x, grid_.x(component_, i));
        const auto& points = section.points();
        for (Index j = nodes_.begin[1]; j < nodes_.end[1]; ++j)
            for (Index k = nodes_.begin[2]; k < nodes_.end[2]; ++k) {
                NearNode n{static_cast<std::int32_t>(i),
                           static_cast<std::int32_t>(j),
                           static_cast<std::int32_t>(k),
                           false,
                           {}};
                if (!touches_other_side(s.inside, n)) continue;
                const Vec3 p = position(n);
                const auto distance = [&](const Point2& q) {
                    return (q.y - p.y) * (q.y - p.y) + (q.z - p.z) * (q.z - p.z);
                };
                const auto nearest = std::min_element(
                    points.begin(), points.end(),
                    [&](const Point2& a, const Point2& b) { return distance(a) < distance(b); });
                n.intercept.element =
                    section.first_element() + static_cast<ElementIndex>(nearest - points.begin());
                s.near_wall.push_back(n);
            }
    }
    // room for a wall that inflates or folds, so that steps do not allocate
    const std::size_t room = 4 * s.near_wall.size() + 1024;
    s.near_wall.reserve(room);
    candidates_.reserve(room);
    turned_.reserve(room);
    offsets_.reserve(room);
    source_.reserve(room);
    stencils_.reserve(room);
    flags_.reserve(room);
    found_.reserve(room);
    values_.reserve(room);
    beside_rigid_wall_.assign(active_planes_.size(), 0); // search everywhere once
    this->search(search, s);
    prescribe(s);
    const Real reach = 3 * std::max({grid_.spacing().x, grid_.spacing().y, grid_.spacing().z});
    for (Index i = nodes_.begin[0]; i < nodes_.end[0]; ++i)
        beside_rigid_wall_[static_cast<std::size_t>(i)] =
            grid_.x(component_, i) < tube_->x_clamp_in() - reach ||
            grid_.x(component_, i) > tube_->x_clamp_out() + reach;
}

/// Lists in found_ the nodes for which f holds, in their order.
template <class F>
void GhostNodes::find(GhostState& s, F f)
{
    flags_.resize(s.near_wall.size());
    char* flags = flags_.data();
    NearNode* nodes = s.near_wall.data();
    const auto count = static_cast<Index>(s.near_wall.size());
    for_range(0, count, [=](Index n) { flags[n] = f(nodes[n]); });
    found_.clear();
    for (Index n = 0; n < count; ++n)
        if (flags[n]) found_.push_back(nodes + n);
}

void GhostNodes::search_missing(const InterceptSearch& search, GhostState& s)
{
    NearNode* nodes = s.near_wall.data();
    const auto index = index_.view();
    for_range(0, static_cast<Index>(s.near_wall.size()), [=, this, &search](Index n) {
        NearNode& node = nodes[n];
        index(node.i, node.j, node.k) = static_cast<std::int32_t>(n);
        if (!node.searched) node.intercept = search.walk(position(node), node.intercept.element);
    });
    find(s, [this, &s](NearNode& node) {
        const bool suspect =
            !node.searched && node.intercept.outside && follows_another_wall(s, node);
        node.searched = true;
        return suspect;
    });
    for (NearNode* suspect : found_) search_from_each_other(search, s, *suspect);
}

template <class Ghosts, class F>
void GhostNodes::for_neighbours_across(Ghosts& s, const NearNode& n, F f) const
{
    const auto inside = s.inside.view();
    const auto index = index_.view();
    const std::uint8_t own = inside(n.i, n.j, n.k);
    for_neighbours(n, [&](Index i, Index j, Index k) {
        if (inside(i, j, k) != own) f(s.near_wall[static_cast<std::size_t>(index(i, j, k))]);
    });
}

// A signed distance changes by at most the way gone: the distances of two neighbours on opposite
// sides add up to at most their own. If not, one of them follows a wall that is not between them:
// where a fold or a narrow channel moves sideways, an old intercept stays one while another part
// of the wall comes nearer.
bool GhostNodes::follows_another_wall(const GhostState& s, const NearNode& n) const
{
    constexpr Real tolerance = 1.01; // of the nearest points of neighbouring facets
    const Real distance = std::sqrt(n.intercept.squared_distance);
    const Vec3 h = grid_.spacing();
    bool suspicious = false;
    for_neighbours_across(s, n, [&](const NearNode& m) {
        const Real apart = m.i != n.i ? h.x : m.j != n.j ? h.y : h.z;
        const Real rest = tolerance * apart - distance;
        suspicious |= rest < 0 || m.intercept.squared_distance > rest * rest;
    });
    return suspicious;
}

void GhostNodes::search_from_each_other(const InterceptSearch& search, GhostState& s, NearNode& n)
{
    const auto improve = [&](NearNode& node, ElementIndex start) {
        const Intercept other = search.walk(position(node), start);
        if (other.squared_distance < node.intercept.squared_distance) node.intercept = other;
    };
    for_neighbours_across(s, n, [&](NearNode& m) {
        const ElementIndex from_n = n.intercept.element;
        improve(n, m.intercept.element);
        improve(m, from_n);
    });
}

// A node turns over only where the wall has passed it by a twentieth of a spacing. The flow with
// the node inside differs a little from that with the node outside: without indifference a wall
// that comes to rest on a node goes to and fro for ever.
void GhostNodes::turn_over(GhostState& s)
{
    constexpr Real indifference = 0.05;
    const Real band = indifference * grid_.spacing().x;
    const auto inside = s.inside.view();
    find(s, [=](const NearNode& node) {
        const bool now_inside = !node.intercept.outside;
        return (inside(node.i, node.j, node.k) != 0) != now_inside &&
               node.intercept.squared_distance >= band * band;
    });
    turned_.clear();
    for (const NearNode* node : found_) {
        inside(node->i, node->j, node->k) = node->intercept.outside ? 0 : 1;
        turned_.push_back(*node);
    }
}

/// Adds the candidates to the nodes, both in memory order, after nodes that are the same. Returns a
/// place before which nothing has changed.
std::size_t GhostNodes::merge_candidates(std::vector<NearNode>& nodes)
{
    std::size_t node = nodes.size(), candidate = candidates_.size();
    nodes.resize(node + candidate);
    while (candidate > 0) {
        const std::size_t to = node + candidate - 1;
        if (node > 0 && in_memory_order(candidates_[candidate - 1], nodes[node - 1]))
            nodes[to] = nodes[--node];
        else
            nodes[to] = candidates_[--candidate];
    }
    return node > 0 ? node - 1 : 0; // may be the same as the first candidate
}

// Nodes next to a turned node may now touch the other side; their search starts where the turned
// node's ended. Those already near the wall keep their own element but search again.
void GhostNodes::rebuild(GhostState& s)
{
    candidates_.clear();
    for (const NearNode& n : turned_) {
        candidates_.push_back(n);
        for_neighbours(n, [&](std::int32_t i, std::int32_t j, std::int32_t k) {
            candidates_.push_back({i, j, k, false, n.intercept});
        });
    }
    std::sort(candidates_.begin(), candidates_.end(), [](const NearNode& a, const NearNode& b) {
        return same_node(a, b) ? a.intercept.element < b.intercept.element : in_memory_order(a, b);
    });
    auto& nodes = s.near_wall;
    std::size_t n = merge_candidates(nodes), kept = n;
    while (n < nodes.size()) {
        NearNode node = nodes[n];
        for (++n; n < nodes.size() && same_node(nodes[n], node); ++n) node.searched = false;
        if (node.searched || touches_other_side(s.inside, node)) nodes[kept++] = node;
    }
    nodes.resize(kept);
}

bool GhostNodes::search(const InterceptSearch& search, GhostState& s)
{
    constexpr int most_sweeps = 8;
    if (s.near_wall.empty()) return true;
    NearNode* nodes = s.near_wall.data();
    const char* rests = beside_rigid_wall_.data();
    for_range(0, static_cast<Index>(s.near_wall.size()),
              [=](Index n) { nodes[n].searched = rests[nodes[n].i]; });
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        search_missing(search, s);
        turn_over(s);
        if (turned_.empty()) return true;
        rebuild(s);
    }
    return false;
}

// Ghosts and nodes at rest, plane by plane in memory order.
void GhostNodes::prescribe(const GhostState& s)
{
    const auto mask = mask_.view();
    const Index* before = offsets_.data();
    for_range(0, static_cast<Index>(offsets_.size()), [=](Index n) { mask.data[before[n]] = 0; });
    const auto planes = static_cast<Index>(active_planes_.size());
    for (Index i = 0; i <= planes; ++i)
        near_begin_[static_cast<std::size_t>(i)] =
            std::partition_point(s.near_wall.begin(), s.near_wall.end(),
                                 [i](const NearNode& n) { return n.i < i; }) -
            s.near_wall.begin();
    for_planes(0, planes, [this, &s](Index i) { mark_plane(s, static_cast<std::size_t>(i)); });
    std::partial_sum(ghost_begin_.begin(), ghost_begin_.end(), ghost_begin_.begin());
    std::partial_sum(plane_begin_.begin(), plane_begin_.end(), plane_begin_.begin());
    stencils_.resize(static_cast<std::size_t>(ghost_begin_.back()));
    const auto nodes = static_cast<std::size_t>(plane_begin_.back());
    offsets_.resize(nodes);
    source_.resize(nodes);
    values_.resize(nodes);
    for_planes(0, planes, [this, &s](Index i) { list_plane(s, static_cast<std::size_t>(i)); });
}

template <class F>
void GhostNodes::for_ghosts(const GhostState& s, std::size_t plane, F f) const
{
    for (Index n = near_begin_[plane]; n < near_begin_[plane + 1]; ++n) {
        const NearNode& node = s.near_wall[static_cast<std::size_t>(n)];
        if (!s.inside(node.i, node.j, node.k)) f(node);
    }
}

/// Marks the ghosts and the nodes at rest of a plane and counts them.
void GhostNodes::mark_plane(const GhostState& s, std::size_t plane)
{
    const auto mask = mask_.view();
    const auto inside = s.inside.view();
    const auto own = static_cast<Index>(plane);
    Index ghosts = 0, nodes = 0;
    for_ghosts(s, plane, [&](const NearNode& n) {
        mask(n.i, n.j, n.k) = 1;
        ++ghosts;
    });
    const auto rest = [&](Index j, Index k) {
        if (inside(own, j, k) || mask(own, j, k)) return;
        mask(own, j, k) = 1;
        ++nodes;
    };
    for_ghosts(s, plane, [&](const NearNode& n) {
        if (n.j > nodes_.begin[1]) rest(n.j - 1, n.k);
        if (n.j + 1 < nodes_.end[1]) rest(n.j + 1, n.k);
        if (n.k > nodes_.begin[2]) rest(n.j, n.k - 1);
        if (n.k + 1 < nodes_.end[2]) rest(n.j, n.k + 1);
    });
    if (own < nodes_.end[0] && active_planes_[plane]) {
        const auto rest_beside = [&](const NearNode& n) { rest(n.j, n.k); };
        if (plane > 0) for_ghosts(s, plane - 1, rest_beside);
        if (plane + 1 < active_planes_.size()) for_ghosts(s, plane + 1, rest_beside);
    }
    ghost_begin_[plane + 1] = ghosts;
    plane_begin_[plane + 1] = ghosts + nodes;
}

/// Lists the marked nodes of a plane and makes the stencils of its ghosts.
void GhostNodes::list_plane(const GhostState& s, std::size_t plane)
{
    const auto mask = mask_.view();
    const auto begin = static_cast<std::size_t>(plane_begin_[plane]);
    const std::uint8_t* node = &mask(static_cast<Index>(plane), nodes_.begin[1], 0);
    for (std::size_t e = begin; e < static_cast<std::size_t>(plane_begin_[plane + 1]); ++e) {
        if (!*node) node = next_marked(node);
        offsets_[e] = node++ - mask.data;
        source_[e] = at_rest;
    }
    std::size_t entry = begin;
    Index ghost = ghost_begin_[plane];
    for_ghosts(s, plane, [&](const NearNode& n) {
        const Index offset = mask.offset(n.i, n.j, n.k);
        while (offsets_[entry] != offset) ++entry;
        source_[entry] = static_cast<std::int32_t>(ghost);
        stencils_[static_cast<std::size_t>(ghost++)] = make_stencil(s, n);
    });
}

GhostNodes::Stencil GhostNodes::make_stencil(const GhostState& state, const NearNode& n) const
{
    const Vec3 origin = grid_.position(component_, 0, 0, 0), h = grid_.spacing();
    const Vec3 image = 2 * n.intercept.point - position(n) - origin;
    const auto [i, a] = bracket(image.x / h.x, 0, nodes_.end[0] - 1);
    const auto [j, b] = bracket(image.y / h.y, 0, nodes_.end[1] - 1);
    const auto [k, c] = bracket(image.z / h.z, 0, nodes_.end[2] - 1);
    const auto view = mask_.view();
    const Index self = view.offset(n.i, n.j, n.k);
    Stencil s{view.offset(i, j, k), {}, {}, 0, {a, b, c}};
    Real own = 0;
    for (std::size_t l = 0; l < 8; ++l) {
        const Index di = l / 4, dj = l / 2 % 2, dk = l % 2;
        const Real beta = (di ? a : 1 - a) * (dj ? b : 1 - b) * (dk ? c : 1 - c);
        if (view.offset(i + di, j + dj, k + dk) == self)
            own = beta;
        else
            s.beta[l] = beta;
    }
    add_curvature(state, n, s);
    for (Real& beta : s.beta) beta *= -1 / (1 + own);
    for (Real& weight : s.curvature) weight /= 1 + own;
    return s;
}

// Deviation: the paper takes u_GN = -u_IP with trilinear interpolation, which lets too much flow
// through (by Delta^2, relative, in a tube of radius 1). With D from the intercept to the ghost
// node
//     u(BI + D) = -u(BI - D) + D . grad grad u . D
// holds for quadratic velocities that vanish at the intercept, and trilinear interpolation at
// fractions s of the spacing lies above u by the sum of s (1 - s)/2 delta_d^2 u. The second
// differences for both are those of the flow farther inside: ghost nodes that feed on each other's
// curvature are unstable where viscosity does not damp them. In a narrow channel there is no such
// place, and the paper's formula remains.
void GhostNodes::add_curvature(const GhostState& state, const NearNode& n, Stencil& s) const
{
    constexpr Real depth = 2.9; // spacings: the cell's neighbours are inside too
    const Vec3 origin = grid_.position(component_, 0, 0, 0), h = grid_.spacing();
    const Vec3 D = position(n) - n.intercept.point;
    const Real distance = norm(D);
    if (distance < 1e-9 * h.x) return;
    const Vec3 outward = outward_from_intercept(position(n), n.intercept);
    Vec3 p = n.intercept.point - (depth * h.x / distance) * outward - origin;
    p.x = std::clamp(p.x, h.x, static_cast<Real>(nodes_.end[0] - 2) * h.x); // not beyond the ends
    const auto [i, a] = bracket(p.x / h.x, 0, nodes_.end[0] - 2);
    const auto [j, b] = bracket(p.y / h.y, 0, nodes_.end[1] - 1);
    const auto [k, c] = bracket(p.z / h.z, 0, nodes_.end[2] - 1);
    const auto inside = state.inside.view();
    const auto [x_first, x_last] = neighbours_of_cell(i, a);
    const auto [y_first, y_last] = neighbours_of_cell(j, b);
    const auto [z_first, z_last] = neighbours_of_cell(k, c);
    std::uint32_t outside = 0;
    for (Index l = x_first; l <= x_last; ++l)
        for (Index m = y_first; m <= y_last; ++m) outside |= outside_of_four(&inside(l, m, k - 1));
    if (outside & between(z_first - (k - 1), z_last - (k - 1))) return;
    const std::array<Real, 3> step = {D.x / h.x, D.y / h.y, D.z / h.z};
    for (std::size_t d = 0; d < 3; ++d) {
        s.curvature[d] = step[d] * step[d] + s.fraction[d] * (1 - s.fraction[d]) / 2;
        s.curvature[d + 3] = 2 * step[(d + 1) % 3] * step[(d + 2) % 3];
    }
    s.place = mask_.view().offset(i, j, k);
    s.fraction = {a, b, c};
}

// Half of the old value: the curvature amplifies, with changing sign, what the flow made of the
// last values. The whole new value is unstable with long steps.
void GhostNodes::evaluate(const ScalarField& u_field)
{
    const View<const Real> u = u_field.view();
    for_range(0, static_cast<Index>(offsets_.size()), [this, u](Index n) {
        const std::int32_t ghost = source_[static_cast<std::size_t>(n)];
        Real& value = values_[static_cast<std::size_t>(n)];
        value = 0;
        if (ghost == at_rest) return;
        const Stencil& s = stencils_[static_cast<std::size_t>(ghost)];
        Real sum = 0;
        for (std::size_t row = 0; row < 4; ++row) {
            const Real* image = u.data + s.base + static_cast<Index>(row / 2) * u.stride_x +
                                static_cast<Index>(row % 2) * u.stride_y;
            sum += s.beta[2 * row] * image[0] + s.beta[2 * row + 1] * image[1];
        }
        if (s.place != 0) sum += second_differences(u, u.data + s.place, s.fraction, s.curvature);
        value = 0.5 * (u.data[offsets_[static_cast<std::size_t>(n)]] + sum);
    });
}

PrescribedNodes GhostNodes::prescribed() const
{
    return {mask_.view(), offsets_, values_, plane_begin_};
}

} // namespace starling
