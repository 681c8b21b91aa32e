/// Writes the synthetic wall and fluid of the unit tests to a directory, for tests with viewers.
#include <iostream>

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
}
