#include "report/rings.hpp"

#include <algorithm>

namespace starling::report {

Rings::Rings(const FrameArray& points) : points_(points)
{
    for (std::size_t v = 0; v < points.count(); ++v) {
        if (v > 0 && points.at(v, 0) == points.at(v - 1, 0)) continue;
        begin_.push_back(v);
        x_.push_back(points.at(v, 0));
    }
}

std::size_t Rings::end(std::size_t ring) const
{
    return ring + 1 < count() ? begin_[ring + 1] : points_.count();
}

std::size_t Rings::nearest(Real x) const
{
    const auto above = std::ranges::lower_bound(x_, x);
    if (above == x_.begin()) return 0;
    const auto below = above - 1;
    const bool up = above != x_.end() && *above - x < x - *below;
    return static_cast<std::size_t>((up ? above : below) - x_.begin());
}

bool Rings::contains(const Vec3& place) const
{
    if (begin_.empty()) return false;
    const std::size_t ring = nearest(place.x), first = begin_[ring], last = end(ring);
    bool inside = false;
    for (std::size_t a = first, b = last - 1; a < last; b = a++) {
        const Real ya = points_.at(a, 1), yb = points_.at(b, 1);
        const Real za = points_.at(a, 2), zb = points_.at(b, 2);
        if ((za > place.z) == (zb > place.z)) continue;
        if (place.y < ya + (yb - ya) * (place.z - za) / (zb - za)) inside = !inside;
    }
    return inside;
}

} // namespace starling::report
