#pragma once
/// Case texts for the tests: good ones, and small changes to them.
#include <string>
#include <string_view>

namespace starling::test {

/// A complete dimensionless case; line numbers are used by the tests.
inline constexpr std::string_view good_case = R"(title = "a tube"
units = "dimensionless"
[fluid]
reynolds = 0.1
theta = 1.0
[drive]
pressure_ratio = 1.5
[vessel]
length = 12.5
rigid_inlet = 1.2
rigid_outlet = 0.4
[wall]
law = "hooke"
poisson_ratio = 0.5
eps = 0.02
[grid]
width_y = 4.7
width_z = 4.7
spacing = 0.1
[coupling]
scheme = "reaction"
[time]
step = "auto"
[stop]
end_time = 1.0
[output]
sample_every = 10
)";

/// A complete SI case.
inline constexpr std::string_view good_si_case = R"(units = "si"
[fluid]
density = "1060 kg/m^3"
viscosity = "4 mPa s"
[drive]
pressure_inlet = "50 Pa"
[vessel]
radius = "0.1 mm"
length = "1.2 mm"
rigid_inlet = "0.1 mm"
rigid_outlet = "50 um"
[wall]
law = "hooke"
surface_shear_modulus = "2 mN/m"
[grid]
width_y = "0.5 mm"
width_z = "0.5 mm"
spacing = "10 um"
[stop]
end_time = "20 ms"
)";

/// The text with the first `from` replaced by `to`; `from` must occur.
inline std::string changed(std::string_view text, std::string_view from, std::string_view to)
{
    std::string out(text);
    return out.replace(out.find(from), from.size(), to);
}

} // namespace starling::test
