#include "wall/cross_section.hpp"

namespace starling {

CrossSection::CrossSection(const Tube& tube)
    : tube_(&tube), points_(static_cast<std::size_t>(2 * tube.ring_size))
{
    crossings_.reserve(points_.size());
}

// The edges between rings r and r + 1 in the order of the elements (see make_tube): position t to
// t + shift, position t + 1 to t + shift, position t + 1 to t + 1 + shift, ...
void CrossSection::cut(const Array<Vec3>& x, Real plane_x)
{
    const std::vector<Real>& ring_x = tube_->ring_x;
    const auto after = std::upper_bound(ring_x.begin() + 1, ring_x.end() - 1, plane_x);
    const Index ring = (after - ring_x.begin()) - 1;
    const Real x0 = *(after - 1), x1 = *after;
    const Real s = std::clamp((plane_x - x0) / (x1 - x0), 0., 1.);

    const VertexIndex n = tube_->ring_size, shift = static_cast<VertexIndex>(ring % 2);
    const VertexIndex here = tube_->first(ring), next = here + n;
    for (VertexIndex m = 0; m < 2 * n; ++m) {
        const Vec3& a = x[here + (m / 2 + m % 2) % n];
        const Vec3& c = x[next + (m / 2 + shift) % n];
        points_[static_cast<std::size_t>(m)] = {a.y + s * (c.y - a.y), a.z + s * (c.z - a.z)};
    }
    first_element_ = 2 * here;
}

Real CrossSection::area() const
{
    Real twice = 0;
    for (std::size_t m = 0; m < points_.size(); ++m) {
        const Point2 &a = points_[m], &b = points_[(m + 1) % points_.size()];
        twice += a.y * b.z - a.z * b.y;
    }
    return twice / 2;
}

const std::vector<Real>& CrossSection::crossings(Real y)
{
    crossings_.clear();
    for (std::size_t m = 0; m < points_.size(); ++m) {
        const Point2 &a = points_[m], &b = points_[(m + 1) % points_.size()];
        if ((a.y <= y) == (b.y <= y)) continue;
        const Real z = a.z + (y - a.y) / (b.y - a.y) * (b.z - a.z);
        if (!std::isfinite(z)) { // has no place in an order
            crossings_.clear();
            return crossings_;
        }
        crossings_.push_back(z);
    }
    std::sort(crossings_.begin(), crossings_.end());
    return crossings_;
}

} // namespace starling
