#include "wall/curvature.hpp"

#include <stdexcept>

#include "core/for_each.hpp"
#include "core/pack.hpp"

namespace starling {

namespace {

constexpr std::size_t terms = 5; ///< of the quadric: p, q, a, b, c

/// Normal equations of the least-squares fits of eight vertices; only the lower triangle of the
/// matrix is used.
struct NormalEquations {
    std::array<std::array<Pack8, terms>, terms> matrix{};
    std::array<Pack8, terms> rhs{};

    void add(const Pack8& s, const Pack8& t, const Pack8& h)
    {
        const std::array<Pack8, terms> basis{s, t, s * s / 2, s * t, t * t / 2};
        for (std::size_t m = 0; m < terms; ++m) {
            for (std::size_t n = 0; n <= m; ++n) matrix[m][n] += basis[m] * basis[n];
            rhs[m] += basis[m] * h;
        }
    }

    /// Cholesky factorisation in place, the diagonal inverted, then the two triangular systems.
    const std::array<Pack8, terms>& solve()
    {
        for (std::size_t m = 0; m < terms; ++m) {
            for (std::size_t n = 0; n <= m; ++n) {
                Pack8 sum = matrix[m][n];
                for (std::size_t k = 0; k < n; ++k) sum -= matrix[m][k] * matrix[n][k];
                matrix[m][n] = m == n ? 1 / sqrt(sum) : sum * matrix[n][n];
            }
            for (std::size_t k = 0; k < m; ++k) rhs[m] -= matrix[m][k] * rhs[k];
            rhs[m] *= matrix[m][m];
        }
        for (std::size_t m = terms; m-- > 0;) {
            for (std::size_t k = m + 1; k < terms; ++k) rhs[m] -= matrix[k][m] * rhs[k];
            rhs[m] *= matrix[m][m];
        }
        return rhs;
    }
};

struct CurvaturesPack {
    Pack8 mean, gaussian;
};

/// Curvatures of the graphs h(s, t) at the origin, with the normal towards positive h.
CurvaturesPack of_graph(const std::array<Pack8, terms>& quadric)
{
    const auto& [p, q, a, b, c] = quadric;
    const Pack8 g = 1 + p * p + q * q;
    const Pack8 div_n = -((1 + q * q) * a - 2 * p * q * b + (1 + p * p) * c) / (g * sqrt(g));
    return {div_n / 2, (a * c - b * b) / (g * g)};
}

/// Eight vertices, each with the positions around it relative to its own. Missing neighbours lie at
/// the vertex itself, where they add nothing to the equations.
struct Neighbourhoods {
    Vec3Pack area;
    std::array<Vec3Pack, OneRings::most> around{};
    std::size_t size = 0;

