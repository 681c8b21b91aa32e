#pragma once
/// A small state with a different number in every place, a sound one before it, and their
/// checkpoint.
#include "output/checkpoint.hpp"

namespace starling::test {

struct ExampleCheckpoint {
    Grid grid{{4, 3, 2}, {0, -1, -1}, {4, 2, 2}};
    Tube tube = make_tube({.length = 4, .rigid_inlet = 1, .rigid_outlet = 1}, 0.8);
    State state{grid, tube}, sound{grid, tube};
    RunMemory memory, sound_memory;

    ExampleCheckpoint()
    {
        fill(sound, 40, 1000.1);
        fill(state, 42, 0.1);
        sound_memory.window.resize(1);
        sound_memory.window[0].Q_in = 0.6;
        sound_memory.last_row = 30;
        sound_memory.wall_frames = 1;
        sound_memory.step_factor = 0.5;
        memory.window.resize(3);
        memory.window[1].Q_in = 0.7;
        memory.window[2].step = 41;
        memory.last_row = 40;
        memory.wall_frames = 2;
        memory.next_wall = 0.5;
        memory.wall_seconds = 12.5;
        memory.phase_seconds = {3, 4.5};
        memory.step_factor = 0.5;
        memory.cycles.period = 0.1;
        memory.cycles.per_cycle = 3;
        memory.cycles.next = 14;
        memory.cycles.cycles = 4;
        memory.cycles.change = 0.01;
        memory.cycles.last.resize(3);
        memory.cycles.last[2].P_out = 0.9;
        memory.cycles.shear_last.add(std::vector<Vec3>{{1, 2, 2}, {0, 0.5, 0}});
        memory.cycles.current.resize(1);
        memory.cycles.current[0].step = 42;
    }
    RunRecord record(const std::string& case_text) const
    {
        return {{state, memory}, {sound, sound_memory}, case_text};
    }
    std::filesystem::path write(const std::filesystem::path& directory) const
    {
        return write_checkpoint(directory, record("[fluid]\nreynolds = 1\n"));
    }

private:
    static void fill(State& state, Index step, Real next)
    {
        const auto fill_field = [&](ScalarField& f) {
            for (Real& v : f.values()) v = next += 0.1;
        };
        for (auto& f : state.fluid.u.component) fill_field(f);
        for (auto& f : state.fluid.N_before.component) fill_field(f);
        fill_field(state.fluid.P);
        state.fluid.ends.inside = {1.5, 2.5};
        state.fluid.ends.stored = 3.5;
        for (auto& values : state.fluid.ends.pressure)
            for (Real& p : values) p = next += 0.1;
        state.fluid.dt_before = 0.01;
        state.fluid.kinetic_energy = 4.5;
        state.fluid.kinetic_energy_before = 5.5;
        for (Vec3& v : state.wall.velocity) v = {next += 0.1, -next, 1 / next};
        for (Vec3& f : state.wall.support) f = {0, next += 0.1, -2 * next};
        for (Vec3& r : state.wall.support_rate) r = {0, -next, next += 0.1};
        for (Vec3& u : state.wall.passing) u = {0, 3 * next, next += 0.1};
        for (GhostState& g : state.ghosts) {
            g.inside.values()[7] = 1;
            g.near_wall.push_back({1, 2, 0, false, {5, {next, 2, 3}, 0.25, true}});
            g.near_wall.push_back({2, 2, 1, false, {6, {1, next, 3}, 0.5, false}});
        }
        state.t = 1 / 3.;
        state.step = step;
        state.dt = 0.02;
    }
};

} // namespace starling::test
