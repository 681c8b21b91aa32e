#include "theory/block_tridiagonal.hpp"

namespace starling {

namespace {

Pair operator*(const Block& m, const Pair& v)
{
    return {m[0][0] * v[0] + m[0][1] * v[1], m[1][0] * v[0] + m[1][1] * v[1]};
}

Block operator*(const Block& m, const Block& n)
{
    const Pair c0 = m * Pair{n[0][0], n[1][0]}, c1 = m * Pair{n[0][1], n[1][1]};
    return {Pair{c0[0], c1[0]}, Pair{c0[1], c1[1]}};
}

Pair operator-(const Pair& a, const Pair& b) { return {a[0] - b[0], a[1] - b[1]}; }
Block operator-(const Block& a, const Block& b) { return {a[0] - b[0], a[1] - b[1]}; }

Block inverse(const Block& m)
{
    const Real d = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    return {Pair{m[1][1] / d, -m[0][1] / d}, Pair{-m[1][0] / d, m[0][0] / d}};
}

} // namespace

void BlockTridiagonal::solve(std::vector<Pair>& a, std::vector<Pair>& b)
{
    const std::size_t n = diagonal.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (i > 0) {
            diagonal[i] = diagonal[i] - lower[i] * upper[i - 1];
            a[i] = a[i] - lower[i] * a[i - 1];
            b[i] = b[i] - lower[i] * b[i - 1];
        }
        const Block m = inverse(diagonal[i]);
        upper[i] = m * upper[i];
        a[i] = m * a[i];
        b[i] = m * b[i];
    }
    for (std::size_t i = n - 1; i-- > 0;) {
        a[i] = a[i] - upper[i] * a[i + 1];
        b[i] = b[i] - upper[i] * b[i + 1];
    }
}

} // namespace starling
