#pragma once
/// Frames of wall and fluid, read back: in the units in which they stand in the file.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "output/sealed_file.hpp"

namespace starling {

inline constexpr Seal frame_seal = {"frame", 1, "docs/results.md"};

/// An array of a frame, `components` per vertex, element or cell, interleaved.
struct FrameArray {
    std::string name, unit;
    std::vector<std::size_t> shape; ///< as in the file, without the components of a vector
    int components = 1;
    std::vector<Real> values;

    std::size_t count() const { return values.size() / static_cast<std::size_t>(components); }
    Real at(std::size_t n, int c) const
    {
        return values[n * static_cast<std::size_t>(components) + static_cast<std::size_t>(c)];
    }
};

/// What a frame says about itself.
struct FrameHead {
    std::string of; ///< "wall" or "fluid"
    Real t = 0;
    Index step = 0;
    std::string unit_of_t;
};

/// A wall: points, triangles, arrays on vertices or elements.
struct WallFrame {
    FrameHead head;
    FrameArray points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<FrameArray> at_vertex, at_element;
};

/// An array of the elements as means over those around each vertex; NaN where there is none.
FrameArray at_vertices(const FrameArray& a, const WallFrame& frame);

/// A fluid: a uniform grid and arrays in its cells, x fastest.
struct FluidFrame {
    FrameHead head;
    std::array<std::size_t, 3> cells{}; ///< nx, ny, nz
    Vec3 origin, spacing;
    std::string unit_of_length;
    std::vector<FrameArray> at_cell;
};

/// The file of a frame, found whole.
class FrameFile {
public:
    /// Throws InputError, with the reason, for a file that is missing, foreign or damaged.
    explicit FrameFile(std::filesystem::path path);

    const FrameHead& head() const { return head_; }
    /// Names of the arrays.
    std::vector<std::string> arrays() const;
    /// One of them; throws InputError where it is none.
    FrameArray read(const std::string& name) const;
    /// The whole frame; throws InputError where it is of the other kind or does not fit together.
    /// Triangles stand in the first frame beside this one.
    WallFrame read_wall() const;
    FluidFrame read_fluid() const;

private:
    std::vector<std::array<std::int32_t, 3>> read_triangles(std::size_t vertices) const;
    void check_is_of(const std::string& what) const;

    std::filesystem::path path_;
    FrameHead head_;
};

/// A frame of a run as it is listed: its head, or what is wrong with it.
struct ListedFrame {
    std::filesystem::path path;
    FrameHead head;
    std::string problem; ///< empty: whole
};

/// The frames of the wall or the fluid in a run directory, in order; each is checked.
std::vector<ListedFrame> list_frames(const std::filesystem::path& run_directory,
                                     const std::string& of);

} // namespace starling
