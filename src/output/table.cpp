#include "output/table.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "core/error.hpp"

namespace starling {

LineFile::LineFile(std::filesystem::path path, std::optional<std::uintmax_t> keep)
    : path_(std::move(path)), length_(keep.value_or(0))
{
    errno = 0;
    if (keep) std::filesystem::resize_file(path_, *keep);
    stream_.open(path_, keep ? std::ios::app : std::ios::trunc);
    if (!stream_)
        throw std::runtime_error("cannot create " + path_.string() + ": " + std::strerror(errno));
}

namespace {

std::string entry(const std::string& line, std::ptrdiff_t column)
{
    std::size_t begin = 0;
    for (; column > 0 && begin != std::string::npos; --column) {
        begin = line.find(',', begin);
        if (begin != std::string::npos) ++begin;
    }
    if (begin == std::string::npos) return "";
    return line.substr(begin, line.find(',', begin) - begin);
}

} // namespace

std::uintmax_t length_up_to(const std::filesystem::path& path, const std::string& header,
                            std::ptrdiff_t column, Index last)
{
    std::ifstream stream(path, std::ios::binary);
    std::string line;
    if (!std::getline(stream, line) || line != header)
        throw InputError(path.string() + ": is missing or has other columns than this run");
    std::uintmax_t length = line.size() + 1;
    while (std::getline(stream, line) && !stream.eof()) {
        length += line.size() + 1;
        if (entry(line, column) == std::to_string(last)) return length;
    }
    throw InputError(path.string() + ": ends before the checkpoint (no row of step " +
                     std::to_string(last) + ")");
}

void LineFile::write(const std::string& line)
{
    errno = 0;
    stream_ << line << '\n';
    stream_.flush();
    if (stream_) {
        length_ += line.size() + 1;
        return;
    }
    const std::string reason = std::strerror(errno);
    std::error_code none;
    stream_.close(); // with what it still holds
    std::filesystem::resize_file(path_, length_, none);
    stream_.clear(); // to be tried again
    stream_.open(path_, std::ios::app);
    throw std::runtime_error("cannot write to " + path_.string() + ": " + reason);
}

std::string column_title(const char* name, Quantity quantity, const Scaling& scaling)
{
    return fmt::format("{} [{}]", name, scaling.unit(quantity));
}

std::string number_text(Real value) { return fmt::format("{}", value); }

} // namespace starling
