#pragma once
/// The shapes on which the search for intercepts and the ghost nodes are tested.
#include "unit/wall/shapes.hpp"

namespace starling::support {

/// Convex cross-sections: every node near the wall has one intercept.
inline std::vector<Shape> convex_shapes()
{
    Shape undeformed = inflated(0);
    undeformed.name = "undeformed";
    return {undeformed, inflated(0.5), inflated(1.2), lobed(1, 0.3)};
}

/// Collapsed-looking and random ones.
inline std::vector<Shape> folded_shapes()
{
    return {lobed(2, 0.6),          lobed(3, 0.6),          dumbbell(0.25),
            dumbbell(0.12),         random_smooth(1, 0.45), random_smooth(2, 0.45),
            random_smooth(3, 0.45), random_smooth(4, 0.45), random_smooth(5, 0.45)};
}

inline std::vector<Shape> all_shapes()
{
    std::vector<Shape> shapes = convex_shapes();
    for (const Shape& shape : folded_shapes()) shapes.push_back(shape);
    return shapes;
}

inline void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

inline const auto shape_name = [](const auto& shape) {
    std::string name = shape.param.name;
    std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
    return name + std::to_string(shape.index);
};

} // namespace starling::support
