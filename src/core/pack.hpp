#pragma once
/// Four and eight values side by side in SIMD registers.
#include <cstring>

#include "core/types.hpp"

// Packs are passed within a translation unit only, so the calling convention does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace starling {

/// Arithmetic acts on all values alike.
using Pack4 __attribute__((vector_size(4 * sizeof(Real)))) = Real;
using Pack8 __attribute__((vector_size(8 * sizeof(Real)))) = Real;

/// Values from and to any address.
inline Pack4 load4(const Real* x)
{
    Pack4 a;
    std::memcpy(&a, x, sizeof a);
    return a;
}
inline Pack8 load8(const Real* x)
{
    Pack8 a;
    std::memcpy(&a, x, sizeof a);
    return a;
}
inline void store8(const Pack8& a, Real* x) { std::memcpy(x, &a, sizeof a); }
inline Pack8 sqrt(Pack8 a)
{
    for (int n = 0; n < 8; ++n) a[n] = std::sqrt(a[n]);
    return a;
}

/// Eight three-vectors.
struct Vec3Pack {
    Pack8 x{}, y{}, z{};

    void set(int n, const Vec3& a) { x[n] = a.x, y[n] = a.y, z[n] = a.z; }
};

inline Vec3Pack operator-(const Vec3Pack& a, const Vec3Pack& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3Pack operator*(const Pack8& s, const Vec3Pack& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Pack8 dot(const Vec3Pack& a, const Vec3Pack& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3Pack cross(const Vec3Pack& a, const Vec3Pack& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Pack8 norm(const Vec3Pack& a) { return sqrt(dot(a, a)); }

/// Asks for `count` values, at most a cache line of them, before they are needed. What lies about
/// the wall in one x-plane, too scattered for the machine to foresee, lies about there in the next.
inline void prefetch_stencil(const Real* x, Index count)
{
    __builtin_prefetch(x);
    __builtin_prefetch(x + count - 1);
}

} // namespace starling
