#include "bench/stepped_problem.hpp"

#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <malloc.h>

#include "core/error.hpp"
#include "simulation/simulation.hpp"
#include "solver/advance.hpp"

namespace starling::bench {

namespace {

constexpr Index fewest_cells = 16, most_cells = 100'000; ///< along one direction
constexpr Index fewest_vertices = 200, most_vertices = 10'000'000;
constexpr Real width = 4.7; ///< of the box (R_0)
constexpr Real least_length = 3;

/// A number that fills all of the text; none otherwise.
std::optional<Index> whole_number(std::string_view text)
{
    Index value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

Real length(const Problem& p)
{
    return width * static_cast<Real>(p.cells[0]) / static_cast<Real>(p.cells[1]);
}

/// Inflation, with cubic cells if y and z have as many.
Case case_of(const Problem& p)
{
    Case c;
    c.grid.width_y = c.grid.width_z = width;
    c.grid.cells = p.cells;
    c.tube.length = length(p);
    c.material.bending = 0.01;
    c.drive.pressure_inlet = c.baseline_pressure_drop();
    const Real delta = make_grid(c.grid, c.tube.length).delta();
    // Equilateral triangles: rings sqrt(3)/2 edges apart.
    if (p.vertices > 0)
        c.tube.edge_over_spacing =
            std::sqrt(2 * pi * c.tube.length / (std::sqrt(0.75) * static_cast<Real>(p.vertices))) /
            delta;
    return c;
}

Real time_step(const Case& c, Real delta)
{
    return smallest(time_step_limits(c, delta, c.pressure_ratio())).dt;
}

class FluidSteps : public SteppedProblem {
public:
    explicit FluidSteps(const Problem& p)
        : case_(case_of(p)), grid_(make_grid(case_.grid, case_.tube.length)), state_(grid_),
          F_(grid_), nothing_(grid_), momentum_(grid_, case_.fluid),
          projection_(grid_, case_.fluid, case_.drive), dt_(time_step(case_, grid_.delta()))
    {
        projection_.initialise_pressure(state_);
    }
    void step() override
    {
        timer_.start();
        momentum_.predict(state_, F_, nothing_.view(), dt_);
        timer_.mark(0);
        projection_.project(state_, t_, dt_);
        timer_.mark(1);
        t_ += dt_;
    }
    bool sound() const override { return std::isfinite(state_.kinetic_energy); }
    const PhaseTimer& timer() const override { return timer_; }
    Index vertices() const override { return 0; }

private:
    Case case_;
    Grid grid_;
    FluidState state_;
    VectorField F_;
    NothingPrescribed nothing_;
    Momentum momentum_;
    Projection projection_;
    Real t_ = 0, dt_;
    PhaseTimer timer_{{"momentum", "pressure"}};
};

class CoupledSteps : public SteppedProblem {
public:
    explicit CoupledSteps(const Problem& p)
        : case_(case_of(p)), grid_(make_grid(case_.grid, case_.tube.length)),
          tube_(make_tube(case_.tube, case_.tube.edge_over_spacing * grid_.delta())),
          op_(grid_, tube_, wall_model(case_, grid_.delta()), case_.fluid, case_.drive,
              case_.coupling.scheme),
          workspace_(grid_, tube_), state_(grid_, tube_), dt_(time_step(case_, grid_.delta()))
    {
        initialise(state_, op_);
    }
    void step() override
    {
        if (advance(state_, op_, workspace_, dt_)) return;
        throw NumericalError("the wall was lost", "take another grid or wall");
    }
    bool sound() const override { return std::isfinite(state_.fluid.kinetic_energy); }
    const PhaseTimer& timer() const override { return workspace_.timer; }
    Index vertices() const override { return tube_.mesh.vertex_count(); }

private:
    Case case_;
    Grid grid_;
    Tube tube_;
    Operators op_;
    Workspace workspace_;
    State state_;
    Real dt_;
};

/// Bytes that malloc has given to the program.
Index allocated_bytes()
{
    const auto info = mallinfo2();
    return static_cast<Index>(info.uordblks + info.hblkhd);
}

/// Builds Steps and finds how much memory that took.
template <class Steps>
BuiltProblem build_and_weigh(const Problem& p)
{
    const Index before = allocated_bytes();
    BuiltProblem built{std::make_unique<Steps>(p), {}};
    built.footprint.bytes = allocated_bytes() - before;
    return built;
}

/// Vertices and bytes of the same problem with a quarter of the vertices; nothing of it remains.
std::pair<double, double> coarse_wall(const Problem& p)
{
    const BuiltProblem built = build_and_weigh<CoupledSteps>({p.cells, p.vertices / 4});
    return {static_cast<double>(built.steps->vertices()),
            static_cast<double>(built.footprint.bytes)};
}

} // namespace

std::array<Index, 3> parse_grid(const std::string& text)
{
    std::array<Index, 3> cells{};
    std::string_view rest = text;
    for (std::size_t d = 0; d < 3; ++d) {
        const std::size_t end = d == 2 ? rest.size() : std::min(rest.find('x'), rest.size());
        const auto n = whole_number(rest.substr(0, end));
        if (!n || *n < fewest_cells || *n > most_cells)
            throw InputError(fmt::format("--grid \"{}\": give NXxNYxNZ, each from {} to {}", text,
                                         fewest_cells, most_cells));
        cells[d] = *n;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (length({cells}) < least_length)
        throw InputError(fmt::format("--grid \"{}\": too short for a tube: NX must be at least "
                                     "{:.3g} NY",
                                     text, least_length / width));
    return cells;
}

Index parse_wall(const std::string& text)
{
    if (text == "none") return 0;
    const bool thousands = text.ends_with('k');
    const auto n = whole_number(std::string_view(text).substr(0, text.size() - thousands));
    const Index vertices = n && *n <= most_vertices ? *n * (thousands ? 1000 : 1) : 0;
    if (vertices < fewest_vertices || vertices > most_vertices)
        throw InputError(fmt::format("--wall \"{}\": give \"none\" or a number of vertices from {} "
                                     "to {}, such as 17k",
                                     text, fewest_vertices, most_vertices));
    return vertices;
}

std::string grid_text(const std::array<Index, 3>& cells)
{
    return fmt::format("{}x{}x{}", cells[0], cells[1], cells[2]);
}

std::string wall_text(Index vertices)
{
    if (vertices == 0) return "none";
    return vertices % 1000 == 0 ? fmt::format("{}k", vertices / 1000) : fmt::format("{}", vertices);
}

BuiltProblem build(const Problem& p)
{
    const auto cells = static_cast<double>(p.cell_count());
    if (p.vertices == 0) {
        BuiltProblem built = build_and_weigh<FluidSteps>(p);
        built.footprint.bytes_per_cell = static_cast<double>(built.footprint.bytes) / cells;
        return built;
    }
    const auto [fewer_vertices, fewer_bytes] = coarse_wall(p);
    BuiltProblem built = build_and_weigh<CoupledSteps>(p);
    Footprint& f = built.footprint;
    const auto vertices = static_cast<double>(built.steps->vertices());
    f.bytes_per_vertex = (static_cast<double>(f.bytes) - fewer_bytes) / (vertices - fewer_vertices);
    f.bytes_per_cell = (static_cast<double>(f.bytes) - f.bytes_per_vertex * vertices) / cells;
    return built;
}

double expected_bytes(const Problem& p)
{
    constexpr double of_program = 30e6, per_cell = 130, per_cell_beside_wall = 190,
                     per_vertex = 1250;
    return of_program +
           (p.vertices == 0 ? per_cell : per_cell_beside_wall) *
               static_cast<double>(p.cell_count()) +
           per_vertex * static_cast<double>(p.vertices);
}

} // namespace starling::bench
