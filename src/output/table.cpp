#include "output/table.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

namespace starling {

LineFile::LineFile(std::filesystem::path path) : path_(std::move(path)), stream_(path_)
{
    if (!stream_)
        throw std::runtime_error("cannot create " + path_.string() + ": " + std::strerror(errno));
}

void LineFile::write(const std::string& line)
{
    errno = 0;
    stream_ << line << '\n';
    stream_.flush();
    if (!stream_)
        throw std::runtime_error("cannot write to " + path_.string() + ": " + std::strerror(errno));
}

std::string column_title(const char* name, Quantity quantity, const Scaling& scaling)
{
    return fmt::format("{} [{}]", name, scaling.unit(quantity));
}

std::string number_text(Real value) { return fmt::format("{}", value); }

} // namespace starling
