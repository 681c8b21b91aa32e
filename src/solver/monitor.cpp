#include "solver/monitor.hpp"

#include <limits>

namespace starling {

SpeedCheck check_speed(const Grid& g, const VectorField& u, Real dt)
{
    SpeedCheck check;
    bool finite = true;
    for (Location c : components) {
        const View<const Real> f = u[c].view();
        const Box b = g.unknowns(c);
        Real largest = 0, sum = 0;
#pragma omp parallel for schedule(static) reduction(max : largest) reduction(+ : sum)
        for (Index i = b.begin[0]; i < b.end[0]; ++i)
            for (Index j = b.begin[1]; j < b.end[1]; ++j)
#pragma omp simd reduction(max : largest) reduction(+ : sum)
                for (Index k = b.begin[2]; k < b.end[2]; ++k) {
                    largest = std::max(largest, std::abs(f(i, j, k)));
                    sum += 0 * f(i, j, k); // NaN if any value is not finite
                }
        finite = finite && sum == 0;
        const Vec3 h = g.spacing();
        const Real spacing = c == Location::u ? h.x : c == Location::v ? h.y : h.z;
        check.cfl = std::max(check.cfl, largest * dt / spacing);
        check.u_max = std::max(check.u_max, largest);
    }
    if (!finite) check.cfl = check.u_max = std::numeric_limits<Real>::quiet_NaN();
    return check;
}

Monitor::Monitor(const Grid& g, Operators& op, const FluidParameters& fluid,
                 const DriveParameters& drive)
    : grid_(g), tube_(&op.tube), elastic_(&op.elastic), bending_(&op.bending),
      inv_reynolds_(1 / fluid.reynolds), geometry_(op.tube.mesh),
      before_(static_cast<Index>(op.tube.X.size())), section_flow_(g, op.tube),
      power_(g, op, fluid, drive)
{
}

Monitor::Ring Monitor::ring_radius(const Array<Vec3>& x, Index ring) const
{
    Ring r{0, std::numeric_limits<Real>::max(), 0};
    for (VertexIndex v = tube_->first(ring); v < tube_->first(ring + 1); ++v) {
        const Real radius = std::hypot(x[v].y, x[v].z);
        r.mean += radius / tube_->ring_size;
        r.min = std::min(r.min, radius);
        r.max = std::max(r.max, radius);
    }
    return r;
}

Vec3 Monitor::outward_normal(VertexIndex v) const
{
    const Vec3 a = geometry_.vertex_area()[v];
    return (1 / norm(a)) * a;
}

void Monitor::find_positions_before(const State& s)
{
    const Real dt = s.fluid.dt_before;
    for (Index v = 0; v < before_.size(); ++v) before_[v] = s.wall.x[v] - dt * s.wall.velocity[v];
}

/// dV/dt over the last step: exactly the change of the enclosed volume.
Real Monitor::volume_rate(const State& s)
{
    const Real dt = s.fluid.dt_before;
    if (dt == 0) return 0;
    find_positions_before(s);
    return (enclosed_volume(*tube_, s.wall.x) - enclosed_volume(*tube_, before_)) / dt;
}

namespace {

Real width_or_nan(Real width)
{
    return width < no_gap ? width : std::numeric_limits<Real>::quiet_NaN();
}

} // namespace

void Monitor::add_narrowest_section(const Array<Vec3>& x, Sample& a) const
{
    Index narrowest = 0;
    Real least = std::numeric_limits<Real>::max();
    for (Index ring = 0; ring < tube_->rings(); ++ring) {
        const Real ratio = ring_area(*tube_, x, ring) / undeformed_area(ring);
        if (ratio < least) least = ratio, narrowest = ring;
    }
    a.min_area_ratio = least;
    a.x_min_area = tube_->ring_x[static_cast<std::size_t>(narrowest)];
    a.lobes = radius_modes(*tube_, x, narrowest).lobes();
}

/// Of the polygon through a ring's vertices.
Real Monitor::undeformed_area(Index ring) const
{
    const auto n = static_cast<Real>(tube_->ring_size);
    const Real R = tube_->ring_radius[static_cast<std::size_t>(ring)];
    return R * R * n / 2 * std::sin(2 * pi / n);
}

namespace {

void add_powers(const Powers& p, Sample& a)
{
    a.power_in = p.inlet;
    a.power_out = p.outlet;
    a.power_exterior = p.exterior;
    a.power_viscous = p.dissipation;
    a.power_kinetic = p.kinetic;
    a.power_wall = p.wall;
    a.power_residual = p.residual();
}

} // namespace

Sample Monitor::sample(const State& s)
{
    const Array<Vec3>& x = s.wall.x;
    geometry_.update(x);
    Sample a;
    a.t = s.t;
    a.step = s.step;
    a.dt = s.fluid.dt_before > 0 ? s.fluid.dt_before : s.dt;
    const ScalarField& u = s.fluid.u[Location::u];
    a.Q_in = section_flow_.inside(u, x, 0);
    a.Q_mid = section_flow_.inside(u, x, grid_.nx() / 2);
    a.Q_out = section_flow_.inside(u, x, grid_.nx());
    a.Q_exterior = section_flow_.total(u, grid_.nx() / 2) - a.Q_mid;
    a.P_in = s.fluid.ends.inside[0];
    a.P_out = s.fluid.ends.inside[1];
    a.dV_dt = volume_rate(s);
    a.leak = a.dV_dt - (a.Q_in - a.Q_out);
    a.volume = enclosed_volume(*tube_, x);
    a.R_min = std::numeric_limits<Real>::max();
    for (Index ring = 0; ring < tube_->rings(); ++ring) {
        const Ring r = ring_radius(x, ring);
        a.R_min = std::min(a.R_min, r.min);
        if (r.mean <= a.R_max) continue;
        a.R_max = r.mean;
        a.x_R_max = tube_->ring_x[static_cast<std::size_t>(ring)];
    }
    a.smallest_gap = width_or_nan(smallest_gap(*tube_, x));
    add_narrowest_section(x, a);
    a.kinetic_energy = s.fluid.kinetic_energy;
    a.elastic_energy = elastic_->energy(x);
    a.bending_energy = bending_->energy(x, geometry_);
    add_powers(power_.measure(s), a);
    for (VertexIndex v = tube_->moving_begin(); v < tube_->moving_end(); ++v)
        a.largest_displacement =
            std::max(a.largest_displacement, norm(x[v] - tube_->X[static_cast<std::size_t>(v)]));
    for (ElementIndex e = 0; e < tube_->mesh.element_count(); ++e)
        a.max_strain = std::max(a.max_strain, elastic_->stretches(x, e)[0] - 1);
    a.cfl = check_speed(grid_, s.fluid.u, a.dt).cfl;
    return a;
}

// Beyond the smeared pressure jump of +-2 spacings, but not past the middle of the lumen.
Real Monitor::transmural_pressure(const State& s, VertexIndex v) const
{
    const Array<Vec3>& x = s.wall.x;
    const VertexIndex n = tube_->ring_size, first = v / n * n;
    const Vec3 normal = outward_normal(v);
    const Real beyond = 2.5 * grid_.delta();
    const Real inside = std::min(beyond, lumen_width(&x[first], n, v - first) / 2);
    const auto P = [&](const Vec3& p) {
        return interpolate_at(grid_, Location::cell, s.fluid.P, p);
    };
    return P(x[v] - inside * normal) - P(x[v] + beyond * normal);
}

Vec3 Monitor::wall_shear_stress(const State& s, VertexIndex v) const
{
    const Vec3 n = outward_normal(v), U = s.wall.velocity[v];
    const Real step = 1.5 * grid_.delta();
    const auto slip = [&](Real depth) {
        const Vec3 p = s.wall.x[v] - depth * n;
        const Vec3 u{interpolate_at(grid_, Location::u, s.fluid.u[Location::u], p),
                     interpolate_at(grid_, Location::v, s.fluid.u[Location::v], p),
                     interpolate_at(grid_, Location::w, s.fluid.u[Location::w], p)};
        const Vec3 d = u - U;
        return d - dot(d, n) * n;
    };
    return (inv_reynolds_ / (2 * step)) * (4 * slip(step) - slip(2 * step));
}

std::vector<Vec3> Monitor::wall_shear_stress(const State& s)
{
    geometry_.update(s.wall.x);
    std::vector<Vec3> stress(static_cast<std::size_t>(s.wall.x.size()));
    Vec3* at = stress.data();
    for_range(0, s.wall.x.size(), [this, &s, at](Index v) {
        at[v] = wall_shear_stress(s, static_cast<VertexIndex>(v));
    });
    return stress;
}

namespace {

void add_shape(const RadiusModes& modes, ProfileRow& row)
{
    row.lobes = modes.lobes();
    row.mode_2 = modes.amplitude[2];
    row.mode_3 = modes.amplitude[3];
    row.mode_4 = modes.amplitude[4];
    row.mode_5 = modes.amplitude[5];
    row.mode_6 = modes.amplitude[6];
    row.mode_7 = modes.amplitude[7];
    row.mode_8 = modes.amplitude[8];
}

} // namespace

std::vector<SectionPoint> Monitor::sections(const State& s) const
{
    std::vector<SectionPoint> points;
    for (VertexIndex v = 0; v < tube_->mesh.vertex_count(); ++v) {
        const Vec3 &X = tube_->X[static_cast<std::size_t>(v)], &p = s.wall.x[v];
        points.push_back({X.x, std::atan2(X.z, X.y), p.y, p.z});
    }
    return points;
}

namespace {

/// Values on the face planes, a spacing h apart, between them.
Real between_planes(const std::vector<Real>& values, Real h, Real x)
{
    const Real i = x / h;
    const auto below = std::min(static_cast<std::size_t>(i), values.size() - 2);
    const Real fraction = i - static_cast<Real>(below);
    return (1 - fraction) * values[below] + fraction * values[below + 1];
}

} // namespace

/// dV/dt - (Q(0) - Q(x)) for the part of the tube before each ring, docs/numerics.md (I').
std::vector<Real> Monitor::leak_up_to_rings(const State& s)
{
    find_positions_before(s);
    const std::vector<Real> V = volume_up_to_rings(*tube_, s.wall.x),
                            V_before = volume_up_to_rings(*tube_, before_);
    const Real dt = s.fluid.dt_before;
    const auto Q = [&](std::size_t ring) {
        return section_flow_.reconstructed(s.fluid.u[Location::u], s.wall.x, tube_->ring_x[ring]);
    };
    const Real Q_in = Q(0);
    std::vector<Real> leak;
    for (std::size_t ring = 0; ring < V.size(); ++ring)
        leak.push_back((dt > 0 ? (V[ring] - V_before[ring]) / dt : 0) + Q(ring) - Q_in);
    return leak;
}

std::vector<ProfileRow> Monitor::profile(const State& s)
{
    const Array<Vec3>& x = s.wall.x;
    geometry_.update(x);
    std::vector<Real> Q; // on the face planes
    for (Index i = 0; i <= grid_.nx(); ++i)
        Q.push_back(section_flow_.inside(s.fluid.u[Location::u], x, i));
    const std::vector<Real> leak = leak_up_to_rings(s);

    std::vector<ProfileRow> rows;
    for (Index ring = 0; ring < tube_->rings(); ++ring) {
        const Ring r = ring_radius(x, ring);
        ProfileRow row;
        row.x = tube_->ring_x[static_cast<std::size_t>(ring)];
        row.R_mean = r.mean;
        row.R_min = r.min;
        row.R_max = r.max;
        row.area = ring_area(*tube_, x, ring);
        add_shape(radius_modes(*tube_, x, ring), row);
        row.gap = width_or_nan(smallest_gap(*tube_, x, ring));
        row.P_centre = interpolate_at(grid_, Location::cell, s.fluid.P, {row.x, 0, 0});
        for (VertexIndex v = tube_->first(ring); v < tube_->first(ring + 1); ++v)
            row.P_transmural += transmural_pressure(s, v) / tube_->ring_size;
        row.Q = between_planes(Q, grid_.spacing().x, row.x);
        row.leak = leak[static_cast<std::size_t>(ring)];
        rows.push_back(row);
    }
    return rows;
}

namespace {

/// An array of `count` values per location, filled by f(location, component).
template <class F>
NamedArray make_array(std::string name, Quantity quantity, int components, Index count, F f)
{
    NamedArray a{std::move(name), quantity, components, {}};
    a.values.reserve(static_cast<std::size_t>(count * components));
    for (Index n = 0; n < count; ++n)
        for (int c = 0; c < components; ++c) a.values.push_back(f(n, c));
    return a;
}

Real component_of(const Vec3& a, int c) { return c == 0 ? a.x : c == 1 ? a.y : a.z; }

} // namespace

WallSnapshot Monitor::wall_motion(const State& s, const Array<Vec3>& elastic_force) const
{
    const Array<Vec3>& x = s.wall.x;
    WallSnapshot a;
    a.t = s.t;
    a.step = s.step;
    a.points.assign(x.begin(), x.end());
    a.triangles = tube_->mesh.elements();

    const Index vertices = x.size();
    a.at_vertex.push_back(
        make_array("displacement", Quantity::length, 3, vertices, [&](Index v, int c) {
            return component_of(x[v] - tube_->X[static_cast<std::size_t>(v)], c);
        }));
    a.at_vertex.push_back(
        make_array("velocity", Quantity::velocity, 3, vertices,
                   [&](Index v, int c) { return component_of(s.wall.velocity[v], c); }));
    a.at_vertex.push_back(
        make_array("elastic_force", Quantity::force, 3, vertices,
                   [&](Index v, int c) { return component_of(elastic_force[v], c); }));
    return a;
}

WallSnapshot Monitor::wall(const State& s, const Array<Vec3>& elastic_force)
{
    const Array<Vec3>& x = s.wall.x;
    geometry_.update(x);
    WallSnapshot a = wall_motion(s, elastic_force);
    const Index vertices = x.size(), elements = tube_->mesh.element_count();
    a.at_vertex.push_back(
        make_array("support_force", Quantity::force, 3, vertices,
                   [&](Index v, int c) { return component_of(s.wall.support[v], c); }));
    a.at_vertex.push_back(
        make_array("transmural_pressure", Quantity::pressure, 1, vertices, [&](Index v, int) {
            return transmural_pressure(s, static_cast<VertexIndex>(v));
        }));
    a.at_vertex.push_back(
        make_array("wall_shear_stress", Quantity::shear_stress, 1, vertices, [&](Index v, int) {
            return norm(wall_shear_stress(s, static_cast<VertexIndex>(v)));
        }));
    const auto stretch = [&](Index e) {
        return elastic_->stretches(x, static_cast<ElementIndex>(e));
    };
    const auto tension = [&](Index e) {
        const std::array<Real, 2> lambda = stretch(e);
        const Tensions tau =
            std::visit([&](const auto& law) { return law.tensions(lambda[0], lambda[1]); },
                       elastic_->material());
        const Real k = elastic_->stiffness(static_cast<ElementIndex>(e));
        return Tensions{k * tau.tau1, k * tau.tau2};
    };
    a.at_element.push_back(make_array("lambda1", Quantity::none, 1, elements,
                                      [&](Index e, int) { return stretch(e)[0]; }));
    a.at_element.push_back(make_array("lambda2", Quantity::none, 1, elements,
                                      [&](Index e, int) { return stretch(e)[1]; }));
    a.at_element.push_back(make_array("tau1", Quantity::surface_tension, 1, elements,
                                      [&](Index e, int) { return tension(e).tau1; }));
    a.at_element.push_back(make_array("tau2", Quantity::surface_tension, 1, elements,
                                      [&](Index e, int) { return tension(e).tau2; }));
    return a;
}

FluidSnapshot Monitor::fluid(const State& s) const
{
    FluidSnapshot a;
    a.t = s.t;
    a.step = s.step;
    a.cells = grid_.cells();
    a.origin = grid_.origin();
    a.spacing = grid_.spacing();
    const auto u = s.fluid.u[Location::u].view(), v = s.fluid.u[Location::v].view(),
               w = s.fluid.u[Location::w].view(), P = s.fluid.P.view();
    const Index ny = grid_.ny(), nz = grid_.nz();
    const auto at = [=](Index n) {
        return std::array<Index, 3>{n / (ny * nz), n / nz % ny, n % nz};
    };
    a.at_cell.push_back(
        make_array("velocity", Quantity::velocity, 3, grid_.cell_count(), [&](Index n, int c) {
            const auto [i, j, k] = at(n);
            return c == 0   ? (u(i, j, k) + u(i + 1, j, k)) / 2
                   : c == 1 ? (v(i, j, k) + v(i, j + 1, k)) / 2
                            : (w(i, j, k) + w(i, j, k + 1)) / 2;
        }));
    a.at_cell.push_back(
        make_array("pressure", Quantity::pressure, 1, grid_.cell_count(), [&](Index n, int) {
            const auto [i, j, k] = at(n);
            return P(i, j, k);
        }));
    return a;
}

} // namespace starling
