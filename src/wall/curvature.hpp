#pragma once
/// Curvatures of the wall at its vertices and the Laplace-Beltrami operator on it.
///
/// Both work on interior vertices (no side of an element around them lies on the mesh's boundary)
/// and gather: a vertex reads its neighbours and writes itself, so that the bits do not depend on
/// threads.
#include "wall/geometry.hpp"

namespace starling {

/// Vertices first <= v < last.
struct VertexRange {
    VertexIndex first = 0, last = 0;
};

/// Vertices whose curvature changes when the wall deforms: the moving ones and the two rings on the
/// clamps. Empty for a rigid tube.
VertexRange bending_range(const Tube& tube);

/// Mean and Gaussian curvature at one point.
struct Curvatures {
    Real mean = 0;     ///< kappa = div n/2 with n outwards: 1/2 on a cylinder of radius 1 (1/R_0)
    Real gaussian = 0; ///< kappa_g (1/R_0^2)
};

/// The vertices around each vertex of a range, one after another.
class OneRings {
public:
    static constexpr std::size_t most = 16; ///< neighbours of a vertex

    /// Throws std::invalid_argument if a vertex of the range lies on the mesh's boundary or has
    /// more neighbours than that.
    OneRings(const WallMesh& mesh, VertexRange range);

    const VertexRange& range() const { return range_; }
    std::span<const VertexIndex> around(VertexIndex v) const
    {
        const auto n = static_cast<std::size_t>(v - range_.first);
        return {neighbours_.data() + begin_[n], begin_[n + 1] - begin_[n]};
    }

private:
    VertexRange range_;
    std::vector<VertexIndex> neighbours_;
    std::vector<std::size_t> begin_{0};
};

/// Curvatures from a quadric fitted to the vertices around: in axes with the third along the normal
/// (area vector) of the vertex, least squares of
///     h(s, t) = p s + q t + (a s^2 + 2 b s t + c t^2)/2
/// through the vertex itself.
class CurvatureFit {
public:
    CurvatureFit(const WallMesh& mesh, VertexRange range);

    /// Recomputes the curvatures at the positions x; `geometry` is that of x.
    void update(const Array<Vec3>& x, const Geometry& geometry);

    /// At the vertices of the range; zero elsewhere.
    const Array<Curvatures>& at_vertex() const { return at_vertex_; }

private:
    OneRings rings_;
    Array<Curvatures> at_vertex_;
};

/// The Laplace-Beltrami operator, Eqs. (20)-(22): gradients that are constant in each element,
/// their area-weighted mean at the vertices, and the flux of that through the sides around a
/// vertex.
class SurfaceLaplacian {
public:
    /// For vertices of `range`, with gradients at them and their neighbours: both ranges hold
    /// interior vertices only, and every neighbour of `range` lies in `gradient_range`.
    SurfaceLaplacian(const WallMesh& mesh, VertexRange range, VertexRange gradient_range);

    /// out = Lap_s phi at the vertices of the range, from phi at them and their neighbours'
    /// neighbours; `geometry` is that of x. Elsewhere `out` keeps its values.
    void apply(const Array<Vec3>& x, const Geometry& geometry, const Array<Real>& phi,
               Array<Real>& out);

private:
    /// Area of the elements around a vertex times the surface gradient there. (21), (22)
    void compute_gradients(const Array<Vec3>& x, const Geometry& geometry, const Array<Real>& phi);

    const WallMesh* mesh_;
    VertexRange range_, gradient_range_;
    Array<Vec3> gradient_;
    Array<Real> element_size_; ///< area of each element
};

} // namespace starling
