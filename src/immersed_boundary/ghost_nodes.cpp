#include "immersed_boundary/ghost_nodes.hpp"

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

/// Sum of the second differences at q with the weights of a stencil.
Real second_differences(const Real* q, const std::array<Index, 3>& stride,
                        const std::array<Real, 6>& weight)
{
    Real sum = 0;
    for (std::size_t d = 0; d < 3; ++d) {
        const Index along = stride[d], e = stride[(d + 1) % 3], f = stride[(d + 2) % 3];
        sum += weight[d] * (q[along] - 2 * q[0] + q[-along]) +
               weight[d + 3] * (q[e + f] - q[e - f] - q[f - e] + q[-e - f]) / 4;
    }
    return sum;
}

} // namespace

GhostNodes::GhostNodes(const Grid& g, const Tube& tube, Location component,
                       std::vector<char> active_planes)
    : grid_(g), tube_(&tube), component_(component), active_planes_(std::move(active_planes)),
      nodes_(g.unknowns(component)), mask_(g), index_(g),
      ghost_begin_(static_cast<std::size_t>(g.nx() + 2), 0),
      resting_(static_cast<std::size_t>(g.nx() + 1)),
      plane_begin_(static_cast<std::size_t>(g.nx() + 2), 0)
{
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
        if (exists(n.i + di, n.j + dj, n.k + dk))
            f(NearNode{n.i + di, n.j + dj, n.k + dk, false, n.intercept});
}

bool GhostNodes::touches_other_side(const Field<std::uint8_t>& inside, const NearNode& n) const
{
    const auto flags = inside.view();
    bool touches = false;
    for_neighbours(
        n, [&](const NearNode& m) { touches |= flags(m.i, m.j, m.k) != flags(n.i, n.j, n.k); });
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
    ghost_index_.reserve(room);
    offsets_.reserve(room);
    source_.reserve(room);
    stencils_.reserve(room);
    suspect_.reserve(room);
    values_.reserve(room);
    // the neighbours of a section's outline, from its plane and the two beside it
    const auto outline = static_cast<std::size_t>(16 * (nodes_.end[1] + nodes_.end[2]));
    for (auto& plane : resting_) plane.reserve(outline);
    beside_rigid_wall_.assign(active_planes_.size(), 0); // search everywhere once
    update(search, s);
    const Real reach = 3 * std::max({grid_.spacing().x, grid_.spacing().y, grid_.spacing().z});
    for (Index i = nodes_.begin[0]; i < nodes_.end[0]; ++i)
        beside_rigid_wall_[static_cast<std::size_t>(i)] =
            grid_.x(component_, i) < tube_->x_clamp_in() - reach ||
            grid_.x(component_, i) > tube_->x_clamp_out() + reach;
}

void GhostNodes::search_missing(const InterceptSearch& search, GhostState& s, bool most)
{
    NearNode* all = s.near_wall.data();
    const auto nodes = static_cast<Index>(s.near_wall.size());
    const auto index = index_.view();
    const auto for_all = [=](auto f) { // a few nodes are not worth waking threads for
        if (most)
            for_range(0, nodes, f);
        else
            for (Index n = 0; n < nodes; ++n) f(n);
    };
    for_all([this, &search, all, index](Index n) {
        NearNode& node = all[n];
        index(node.i, node.j, node.k) = static_cast<std::int32_t>(n);
        if (!node.searched) node.intercept = search.walk(position(node), node.intercept.element);
    });
    suspect_.resize(s.near_wall.size());
    char* suspect = suspect_.data();
    for_all([this, &s, all, suspect](Index n) {
        suspect[n] =
            !all[n].searched && all[n].intercept.outside && follows_another_wall(s, all[n]);
    });
    for (std::size_t n = 0; n < suspect_.size(); ++n) {
        if (suspect_[n]) search_from_each_other(search, s, s.near_wall[n]);
        all[n].searched = true;
    }
}

