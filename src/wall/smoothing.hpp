#pragma once
/// Smoothing of the wall by surface diffusion (sec. 2.8).
#include <optional>

#include "wall/curvature.hpp"

namespace starling {

/// Adds the normal velocity alpha Lap_s kappa, kappa less that of the undeformed mesh, to the
/// moving vertices. Vertices keep their x: they take the velocity across x that moves the surface
/// along its normal as fast.
/// Deviation: the printed sign is minus. With kappa = div n/2 and n outwards plus is diffusion.
class SurfaceSmoothing {
public:
    /// alpha in U_c R_0^3; nothing is done for 0 or a rigid tube. `tube` must outlive the object.
    SurfaceSmoothing(const Tube& tube, Real alpha);

    /// `geometry` is that of wall.x.
    void add_velocity(const Geometry& geometry, WallState& wall);

private:
    struct Diffusion {
        VertexRange range;
        CurvatureFit fit;
        SurfaceLaplacian laplacian;
        Array<Real> undeformed; ///< kappa of the undeformed mesh
        Array<Real> kappa;      ///< less that
        Array<Real> laplacian_kappa;

        explicit Diffusion(const Tube& tube);
        void update(const Array<Vec3>& x, const Geometry& geometry);
    };

    const Tube* tube_;
    Real alpha_;
    std::optional<Diffusion> diffusion_;
};

} // namespace starling
