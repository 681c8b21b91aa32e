#pragma once
/// Scalar, index and three-vector types shared by every module.
#include <array>
#include <cmath>
#include <cstdint>

namespace starling {

using Real = double;
using Index = std::int64_t;        ///< Eulerian indices i, j, k and sizes
using VertexIndex = std::int32_t;  ///< index of a wall vertex
using ElementIndex = std::int32_t; ///< index of a wall element (triangle)
using EdgeIndex = std::int32_t;    ///< index of a wall edge

inline constexpr Real pi = 3.14159265358979323846;

/// Cartesian three-vector (x along the tube, y and z across it).
struct Vec3 {
    Real x = 0, y = 0, z = 0;

    constexpr Vec3& operator+=(const Vec3& b) { return x += b.x, y += b.y, z += b.z, *this; }
    constexpr Vec3& operator-=(const Vec3& b) { return x -= b.x, y -= b.y, z -= b.z, *this; }
    constexpr Vec3& operator*=(Real s) { return x *= s, y *= s, z *= s, *this; }
    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(Vec3 a, const Vec3& b) { return a += b; }
constexpr Vec3 operator-(Vec3 a, const Vec3& b) { return a -= b; }
constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Real s, Vec3 a) { return a *= s; }
constexpr Vec3 operator*(Vec3 a, Real s) { return a *= s; }
constexpr Real dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real norm(const Vec3& a) { return std::sqrt(dot(a, a)); }

} // namespace starling
