#include "wall/perturbation.hpp"

namespace starling {

namespace {

constexpr Index most_lobes = 12, most_half_waves = 4;

/// a cos(n theta + phase) sin(m pi s).
struct Wave {
    Real a;
    Index n, m;
    Real phase;

    Real at(Real theta, Real s) const
    {
        return a * std::cos(static_cast<Real>(n) * theta + phase) *
               std::sin(static_cast<Real>(m) * pi * s);
    }
};

/// Uniform numbers in [0, 1) by splitmix64 (G. L. Steele, D. Lea and C. H. Flood, OOPSLA 2014): the
/// distributions of the standard library differ from one library to the next.
class Random {
public:
    explicit Random(Index seed) : state_(static_cast<std::uint64_t>(seed)) {}
    Real operator()()
    {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        z ^= z >> 31;
        return static_cast<Real>(z >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_;
};

std::vector<Wave> random_waves(const PerturbationParameters& p)
{
    Random random(p.seed);
    std::vector<Wave> waves;
    Real mean_square = 0;
    for (Index n = 2; n <= most_lobes; ++n)
        for (Index m = 1; m <= most_half_waves; ++m) {
            const Real a = 2 * random() - 1, phase = 2 * pi * random();
            waves.push_back({a, n, m, phase});
            mean_square += a * a / 4;
        }
    for (Wave& wave : waves) wave.a *= p.amplitude / std::sqrt(mean_square);
    return waves;
}

} // namespace

void perturb(const Tube& tube, const PerturbationParameters& p, Array<Vec3>& x)
{
    if (p.amplitude == 0) return;
    const std::vector<Wave> waves =
        p.mode ? std::vector<Wave>{{p.amplitude, *p.mode, 1, 0}} : random_waves(p);
    const Real first = tube.x_clamp_in(), length = tube.x_clamp_out() - first;
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) {
        const Vec3& X = tube.X[static_cast<std::size_t>(v)];
        Real radius = 1;
        for (const Wave& wave : waves)
            radius += wave.at(std::atan2(X.z, X.y), (X.x - first) / length);
        x[v] = {X.x, radius * X.y, radius * X.z};
    }
}

} // namespace starling
