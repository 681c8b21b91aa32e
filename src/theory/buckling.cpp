#include "theory/buckling.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "theory/mode_stiffness.hpp"

namespace starling {

namespace {

/// A trial function along x and its derivatives.
struct Trial {
    Real value, d1, d2;
};

Trial sine(int m, Real length, Real x)
{
    const Real q = m * pi / length, s = std::sin(q * x), c = std::cos(q * x);
    return {s, q * c, -q * q * s};
}

Trial radial_trial(TubeEnds ends, int m, Real length, Real x)
{
    const Trial f = sine(m, length, x);
    if (ends == TubeEnds::pinned) return f;
    const Trial g = sine(1, length, x);
    return {f.value * g.value, f.d1 * g.value + f.value * g.d1,
            f.d2 * g.value + 2 * f.d1 * g.d1 + f.value * g.d2};
}

/// A symmetric matrix, of which the lower triangle is used.
class SymmetricMatrix {
public:
    explicit SymmetricMatrix(std::size_t size) : size_(size), entries_(size * size) {}
    Real& operator()(std::size_t row, std::size_t column) { return entries_[row * size_ + column]; }

    /// By Cholesky's factorisation, in place. A non-finite matrix is not positive.
    bool is_positive()
    {
        SymmetricMatrix& a = *this;
        for (std::size_t i = 0; i < size_; ++i)
            for (std::size_t j = 0; j <= i; ++j) {
                Real sum = a(i, j);
                for (std::size_t k = 0; k < j; ++k) sum -= a(i, k) * a(j, k);
                if (i == j && !(sum > 0)) return false;
                a(i, j) = i == j ? std::sqrt(sum) : sum / a(j, j);
            }
        return true;
    }

private:
    std::size_t size_;
    std::vector<Real> entries_;
};

/// The tube's quadratic form for one n: unknowns are the amplitudes of w, then those of v.
class GalerkinForm {
public:
    GalerkinForm(const BucklingTube& tube, int n, int terms)
        : tube_(tube), n_(n), terms_(static_cast<std::size_t>(terms)), points_(4 * terms_)
    {
        for (std::size_t i = 0; i < points_; ++i)
            for (int m = 1; m <= terms; ++m) {
                w_.push_back(radial_trial(tube.ends, m, tube.length, position(i)));
                v_.push_back(sine(m, tube.length, position(i)));
            }
    }

    /// Whether the tube is stable under this load; nothing if it has no compressed state.
    std::optional<bool> is_stable(const TransmuralPressure& load) const
    {
        SymmetricMatrix form(2 * terms_);
        for (std::size_t i = 0; i < points_; ++i) {
            const Real s = position(i) / tube_.length;
            const Real R = radius_at(tube_.law, tube_.E_b, (1 - s) * load.inlet + s * load.outlet);
            if (std::isnan(R)) return std::nullopt;
            add_point(mode_stiffness(tube_.law, tube_.E_b, R, n_), i, form);
        }
        return form.is_positive();
    }

private:
    /// The midpoint rule is exact for products of the trial functions.
    Real position(std::size_t point) const
    {
        return (static_cast<Real>(point) + 0.5) / static_cast<Real>(points_) * tube_.length;
    }

    void add_point(const ModeStiffness& k, std::size_t point, SymmetricMatrix& form) const
    {
        const Trial* w = &w_[point * terms_];
        const Trial* v = &v_[point * terms_];
        for (std::size_t a = 0; a < terms_; ++a) {
            for (std::size_t b = 0; b <= a; ++b) {
                form(a, b) += k.w_xx * w[a].d2 * w[b].d2 + k.w_x * w[a].d1 * w[b].d1 +
                              k.w * w[a].value * w[b].value;
                form(terms_ + a, terms_ + b) +=
                    k.v_x * v[a].d1 * v[b].d1 + k.v * v[a].value * v[b].value;
            }
            for (std::size_t b = 0; b < terms_; ++b)
                form(terms_ + a, b) += k.wv * v[a].value * w[b].value;
        }
    }

    BucklingTube tube_;
    int n_;
    std::size_t terms_, points_;
    std::vector<Trial> w_, v_; // [point][m]
};

TransmuralPressure operator*(Real factor, const TransmuralPressure& load)
{
    return {factor * load.inlet, factor * load.outlet};
}

} // namespace

Real ring_buckling_pressure(int n, Real E_b, Real R) { return (n * n - 1) * E_b / (R * R * R); }

Real buckling_pressure_undeformed(const BucklingTube& tube, int n)
{
    const Real q2 = (pi / tube.length) * (pi / tube.length), nn = n * n;
    const ModeStiffness k = mode_stiffness(tube.law, 0, 1, n); // at rest w = H, v_x = G_s
    const Real bending = tube.E_b * (nn - 1 + q2) * (nn - 1 + q2);
    return (bending + k.w * k.v_x * q2 / (k.v_x * q2 + k.v)) / (nn - 1);
}

Real buckling_factor(const BucklingTube& tube, int n, const TransmuralPressure& load, int terms)
{
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Real compression = -std::min(load.inlet, load.outlet);
    if (!(compression > 0)) return nan;
    const GalerkinForm form(tube, n, terms);
    Real stable = 0, unstable = 0.5 * buckling_pressure_undeformed(tube, n) / compression;
    auto is_stable = form.is_stable(unstable * load);
    while (is_stable == true) {
        stable = unstable;
        unstable *= 1.2;
        is_stable = form.is_stable(unstable * load);
    }
    if (!is_stable) return nan;
    while (unstable - stable > 1e-10 * unstable) {
        const Real middle = (stable + unstable) / 2;
        (form.is_stable(middle * load) == true ? stable : unstable) = middle;
    }
    return (stable + unstable) / 2;
}

Real buckling_pressure(const BucklingTube& tube, int n, int terms)
{
    return buckling_factor(tube, n, {-1, -1}, terms);
}

} // namespace starling
