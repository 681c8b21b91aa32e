/// Writes the synthetic wall and fluid of the unit tests to a directory, also as exported files,
/// for tests with viewers.
#include <iostream>

#include "output/export.hpp"
#include "output/field_file.hpp"
#include "synthetic.hpp"

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::cerr << "usage: write_example_fields DIR\n";
        return 2;
    }
    using namespace starling;
    WallFile wall({argv[1], Scaling{}});
    FluidFile fluid({argv[1], Scaling{}});
    for (Index n : {0, 1, 2}) {
        wall.write(synthetic::wall(0.5 * static_cast<Real>(n), n));
        fluid.write(synthetic::fluid(0.5 * static_cast<Real>(n), n));
    }
    const std::filesystem::path directory = argv[1];
    write_vtp(directory / "wall.vtp", FrameFile(directory / "frames/wall_000001.h5").read_wall());
    write_vti(directory / "fluid.vti",
              FrameFile(directory / "frames/fluid_000002.h5").read_fluid());
}
