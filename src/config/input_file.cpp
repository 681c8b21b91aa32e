#include "config/input_file.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace starling {

std::string input_text(const std::filesystem::path& file)
{
    const auto fail = [](const char* what) { throw std::invalid_argument(what); };
    constexpr std::uintmax_t largest = 1 << 20;
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) fail("no such file");
    if (std::filesystem::is_directory(status)) fail("is a directory, not a file");
    if (!std::filesystem::is_regular_file(status)) fail("is not a regular file");
    if (std::filesystem::file_size(file, error) > largest || error)
        fail("is too large (1 MiB at most)");
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
    if (!stream) fail("cannot be read");
    return text.str();
}

} // namespace starling
