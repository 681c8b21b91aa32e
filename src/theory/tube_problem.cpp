#include "theory/tube_problem.hpp"

#include "wall/materials.hpp"

namespace starling {

Real small_strain_poisson_ratio(const MaterialParameters& material)
{
    if (material.law == ElasticLaw::hooke) return material.poisson_ratio;
    if (material.law == ElasticLaw::skalak) return material.skalak_C / (1 + material.skalak_C);
    return 0.5;
}

Real effective_modulus(const MaterialParameters& material, Real reynolds)
{
    return 2 * shear_modulus(material, reynolds) / (1 - small_strain_poisson_ratio(material));
}

} // namespace starling
