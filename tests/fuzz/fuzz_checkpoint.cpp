/// Anything in place of a checkpoint: what is read is whole, all else is an InputError.
#include "../unit/output/example_checkpoint.hpp"
#include "config/read_case.hpp"
#include "core/error.hpp"
#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static starling::test::ExampleCheckpoint example; // of a small grid and wall
    const starling::fuzz::InputFile input(data, size, starling::checkpoint_seal);
    try {
        const starling::CheckpointFile file(input.path());
        file.read_memory();
        file.read(example.state);
        starling::read_case_text(file.case_text(), "the checkpoint's case");
    } catch (const starling::InputError&) {
    }
    return 0;
}
