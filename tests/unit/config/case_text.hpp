#pragma once
/// Case texts for the tests: good ones, and small changes to them.
#include <algorithm>
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

/// A changed case and the line that matters.
struct ChangedText {
    std::string text;
    int line;
};

inline int line_at(std::string_view text, std::size_t position)
{
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + position, '\n'));
}

/// Begin and end of the part of a text between the header of a section and the next one, and
/// where the line of the key begins in it, or the end.
struct KeyPlace {
    std::size_t begin, end, key;
};

inline KeyPlace find_key_line(std::string_view text, std::string_view dotted)
{
    const auto dot = dotted.find('.');
    const bool top = dot == std::string_view::npos;
    const std::string header = top ? "" : "\n[" + std::string(dotted.substr(0, dot)) + "]\n";
    const std::string key = "\n" + std::string(dotted.substr(top ? 0 : dot + 1)) + " = ";
    const std::size_t begin = top ? 0 : text.find(header) + header.size();
    const std::size_t end = std::min(text.find("\n[", begin), text.size() - 1) + 1;
    if (text.substr(begin, key.size() - 1) == key.substr(1)) return {begin, end, begin};
    const std::size_t at = text.substr(0, end).find(key, begin == 0 ? 0 : begin - 1);
    return {begin, end, at == std::string_view::npos ? end : at + 1};
}

/// The text with another value of "section.key", in its line or in a new one, and that line.
inline ChangedText with_value(std::string_view text, std::string_view dotted,
                              std::string_view value)
{
    const KeyPlace place = find_key_line(text, dotted);
    const std::string line =
        std::string(dotted.substr(dotted.rfind('.') + 1)) + " = " + std::string(value) + "\n";
    const std::size_t old = place.key == place.end ? 0 : text.find('\n', place.key) + 1 - place.key;
    return {std::string(text).replace(place.key, old, line), line_at(text, place.key)};
}

/// The text without "section.key", and the line of its section.
inline ChangedText without(std::string_view text, std::string_view dotted)
{
    const KeyPlace place = find_key_line(text, dotted);
    const std::size_t length = text.find('\n', place.key) + 1 - place.key;
    return {std::string(text).erase(place.key, length), line_at(text, place.begin) - 1};
}

} // namespace starling::test
