#include "output/sealed_file.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "output/crc64.hpp"

namespace starling {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& path, const std::string& reason)
{
    throw InputError(path.string() + ": " + reason);
}

std::string first_line(const std::string& kind) { return "Starling " + kind + "\n"; }

/// Size and checksum of all that follows the seal.
struct Contents {
    std::uintmax_t bytes = 0;
    std::uint64_t crc = 0;
};

Contents measure(std::istream& stream)
{
    Contents contents;
    Crc64 crc;
    std::vector<char> buffer(std::size_t{1} << 20);
    while (stream) {
        stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        const auto count = static_cast<std::size_t>(stream.gcount());
        crc.add({buffer.data(), count});
        contents.bytes += count;
    }
    contents.crc = crc.value();
    return contents;
}

std::string seal_text(const Seal& seal, const Contents& contents)
{
    std::string text =
        fmt::format("{}format_version {}\nbytes {}\ncrc64 {:016x}\n"
                    "An HDF5 file follows these 512 bytes: {}\n",
                    first_line(seal.kind), seal.version, contents.bytes, contents.crc, seal.page);
    text.resize(seal_size, '\0');
    return text;
}

/// The bytes in front of the HDF5 file, as many as are there.
std::string read_header(const fs::path& path, std::istream& stream)
{
    std::error_code error;
    std::string header(seal_size, '\0');
    stream.read(header.data(), seal_size);
    if (!stream && stream.gcount() == 0 && fs::file_size(path, error) > 0)
        refuse(path, "cannot be read");
    header.resize(static_cast<std::size_t>(stream.gcount()));
    return header;
}

} // namespace

std::string seal_of(std::span<const char> contents, const Seal& seal)
{
    Crc64 crc;
    crc.add(contents);
    return seal_text(seal, {contents.size(), crc.value()});
}

void save_sealed(const hdf5::File& file, const Seal& seal, bool sync)
{
    file.save(
        [&](std::span<char> all) {
            std::ranges::copy(seal_of(all.subspan(seal_size), seal), all.begin());
        },
        sync);
}

void check_seal(const fs::path& path, const Seal& seal)
{
    const std::string kind = seal.kind, magic = first_line(kind);
    std::error_code error;
    if (!fs::is_regular_file(path, error)) refuse(path, "no such " + kind);
    std::ifstream stream(path, std::ios::binary);
    const std::string header = read_header(path, stream);
    if (!header.starts_with(magic)) refuse(path, "is no " + kind + " of Starling");
    int version = 0;
    unsigned long long bytes = 0, crc = 0;
    const int found =
        std::sscanf(header.substr(magic.size()).c_str(), "format_version %d bytes %llu crc64 %llx",
                    &version, &bytes, &crc);
    if (found >= 1 && version > seal.version)
        refuse(path, fmt::format("has version {} of the format, this program reads up to {}: use "
                                 "the Starling that wrote it or a newer one",
                                 version, seal.version));
    if (found == 3 && version > 0 && version < seal.version)
        refuse(path,
               fmt::format("has version {} of the format, this program writes and reads {}: use "
                           "the Starling that wrote it",
                           version, seal.version));
    if (found != 3 || version != seal.version) refuse(path, "is damaged (header)");
    const Contents contents = measure(stream);
    if (contents.bytes < bytes)
        refuse(path, fmt::format("is truncated: {} of {} bytes", contents.bytes, bytes));
    if (contents.bytes != bytes || contents.crc != crc)
        refuse(path, "is damaged (its checksum does not fit)");
    if (header != seal_text(seal, contents)) refuse(path, "is damaged (header)");
}

std::string sealed_kind(const fs::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    std::string line(64, '\0');
    stream.read(line.data(), static_cast<std::streamsize>(line.size()));
    line = line.substr(0, line.find('\n'));
    const std::string start = "Starling ";
    return line.starts_with(start) ? line.substr(start.size()) : "";
}

} // namespace starling
