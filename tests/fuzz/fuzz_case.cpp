/// Anything in place of a case file: a case or an InputError with problems, nothing else.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "config/read_case.hpp"
#include "core/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        const starling::Case c =
            starling::read_case_text({reinterpret_cast<const char*>(data), size}, "fuzz");
        const std::string text = starling::write_case(c); // what is written can be read
        starling::read_case_text(text, "as written");
    } catch (const starling::InputError& e) {
        if (e.problems().empty() || e.problems().front().file == "as written") std::abort();
    }
    return 0;
}