    void set(int n, const Vec3* x, VertexIndex v, std::span<const VertexIndex> ring,
             const Vec3& area_vector)
    {
        area.set(n, area_vector);
        for (std::size_t m = 0; m < ring.size(); ++m) around[m].set(n, x[ring[m]] - x[v]);
        size = std::max(size, ring.size());
    }
};

/// Lengths are divided by that of the first edge while the equations are solved.
CurvaturesPack fit(const Neighbourhoods& vertices)
{
    const Vec3Pack normal = (1 / norm(vertices.area)) * vertices.area;
    const Vec3Pack& edge = vertices.around[0];
    const Vec3Pack in_plane = edge - dot(edge, normal) * normal;
    const Pack8 scale = 1 / norm(edge);
    const Vec3Pack e_s = (1 / norm(in_plane)) * in_plane, e_t = cross(normal, e_s);
    NormalEquations equations;
    for (std::size_t m = 0; m < vertices.size; ++m) {
        const Vec3Pack d = scale * vertices.around[m];
        equations.add(dot(d, e_s), dot(d, e_t), dot(d, normal));
    }
    const CurvaturesPack scaled = of_graph(equations.solve());
    return {scaled.mean * scale, scaled.gaussian * scale * scale};
}

} // namespace

VertexRange bending_range(const Tube& tube)
{
    if (tube.moving_begin() == tube.moving_end()) return {};
    return {tube.first(tube.clamp_in), tube.first(tube.clamp_out + 1)};
}

OneRings::OneRings(const WallMesh& mesh, VertexRange range) : range_(range)
{
    for (VertexIndex v = range.first; v < range.last; ++v) {
        for (const Corner* c = mesh.corners_begin(v); c != mesh.corners_end(v); ++c) {
            // every neighbour of an inner vertex follows it in exactly one of its elements
            const int next = (c->corner + 1) % 3, last = (c->corner + 2) % 3;
            if (mesh.neighbour(c->element, next) < 0 || mesh.neighbour(c->element, last) < 0)
                throw std::invalid_argument("one-rings: a vertex lies on the mesh's boundary");
            neighbours_.push_back(mesh.element(c->element)[static_cast<std::size_t>(next)]);
        }
        if (neighbours_.size() - begin_.back() > most)
            throw std::invalid_argument("one-rings: a vertex has more than 16 neighbours");
        begin_.push_back(neighbours_.size());
    }
}

CurvatureFit::CurvatureFit(const WallMesh& mesh, VertexRange range)
    : rings_(mesh, range), at_vertex_(mesh.vertex_count())
{
}

void CurvatureFit::update(const Array<Vec3>& x, const Geometry& geometry)
{
    const Vec3 *position = x.data(), *area = geometry.vertex_area().data();
    Curvatures* out = at_vertex_.data();
    const VertexIndex first = rings_.range().first, last = rings_.range().last;
    for_range(0, (last - first + 7) / 8, [=, this](Index group) {
        const VertexIndex begin = first + 8 * static_cast<VertexIndex>(group);
        Neighbourhoods vertices;
        for (int n = 0; n < 8; ++n) {
            const VertexIndex v = std::min(begin + n, last - 1);
            vertices.set(n, position, v, rings_.around(v), area[v]);
        }
        const CurvaturesPack curvatures = fit(vertices);
        for (int n = 0; n < 8 && begin + n < last; ++n)
            out[begin + n] = {curvatures.mean[n], curvatures.gaussian[n]};
    });
}

SurfaceLaplacian::SurfaceLaplacian(const WallMesh& mesh, VertexRange range,
                                   VertexRange gradient_range)
    : mesh_(&mesh), range_(range), gradient_range_(gradient_range), gradient_(mesh.vertex_count()),
      element_size_(mesh.element_count())
{
}

// With the element's unit normal N and its sides e_k, e_k opposite corner k and all in one sense of
// rotation, grad phi = N x sum_k phi_k e_k/(2 area): (21) with the heights written out. The area
// drops out of the weighted mean (22).
void SurfaceLaplacian::compute_gradients(const Array<Vec3>& x, const Geometry& geometry,
                                         const Array<Real>& phi)
{
    const WallMesh& mesh = *mesh_;
    const Vec3* area = geometry.element_area().data();
    const Real* size = element_size_.data();
    Vec3* gradient = gradient_.data();
    for_range(gradient_range_.first, gradient_range_.last, [&, area, size, gradient](Index v) {
        const auto vertex = static_cast<VertexIndex>(v);
        Vec3 sum;
        Real S = 0;
        for (const Corner* c = mesh.corners_begin(vertex); c != mesh.corners_end(vertex); ++c) {
            const auto& [i, j, k] = mesh.element(c->element);
            const Vec3 sides =
                phi[i] * (x[k] - x[j]) + phi[j] * (x[i] - x[k]) + phi[k] * (x[j] - x[i]);
            const Real S_m = size[c->element];
            sum += (0.5 / S_m) * cross(area[c->element], sides);
            S += S_m;
        }
        gradient[v] = (1 / S) * sum;
    });
}

void SurfaceLaplacian::apply(const Array<Vec3>& x, const Geometry& geometry, const Array<Real>& phi,
                             Array<Real>& out)
{
    const WallMesh& mesh = *mesh_;
    const Vec3 *area = geometry.element_area().data(), *gradient = gradient_.data();
    Real *size = element_size_.data(), *laplacian = out.data();
    for_range(0, mesh.element_count(), [=](Index e) { size[e] = norm(area[e]); });
    compute_gradients(x, geometry, phi);
    for_range(range_.first, range_.last, [&, area, size, gradient, laplacian](Index v) {
        const auto vertex = static_cast<VertexIndex>(v);
        Real flux = 0, S = 0;
        for (const Corner* c = mesh.corners_begin(vertex); c != mesh.corners_end(vertex); ++c) {
            const auto& element = mesh.element(c->element);
            const VertexIndex j = element[static_cast<std::size_t>((c->corner + 1) % 3)];
            const VertexIndex k = element[static_cast<std::size_t>((c->corner + 2) % 3)];
            const Real S_m = size[c->element];
            // (x_k - x_j) x N is the side's outward normal times its length
            const Vec3 normal_length = (1 / S_m) * cross(x[k] - x[j], area[c->element]);
            flux += dot(normal_length, gradient[j] + gradient[k]);
            S += S_m;
        }
        laplacian[v] = flux / (2 * S); // (20)
    });
}

} // namespace starling
