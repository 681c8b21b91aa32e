#pragma once
/// Prescribed nodes for tests: owns what PrescribedVelocity views.
#include <vector>

#include "flow/prescribed.hpp"
#include "unit/grid/random_fields.hpp"

namespace starling::support {

/// About `share` of the unknowns of every component, with random values.
class RandomPrescribed {
public:
    RandomPrescribed(const Grid& g, Real share, Random& random)
    {
        for (Location c : components) {
            Part& p = part_[static_cast<std::size_t>(axis(c))];
            p.mask = Field<std::uint8_t>(g);
            const Box box = g.unknowns(c);
            for (Index i = 0; i < g.nx() + 2; ++i) {
                p.plane_begin.push_back(static_cast<Index>(p.node.size()));
                if (i >= box.end[0]) continue;
                const Box plane{{i, box.begin[1], 0}, {i + 1, box.end[1], box.end[2]}};
                visit(plane, [&](Index, Index j, Index k) {
                    if ((1 + random()) / 2 >= share) return;
                    p.mask(i, j, k) = 1;
                    p.node.push_back(p.mask.view().offset(i, j, k));
                    p.value.push_back(random());
                });
            }
        }
    }
    PrescribedVelocity view() const
    {
        const auto nodes = [](const Part& p) {
            return PrescribedNodes{p.mask.view(), p.node, p.value, p.plane_begin};
        };
        return {nodes(part_[0]), nodes(part_[1]), nodes(part_[2])};
    }

private:
    struct Part {
        Field<std::uint8_t> mask;
        std::vector<Index> node, plane_begin;
        std::vector<Real> value;
    };
    std::array<Part, 3> part_;
};

} // namespace starling::support
