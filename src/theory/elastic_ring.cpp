#include "theory/elastic_ring.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "theory/dual.hpp"

namespace starling {

namespace {

/// Curvature, its derivative, turned angle and the integral of curvature squared along the ring.
template <class T>
using Along = std::array<T, 4>;

template <class T>
Along<T> slope(const Along<T>& y, const T& c, const T& p)
{
    const auto& [kappa, kappa_s, angle, square] = y;
    return {kappa_s, p + c * kappa - 0.5 * kappa * kappa * kappa, kappa, kappa * kappa};
}

template <class T>
Along<T> moved(const Along<T>& y, Real h, const Along<T>& k)
{
    return {y[0] + h * k[0], y[1] + h * k[1], y[2] + h * k[2], y[3] + h * k[3]};
}

/// One step of the classical Runge-Kutta method.
template <class T>
void advance(Along<T>& y, Real h, const T& c, const T& p)
{
    const auto k1 = slope(y, c, p), k2 = slope(moved(y, h / 2, k1), c, p);
    const auto k3 = slope(moved(y, h / 2, k2), c, p), k4 = slope(moved(y, h, k3), c, p);
    y = moved(moved(moved(moved(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
}

/// A point of the ring from the origin at its centre, from the balance of forces (docs/theory.md):
/// n (kappa^2/2 - c)/p + t kappa'/p with the outward normal n and the tangent t.
OutlinePoint position(const Along<Real>& y, Real c, Real p)
{
    const Real outward = (y[0] * y[0] / 2 - c) / p, along = y[1] / p;
    const Real cosine = std::cos(y[2]), sine = std::sin(y[2]);
    return {outward * cosine - along * sine, outward * sine + along * cosine};
}

constexpr int steps_per_half_lobe = 200;

/// From the tip of a lobe to the waist.
template <class T>
Along<T> half_lobe(int lobes, Real tip_curvature, const T& c, const T& p)
{
    Along<T> y{T(tip_curvature), T(0), T(0), T(0)};
    for (int step = 0; step < steps_per_half_lobe; ++step)
        advance(y, pi / lobes / steps_per_half_lobe, c, p);
    return y;
}

/// Half the width of a lobe where its sides are closest and parallel; at the waist if they are not
/// parallel again after the widest place.
Real narrowest_half_width(const ElasticRing& ring)
{
    const Real c = ring.tension, p = ring.pressure, h = pi / ring.lobes / steps_per_half_lobe;
    Along<Real> y{ring.tip_curvature, 0, 0, 0};
    bool past_widest = false;
    for (int step = 0; step < steps_per_half_lobe; ++step) {
        const Along<Real> before = y;
        advance(y, h, c, p);
        past_widest = past_widest || y[2] > pi / 2;
        if (past_widest && y[2] < pi / 2 && y[0] < 0) {
            y = before;
            advance(y, (y[2] - pi / 2) / -y[0], c, p); // one Newton step on the angle
            break;
        }
    }
    return position(y, c, p).z;
}

/// Area and distances follow from the balance of forces, docs/theory.md.
void find_shape(ElasticRing& ring)
{
    const auto y = half_lobe(ring.lobes, ring.tip_curvature, ring.tension, ring.pressure);
    const Real k0 = ring.tip_curvature, k1 = y[0];
    ring.waist_curvature = k1;
    ring.area_ratio = (ring.lobes * y[3] / pi / 2 - ring.tension) / ring.pressure;
    ring.tip_distance = (k0 * k0 / 2 - ring.tension) / ring.pressure;
    ring.waist_distance = (k1 * k1 / 2 - ring.tension) / ring.pressure;
    ring.gap = 2 * narrowest_half_width(ring);
}

/// Newton's method for tension and pressure so that the half lobe turns by pi/n and ends in a
/// symmetry line; starts from those of `ring`. False if it does not converge.
bool close_ring(ElasticRing& ring)
{
    for (int step = 0; step < 20; ++step) {
        const auto y = half_lobe(ring.lobes, ring.tip_curvature, Dual::first(ring.tension),
                                 Dual::second(ring.pressure));
        const Dual f = y[1], g = y[2] - pi / ring.lobes;
        const Real determinant = f.d1 * g.d2 - f.d2 * g.d1;
        const Real change_c = (f.d2 * g.value - g.d2 * f.value) / determinant;
        const Real change_p = (g.d1 * f.value - f.d1 * g.value) / determinant;
        if (!std::isfinite(change_c) || !std::isfinite(change_p)) return false;
        ring.tension += change_c;
        ring.pressure += change_p;
        const Real size = std::abs(ring.tension) + std::abs(ring.pressure);
        if (std::abs(change_c) + std::abs(change_p) < 1e-9 * size) {
            find_shape(ring);
            return true;
        }
    }
    return false;
}

/// Equilibria by growing tip curvature, close enough for Newton's method, from the circle to the
/// first one past contact.
class Branch {
public:
    explicit Branch(int lobes)
    {
        const Real n2 = lobes * lobes;
        const ElasticRing circle{.lobes = lobes,
                                 .pressure = n2 - 1,
                                 .gap = 2 * std::sin(pi / lobes),
                                 .tension = 1.5 - n2};
        rings_.push_back(circle);
        const Real step = 0.02 * lobes;
        while (rings_.back().gap > 0) {
            ElasticRing next = rings_.back();
            next.tip_curvature += step;
            if (!close_ring(next) || next.tip_curvature > 10 * lobes)
                throw NumericalError("the buckled ring could not be followed to contact",
                                     "fewer lobes");
            rings_.push_back(next);
        }
    }

    ElasticRing at_curvature(Real tip_curvature) const
    {
        const auto above = std::find_if(rings_.begin() + 1, rings_.end(), [&](const auto& r) {
            return r.tip_curvature >= tip_curvature;
        });
        ElasticRing ring = above == rings_.end() ? rings_.back() : *above;
        if (std::abs(tip_curvature - 1) < 1e-4) return rings_.front();
        ring.tip_curvature = tip_curvature;
        if (!close_ring(ring))
            throw NumericalError("the equation of the buckled ring could not be solved",
                                 "fewer lobes");
        return ring;
    }

    /// The ring at which `quantity`, a member that falls along the branch, has this value: false
    /// position (Illinois) between the two rings around it.
    ElasticRing where(Real ElasticRing::*quantity, Real value) const
    {
        const auto above = std::find_if(rings_.begin() + 1, rings_.end() - 1,
                                        [&](const auto& r) { return r.*quantity < value; });
        ElasticRing low = *std::prev(above), high = *above, middle = low;
        Real f_low = low.*quantity - value, f_high = high.*quantity - value;
        for (int step = 0; step < 60 && high.tip_curvature - low.tip_curvature > 1e-12; ++step) {
            middle = at_curvature((low.tip_curvature * f_high - high.tip_curvature * f_low) /
                                  (f_high - f_low));
            const Real f = middle.*quantity - value;
            if (std::abs(f) < 1e-12) break;
            (f > 0 ? low : high) = middle;
            (f > 0 ? f_high : f_low) /= 2;
            (f > 0 ? f_low : f_high) = f;
        }
        return middle;
    }

    ElasticRing contact() const { return where(&ElasticRing::gap, 0); }

private:
    std::vector<ElasticRing> rings_;
};

} // namespace

std::vector<ElasticRing> tube_law(int lobes, int count)
{
    const Branch branch(lobes);
    const Real last = branch.contact().tip_curvature;
    std::vector<ElasticRing> rings;
    for (int i = 0; i < count; ++i)
        rings.push_back(branch.at_curvature(1 + (last - 1) * i / (count - 1)));
    return rings;
}

ElasticRing ring_at_contact(int lobes) { return Branch(lobes).contact(); }

std::vector<ElasticRing> rings_at_areas(int lobes, const std::vector<Real>& area_ratios)
{
    const Branch branch(lobes);
    std::vector<ElasticRing> rings;
    for (const Real area : area_ratios)
        rings.push_back(branch.where(&ElasticRing::area_ratio, area));
    return rings;
}

std::vector<OutlinePoint> outline(const ElasticRing& ring, int count)
{
    constexpr int steps_per_point = 20;
    const Real h = 2 * pi / count / steps_per_point;
    Along<Real> y{ring.tip_curvature, 0, 0, 0};
    std::vector<OutlinePoint> points;
    for (int i = 0; i < count; ++i) {
        points.push_back(position(y, ring.tension, ring.pressure));
        for (int step = 0; step < steps_per_point; ++step)
            advance(y, h, ring.tension, ring.pressure);
    }
    return points;
}

} // namespace starling
