/// Anything in place of a frame: what is read is whole, all else is an InputError.
#include "core/error.hpp"
#include "input_file.hpp"
#include "output/frame_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const starling::fuzz::InputFile input(data, size, starling::frame_seal);
    try {
        const starling::FrameFile file(input.path());
        for (const std::string& name : file.arrays()) file.read(name);
        file.head().of == "wall" ? (void)file.read_wall() : (void)file.read_fluid();
    } catch (const starling::InputError&) {
    }
    return 0;
}
