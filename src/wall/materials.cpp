#include "wall/materials.hpp"

namespace starling {

Material make_material(const MaterialParameters& parameters, Real reynolds)
{
    const Real G_s = shear_modulus(parameters, reynolds);
    switch (parameters.law) {
    case ElasticLaw::hooke: return Hooke{G_s, parameters.poisson_ratio};
    case ElasticLaw::neo_hookean: return NeoHookean{G_s};
    case ElasticLaw::mooney_rivlin: return MooneyRivlin{G_s, parameters.psi};
    case ElasticLaw::skalak: return Skalak{G_s, parameters.skalak_C};
    }
    return Hooke{G_s, parameters.poisson_ratio};
}

} // namespace starling
