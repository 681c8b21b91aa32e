#include "wall/high_pass.hpp"

#include "core/for_each.hpp"

namespace starling {

namespace {

std::vector<VertexIndex> neighbours_of(const WallMesh& mesh, VertexIndex v)
{
    std::vector<VertexIndex> found;
    // an inner vertex is followed by every neighbour in exactly one of its elements; on the edge of
    // the mesh one neighbour only goes before it
    for (int after : {1, 2})
        for (const Corner* c = mesh.corners_begin(v); c != mesh.corners_end(v); ++c) {
            const auto corner = static_cast<std::size_t>((c->corner + after) % 3);
            const VertexIndex m = mesh.element(c->element)[corner];
            if (std::find(found.begin(), found.end(), m) == found.end()) found.push_back(m);
        }
    return found;
}

} // namespace

HighPass::HighPass(const WallMesh& mesh, VertexIndex first, VertexIndex last, Beyond beyond)
    : first_(first), begin_{0}, values_(last - first), other_(last - first)
{
    for (VertexIndex v = first; v < last; ++v) {
        const std::vector<VertexIndex> around = neighbours_of(mesh, v);
        for (VertexIndex m : around)
            if (m >= first && m < last) neighbours_.push_back(m - first);
        const std::size_t in_range = neighbours_.size() - begin_.back();
        begin_.push_back(neighbours_.size());
        share_.push_back(1 /
                         static_cast<Real>(beyond == Beyond::as_zero ? around.size() : in_range));
    }
}

void HighPass::apply_once(const Array<Across>& from_values, Array<Across>& to_values) const
{
    const Across* from = from_values.data();
    Across* to = to_values.data();
    for_range(0, from_values.size(), [this, from, to](Index v) {
        const auto n = static_cast<std::size_t>(v);
        Across sum{};
        for (std::size_t m = begin_[n]; m < begin_[n + 1]; ++m) {
            const Across& neighbour = from[neighbours_[m]];
            sum = {sum.y + neighbour.y, sum.z + neighbour.z};
        }
        to[v] = {(1 / 1.5) * (from[v].y - share_[n] * sum.y),
                 (1 / 1.5) * (from[v].z - share_[n] * sum.z)};
    });
}

void HighPass::apply()
{
    for (int twice = 0; twice < 2; ++twice) {
        apply_once(values_, other_);
        apply_once(other_, values_);
    }
}

} // namespace starling
