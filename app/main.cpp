/// The command line of Starling. Exit codes: 0 done, 2 bad input, 3 the computation broke down,
/// 1 anything else.
#include <cstdio>
#include <exception>
#include <new>

#include <fmt/format.h>

#include "command_line.hpp"
#include "commands.hpp"
#include "core/error.hpp"
#include "environment.hpp"

namespace {

int report(int exit_code, const char* what)
{
    std::fflush(stdout);
    fmt::print(stderr, "starling: {}\n", what);
    return exit_code;
}

} // namespace

int main(int argc, char** argv)
{
    using namespace starling;
    app::wait_briefly(argv);
    try {
        const app::CommandLine line = app::parse(argc, argv);
        app::execute(line);
        return 0;
    } catch (const app::Done&) {
        return 0;
    } catch (const InputError& e) {
        return report(2, e.what());
    } catch (const NumericalError& e) {
        return report(3, e.what());
    } catch (const std::bad_alloc&) {
        return report(1,
                      "not enough memory: the system gave no more of it\n"
                      "  try: a coarser grid, or a higher limit (ulimit -v); starling check CASE "
                      "tells how much a case needs");
    } catch (const std::exception& e) {
        return report(1, e.what());
    }
}
