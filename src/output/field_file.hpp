#pragma once
/// Wall and fluid over time for ParaView: NAME.h5 with the numbers, NAME.xdmf with their meaning.
///
/// Each frame is a sealed file of its own, frames/NAME_NNNNNN.h5 with the attributes `t` and
/// `step`; NAME.h5 shows it as the group /frames/NNNNNN (an external link). Every file is written
/// beside its place and renamed, NAME.xdmf last: no frame is ever touched again, so a kill harms
/// none, and a viewer may look while the run goes on.
#include <filesystem>
#include <string>

#include "output/hdf5_file.hpp"
#include "output/sealed_file.hpp"
#include "output/xdmf.hpp"
#include "solver/monitor_data.hpp"

namespace starling {

/// Of NAME.h5. Version 3: each frame has a seal.
inline constexpr Seal index_seal = {"index", 3, "docs/results.md"};

/// Of a frame of the "wall" or "fluid", in the run directory: "frames/wall_000000.h5".
std::string frame_name(const std::string& name, Index frame);

/// Where and how field files are written.
struct FieldFileOptions {
    std::filesystem::path directory;
    Scaling scaling; ///< numbers are written in the case's units, named in attributes
    hdf5::Precision precision = hdf5::Precision::single;
    Index keep = 0;          ///< frames of an earlier run to go on from; later ones are removed
    std::string prefix = ""; ///< of the names of the files: "breakdown_"
};

/// What both field files share: the pair of files, frame groups, arrays in the case's units.
class FrameWriter {
public:
    /// Makes NAME.xdmf anew from the frames where it does not list all that are to be kept; throws
    /// InputError where these cannot be read.
    FrameWriter(FieldFileOptions options, std::string what);
    /// Whether NAME.xdmf lists all frames that are to be kept. Throws as the constructor does, and
    /// changes nothing.
    static bool lists_frames(const FieldFileOptions& options, const std::string& what);

    /// Writes the arrays of a new frame to an open file and describes them in XDMF.
    struct Frame {
        hdf5::File file;
        std::string name; ///< "frames/wall_000000.h5"
        std::string xdmf;
    };
    Frame begin(Real t, Index step);
    /// `values` are in solver units and already in the order of the file.
    xdmf::Array write(Frame& frame, const std::string& name, const std::vector<hsize_t>& shape,
                      std::vector<Real> values, Quantity quantity);
    /// Completes the frame on disk.
    void end(Frame frame, Real t);

    const Scaling& scaling() const { return options_.scaling; }
    const std::string& name() const { return name_; }
    Index frames() const { return frames_; }
    /// Waits until the frames written so far are on the disk itself.
    void sync();

private:
    void write_index(Index frames) const;
    void remove_later_frames() const;

    FieldFileOptions options_;
    std::string what_; ///< "wall" or "fluid"
    std::string name_; ///< that with the prefix
    xdmf::Series series_;
    Index frames_ = 0;
    Index synced_ = 0; ///< frames that are on the disk itself
};

/// wall.h5 and wall.xdmf: a triangle mesh with moving points.
class WallFile {
public:
    explicit WallFile(FieldFileOptions options) : writer_(std::move(options), "wall") {}
    /// Appends a frame; throws std::runtime_error where it cannot be written.
    void write(const WallSnapshot& snapshot);
    Index frames() const { return writer_.frames(); }
    void sync() { writer_.sync(); } ///< see FrameWriter

private:
    FrameWriter writer_;
};

/// fluid.h5 and fluid.xdmf: cell values on a uniform grid. ParaView wants x fastest, so arrays
/// stand in the file as [z][y][x], the transpose of what the solver holds.
class FluidFile {
public:
    explicit FluidFile(FieldFileOptions options) : writer_(std::move(options), "fluid") {}
    /// Appends a frame; throws std::runtime_error where it cannot be written.
    void write(const FluidSnapshot& snapshot);
    Index frames() const { return writer_.frames(); }
    void sync() { writer_.sync(); } ///< see FrameWriter

private:
    FrameWriter writer_;
};

} // namespace starling
