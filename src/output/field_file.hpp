#pragma once
/// Wall and fluid over time for ParaView: NAME.h5 with the numbers, NAME.xdmf with their meaning.
///
/// Each frame is the group /frames/NNNNNN with the attributes `t` and `step`. The file is opened,
/// extended, flushed and closed once per frame, and the XDMF file replaced after that: what was
/// written before a kill stays readable, and a viewer may look while the run goes on.
#include <filesystem>
#include <string>

#include "output/hdf5_file.hpp"
#include "output/xdmf.hpp"
#include "solver/monitor_data.hpp"

namespace starling {

/// Where and how field files are written.
struct FieldFileOptions {
    std::filesystem::path directory;
    Scaling scaling; ///< numbers are written in the case's units, named in attributes
    hdf5::Precision precision = hdf5::Precision::single;
};

/// What both field files share: the pair of files, frame groups, arrays in the case's units.
class FrameWriter {
public:
    FrameWriter(FieldFileOptions options, std::string name);

    /// Writes the arrays of a new frame to an open file and describes them in XDMF.
    struct Frame {
        hdf5::File file;
        std::string group;
        std::string xdmf;
    };
    Frame begin(Real t, Index step);
    /// `values` are in solver units and already in the order of the file.
    xdmf::Array write(Frame& frame, const std::string& name, const std::vector<hsize_t>& shape,
                      std::vector<Real> values, Quantity quantity);
    /// Completes the frame on disk.
    void end(Frame& frame, Real t);

    const Scaling& scaling() const { return options_.scaling; }
    std::string location(const std::string& path) const;
    Index frames() const { return frames_; }

private:
    FieldFileOptions options_;
    std::string name_;
    xdmf::Series series_;
    Index frames_ = 0;
};

/// wall.h5 and wall.xdmf: a triangle mesh with moving points.
class WallFile {
public:
    explicit WallFile(FieldFileOptions options) : writer_(std::move(options), "wall") {}
    /// Appends a frame; throws std::runtime_error where it cannot be written.
    void write(const WallSnapshot& snapshot);

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

private:
    FrameWriter writer_;
};

} // namespace starling
