#pragma once
/// Shapes of the wall for tests: vertices keep their x, the clamped ends stay round.
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "wall/cross_section.hpp"
#include "wall/wall_state.hpp"

namespace starling::support {

/// A short tube with rigid ends.
inline TubeParameters short_tube()
{
    return {.length = 4, .rigid_inlet = 0.8, .rigid_outlet = 0.7};
}

/// Displacement across x as a function of the angle and of s, which runs from 0 to 1 between the
/// clamps; it fades out towards them.
struct Shape {
    std::string name;
    std::function<Point2(Real theta, Real s)> displacement;
};

/// Positions of the wall that has gone the part `progress` of the way to the shape.
inline Array<Vec3> positions(const Tube& tube, const Shape& shape, Real progress = 1)
{
    Array<Vec3> x = WallState(tube).x;
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) {
        const Real s = (x[v].x - tube.x_clamp_in()) / (tube.x_clamp_out() - tube.x_clamp_in());
        const Real fade = std::pow(std::sin(pi * s), 2);
        const Point2 d = shape.displacement(std::atan2(x[v].z, x[v].y), s);
        x[v] += progress * fade * Vec3{0, d.y, d.z};
    }
    return x;
}

/// r = 1 + amplitude cos(lobes theta + phase).
inline Shape lobed(int lobes, Real amplitude, Real phase = 0.3)
{
    return {"lobes" + std::to_string(lobes), [=](Real theta, Real) {
                const Real d = amplitude * std::cos(lobes * theta + phase);
                return Point2{d * std::cos(theta), d * std::sin(theta)};
            }};
}

/// r = 1 + amplitude.
inline Shape inflated(Real amplitude)
{
    Shape shape = lobed(0, amplitude, 0);
    shape.name = "inflated";
    return shape;
}

/// Wide along y, with a neck of half-width `neck` in the middle.
inline Shape dumbbell(Real neck)
{
    return {"dumbbell", [=](Real theta, Real) {
                const Real c = std::cos(theta), bulge = neck + 1.6 * (0.5 - neck) * c * c;
                return Point2{0.5 * c, (bulge - 1) * std::sin(theta)};
            }};
}

/// Smooth random displacements up to about `amplitude` in both directions.
inline Shape random_smooth(unsigned seed, Real amplitude)
{
    std::mt19937_64 engine(seed);
    std::normal_distribution<Real> normal;
    std::vector<std::array<Real, 4>> modes; // amplitude, wave numbers round and along, phase
    for (int n = 0; n < 12; ++n)
        modes.push_back({0.25 * amplitude * normal(engine), static_cast<Real>(n % 6 / 2 + n % 2),
                         static_cast<Real>(n % 3), 2 * pi * normal(engine)});
    return {"random" + std::to_string(seed), [=](Real theta, Real s) {
                std::array<Real, 2> d{};
                for (std::size_t n = 0; n < modes.size(); ++n) {
                    const auto& [a, round, along, phase] = modes[n];
                    d[n % 2] += a * std::cos(round * theta + pi * along * s + phase);
                }
                return Point2{d[0], d[1]};
            }};
}

/// Uniform values in (-size, size) added to every vertex that may move, in all directions.
inline void shake(const Tube& tube, Array<Vec3>& x, Real size, unsigned seed = 1)
{
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<Real> uniform(-size, size);
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v)
        x[v] += Vec3{uniform(engine), uniform(engine), uniform(engine)};
}

/// Rotation about `axis` (any length) by `angle`.
inline Vec3 rotated(const Vec3& a, const Vec3& axis, Real angle)
{
    const Vec3 e = (1 / norm(axis)) * axis;
    return std::cos(angle) * a + std::sin(angle) * cross(e, a) +
           (1 - std::cos(angle)) * dot(e, a) * e;
}

} // namespace starling::support
