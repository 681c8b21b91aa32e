#include "wall/mesh_filter.hpp"

#include "core/for_each.hpp"

namespace starling {

MeshFilter::MeshFilter(const Tube& tube, Real rate)
    : tube_(&tube), rate_(rate), begin_{0}, a_(static_cast<Index>(tube.X.size())),
      b_(static_cast<Index>(tube.X.size()))
{
    for (VertexIndex v = tube.moving_begin(); v < tube.moving_end(); ++v) {
        const WallMesh& mesh = tube.mesh;
        // every neighbour of an inner vertex follows it in exactly one of its elements
        for (const Corner* c = mesh.corners_begin(v); c != mesh.corners_end(v); ++c)
            neighbours_.push_back(
                mesh.element(c->element)[static_cast<std::size_t>((c->corner + 1) % 3)]);
        begin_.push_back(neighbours_.size());
    }
}

/// out = (L/1.5) in at the moving vertices; zero elsewhere.
void MeshFilter::high_pass(const Array<Across>& in, Array<Across>& out) const
{
    const Index first = tube_->moving_begin();
    const Across* from = in.data();
    Across* to = out.data();
    for_range(first, tube_->moving_end(), [this, first, from, to](Index v) {
        const auto n = static_cast<std::size_t>(v - first);
        Across sum{};
        for (std::size_t m = begin_[n]; m < begin_[n + 1]; ++m) {
            const Across& neighbour = from[neighbours_[m]];
            sum = {sum.y + neighbour.y, sum.z + neighbour.z};
        }
        const Real share = 1 / static_cast<Real>(begin_[n + 1] - begin_[n]);
        to[v] = {(1 / 1.5) * (from[v].y - share * sum.y), (1 / 1.5) * (from[v].z - share * sum.z)};
    });
}

void MeshFilter::add_velocity(WallState& wall, Real dt)
{
    const Index first = tube_->moving_begin(), last = tube_->moving_end();
    const Vec3 *x = wall.x.data(), *X = tube_->X.data();
    Across* d = a_.data();
    for_range(first, last, [=](Index v) { d[v] = {x[v].y - X[v].y, x[v].z - X[v].z}; });
    high_pass(a_, b_);
    high_pass(b_, a_);
    high_pass(a_, b_);
    high_pass(b_, a_);
    const Real rate = std::min(rate_, 1 / dt);
    const Across* Hd = a_.data();
    Vec3* U = wall.velocity.data();
    for_range(first, last, [=](Index v) { U[v] -= Vec3{0, rate * Hd[v].y, rate * Hd[v].z}; });
}

} // namespace starling
