#pragma once
/// Velocity nodes whose value is prescribed in the intermediate velocity.
#include <cstdint>
#include <span>

#include "grid/field.hpp"

namespace starling {

/// Prescribed nodes of one component: a mask over the grid and the list of the marked nodes in
/// memory order, plane by plane. Views: whoever builds them owns the memory.
struct PrescribedNodes {
    View<const std::uint8_t> mask;      ///< 1 where prescribed, else 0
    std::span<const Index> node;        ///< offset of each node from node (0, 0, 0), ascending
    std::span<const Real> value;        ///< prescribed u_hat
    std::span<const Index> plane_begin; ///< list entry at which plane i begins; nx + 2 entries
};

using PrescribedVelocity = std::array<PrescribedNodes, 3>;

/// The empty model: nothing is prescribed.
class NothingPrescribed {
public:
    explicit NothingPrescribed(const Grid& g) : mask_(g), plane_begin_(g.nx() + 2) {}
    PrescribedVelocity view() const
    {
        const PrescribedNodes none{mask_.view(), {}, {}, plane_begin_.span()};
        return {none, none, none};
    }

private:
    Field<std::uint8_t> mask_;
    Array<Index> plane_begin_;
};

} // namespace starling