template <class Ghosts, class F>
void GhostNodes::for_neighbours_across(Ghosts& s, const NearNode& n, F f) const
{
    const auto inside = s.inside.view();
    const auto index = index_.view();
    for_neighbours(n, [&](const NearNode& m) {
        if (inside(m.i, m.j, m.k) != inside(n.i, n.j, n.k))
            f(s.near_wall[static_cast<std::size_t>(index(m.i, m.j, m.k))]);
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
Index GhostNodes::turn_over(GhostState& s)
{
    constexpr Real indifference = 0.05;
    const Real band = indifference * grid_.spacing().x;
    const auto inside = s.inside.view();
    turned_.clear();
    for (const NearNode& node : s.near_wall) {
        std::uint8_t& flag = inside(node.i, node.j, node.k);
        const std::uint8_t now = node.intercept.outside ? 0 : 1;
        if (flag == now || node.intercept.squared_distance < band * band) continue;
        flag = now;
        turned_.push_back(node);
    }
    return static_cast<Index>(turned_.size());
}

// Nodes next to a turned node may now touch the other side; their search starts where the turned
// node's ended. Those already near the wall keep their own element but search again.
void GhostNodes::rebuild(GhostState& s)
{
    candidates_.clear();
    for (const NearNode& n : turned_) {
        candidates_.push_back(n);
        for_neighbours(n, [&](const NearNode& m) { candidates_.push_back(m); });
    }
    std::sort(candidates_.begin(), candidates_.end(), [](const NearNode& a, const NearNode& b) {
        return same_node(a, b) ? a.intercept.element < b.intercept.element : in_memory_order(a, b);
    });
    // old nodes come first among equals
    const auto old = static_cast<std::ptrdiff_t>(candidates_.size());
    candidates_.insert(candidates_.end(), s.near_wall.begin(), s.near_wall.end());
    s.near_wall.resize(candidates_.size());
    std::merge(candidates_.begin() + old, candidates_.end(), candidates_.begin(),
               candidates_.begin() + old, s.near_wall.begin(), in_memory_order);
    for (std::size_t n = 1; n < s.near_wall.size(); ++n)
        if (same_node(s.near_wall[n - 1], s.near_wall[n])) s.near_wall[n - 1].searched = false;
    s.near_wall.erase(std::unique(s.near_wall.begin(), s.near_wall.end(), same_node),
                      s.near_wall.end());
    std::erase_if(s.near_wall, [&](const NearNode& n) {
        return !n.searched && !touches_other_side(s.inside, n);
    });
}

bool GhostNodes::update(const InterceptSearch& search, GhostState& s)
{
    constexpr int most_sweeps = 8;
    for (NearNode& n : s.near_wall) n.searched = beside_rigid_wall_[static_cast<std::size_t>(n.i)];
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        search_missing(search, s, sweep == 0);
        if (turn_over(s) == 0) {
            mark_ghosts(s);
            make_stencils(s);
            list_nodes(s);
            return true;
        }
        rebuild(s);
    }
    return false;
}

void GhostNodes::mark_ghosts(const GhostState& s)
{
    const auto mask = mask_.view();
    const auto inside = s.inside.view();
    for (Index offset : offsets_) mask.data[offset] = 0;
    ghost_index_.clear();
    std::fill(ghost_begin_.begin(), ghost_begin_.end(), 0);
    for (std::size_t n = 0; n < s.near_wall.size(); ++n) {
        const NearNode& node = s.near_wall[n];
        if (inside(node.i, node.j, node.k)) continue;
        mask(node.i, node.j, node.k) = 1;
        ghost_index_.push_back(n);
        ++ghost_begin_[static_cast<std::size_t>(node.i) + 1];
    }
    for (std::size_t i = 1; i < ghost_begin_.size(); ++i) ghost_begin_[i] += ghost_begin_[i - 1];
}

// Ghosts and nodes at rest together, plane by plane in memory order.
void GhostNodes::list_nodes(const GhostState& s)
{
    const auto mask = mask_.view();
    find_nodes_at_rest(s);
    offsets_.clear();
    source_.clear();
    for (std::size_t i = 0; i < resting_.size(); ++i) {
        auto resting = resting_[i].begin();
        for (Index g = ghost_begin_[i]; g < ghost_begin_[i + 1]; ++g) {
            const NearNode& node = s.near_wall[ghost_index_[static_cast<std::size_t>(g)]];
            const Index offset = mask.offset(node.i, node.j, node.k);
            for (; resting != resting_[i].end() && *resting < offset; ++resting) {
                offsets_.push_back(*resting);
                source_.push_back(at_rest);
            }
            offsets_.push_back(offset);
            source_.push_back(static_cast<std::int32_t>(g));
        }
        for (; resting != resting_[i].end(); ++resting) {
            offsets_.push_back(*resting);
            source_.push_back(at_rest);
        }
        plane_begin_[i + 1] = static_cast<Index>(offsets_.size());
    }
    for (Index offset : offsets_) mask.data[offset] = 1;
    values_.resize(offsets_.size());
}

void GhostNodes::find_nodes_at_rest(const GhostState& s)
{
    const View<const std::uint8_t> mask = mask_.view(), inside = s.inside.view();
    for_range(0, static_cast<Index>(resting_.size()), [this, &s, mask, inside](Index i) {
        auto& resting = resting_[static_cast<std::size_t>(i)];
        resting.clear();
        const auto from = static_cast<std::size_t>(std::max<Index>(i - 1, 0));
        const auto to = std::min(static_cast<std::size_t>(i + 2), ghost_begin_.size() - 1);
        for (Index g = ghost_begin_[from]; g < ghost_begin_[to]; ++g)
            for_neighbours(s.near_wall[ghost_index_[static_cast<std::size_t>(g)]],
                           [&](const NearNode& m) {
                               if (m.i == i && !inside(m.i, m.j, m.k) && !mask(m.i, m.j, m.k))
                                   resting.push_back(mask.offset(m.i, m.j, m.k));
                           });
        std::sort(resting.begin(), resting.end());
        resting.erase(std::unique(resting.begin(), resting.end()), resting.end());
    });
}

void GhostNodes::make_stencils(const GhostState& s)
{
    stencils_.resize(ghost_index_.size());
    for_range(0, count(), [this, &s](Index g) {
        const auto n = static_cast<std::size_t>(g);
        stencils_[n] = make_stencil(s, s.near_wall[ghost_index_[n]]);
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
    for (Index l = x_first; l <= x_last; ++l)
        for (Index m = y_first; m <= y_last; ++m)
            for (Index q = z_first; q <= z_last; ++q)
                if (!inside(l, m, q)) return;
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
        const auto& [a, b, c] = s.fraction;
        Real sum = 0;
        for (std::size_t l = 0; l < 8; ++l) {
            const std::size_t di = l / 4, dj = l / 2 % 2, dk = l % 2;
            const Index corner = static_cast<Index>(di) * u.stride_x +
                                 static_cast<Index>(dj) * u.stride_y + static_cast<Index>(dk);
            sum += s.beta[l] * u.data[s.base + corner];
            if (s.place != 0)
                sum += (di ? a : 1 - a) * (dj ? b : 1 - b) * (dk ? c : 1 - c) *
                       second_differences(u.data + s.place + corner, {u.stride_x, u.stride_y, 1},
                                          s.curvature);
        }
        value = 0.5 * (u.data[offsets_[static_cast<std::size_t>(n)]] + sum);
    });
}

PrescribedNodes GhostNodes::prescribed() const
{
    return {mask_.view(), offsets_, values_, plane_begin_};
}

} // namespace starling
