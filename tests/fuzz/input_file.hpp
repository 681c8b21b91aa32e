#pragma once
/// The file that the fuzz targets read.
#include <cstdint>
#include <filesystem>
#include <string>
#include <unistd.h>

#include <fmt/format.h>

#include "output/replace_file.hpp"
#include "output/sealed_file.hpp"

namespace starling::fuzz {

/// A file in memory with what a fuzzer gives: its bytes as they are; or, where the first is '!',
/// the others behind a seal that fits them, so that readers behind the checksum are reached.
class InputFile {
public:
    InputFile(const std::uint8_t* data, std::size_t size, const Seal& seal)
    {
        std::string bytes(reinterpret_cast<const char*>(data), size);
        if (bytes.starts_with('!')) {
            bytes.erase(0, 1);
            bytes.insert(0, seal_of(bytes, seal));
        }
        write_bytes(path_, bytes, false);
    }
    ~InputFile() { std::filesystem::remove(path_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    static std::filesystem::path folder()
    {
        const std::filesystem::path memory = "/dev/shm";
        return std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
    }

    std::filesystem::path path_ = folder() / fmt::format("starling_fuzz_{}_000000.h5", getpid());
};

} // namespace starling::fuzz
