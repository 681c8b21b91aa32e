#include "output/replace_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

namespace starling {

void replace_file(const std::filesystem::path& path, const std::string& text)
{
    const std::filesystem::path temporary = path.string() + ".new";
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    stream << text;
    stream.close();
    std::error_code error;
    if (stream) std::filesystem::rename(temporary, path, error);
    if (stream && !error) return;
    const std::string reason = error ? error.message() : std::strerror(errno);
    std::filesystem::remove(temporary, error);
    throw std::runtime_error("cannot write " + path.string() + ": " + reason);
}

void write_bytes(const std::filesystem::path& path, std::span<const char> bytes, bool sync)
{
    const int file = open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0644);
    bool good = file >= 0;
    while (good && !bytes.empty()) {
        const ssize_t written = write(file, bytes.data(), bytes.size());
        good = written > 0 || (written < 0 && errno == EINTR);
        if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    good = good && (!sync || fsync(file) == 0);
    const int reason = errno;
    if (file >= 0 && close(file) == 0 && good) return;
    std::error_code none;
    if (file >= 0) std::filesystem::remove(path, none);
    throw std::runtime_error("cannot write " + path.string() + ": " +
                             std::strerror(good ? errno : reason));
}

void sync_to_disk(const std::filesystem::path& path)
{
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0 || fsync(file) != 0) {
        const int reason = errno;
        if (file >= 0) close(file);
        throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(reason));
    }
    close(file);
}

} // namespace starling
