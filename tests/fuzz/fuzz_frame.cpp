/// Anything in place of a frame: what is read is whole, all else is an InputError.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

#include <fmt/format.h>

#include "core/error.hpp"
#include "output/frame_file.hpp"
#include "output/replace_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    namespace fs = std::filesystem;
    static const fs::path path = [] {
        const fs::path memory = "/dev/shm";
        const fs::path folder = fs::exists(memory) ? memory : fs::temp_directory_path();
        return folder / fmt::format("starling_fuzz_{}_000000.h5", getpid());
    }();
    starling::write_bytes(path, {reinterpret_cast<const char*>(data), size}, false);
    try {
        const starling::FrameFile file(path);
        for (const std::string& name : file.arrays()) file.read(name);
        file.head().of == "wall" ? (void)file.read_wall() : (void)file.read_fluid();
    } catch (const starling::InputError&) {
    }
    fs::remove(path);
    return 0;
}
