#include "theory/wave_speed.hpp"

#include "theory/dual.hpp"
#include "wall/materials.hpp"

namespace starling {

Real wave_speed(const MaterialParameters& material, Real reynolds, Real R)
{
    const Dual lambda2 = Dual::first(R);
    const Dual of_wall =
        std::visit([&](const auto& law) { return law.tensions(Dual(1), lambda2).tau2 / lambda2; },
                   make_material(material, reynolds));
    const Dual pressure = of_wall + Dual(material.support.stiffness) * (lambda2 - 1) / lambda2;
    return std::sqrt(R / 2 * pressure.d1);
}

} // namespace starling
