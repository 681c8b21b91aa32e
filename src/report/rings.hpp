#pragma once
/// The cross-sections of a wall frame: what is inside the tube.
#include <vector>

#include "output/frame_file.hpp"

namespace starling::report {

/// Rings of vertices, one after another along the tube; the vertices of a ring share their x.
class Rings {
public:
    explicit Rings(const FrameArray& points);

    std::size_t count() const { return begin_.size(); }
    /// Whether (y, z) lies within the ring nearest to x.
    bool contains(const Vec3& place) const;

private:
    std::size_t nearest(Real x) const;
    std::size_t end(std::size_t ring) const;

    const FrameArray& points_;
    std::vector<std::size_t> begin_; ///< first vertex of each ring
    std::vector<Real> x_;
};

} // namespace starling::report
