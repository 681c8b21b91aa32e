#pragma once
/// XDMF: the small XML file beside an HDF5 file that tells ParaView what the arrays mean.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace starling::xdmf {

/// Where an array lives in the XDMF sense.
enum class Centre { node, cell };

/// An array in an HDF5 file beside the XDMF file.
struct Array {
    std::string location;     ///< "wall.h5:/frames/000000/points"
    std::vector<Index> shape; ///< slowest dimension first; the last one is 3 for vectors
    bool integer = false;
    int bytes = 4; ///< per number
};

/// A reference to the array.
std::string data_item(const Array& array);
/// A vector within the XML itself, z first, as XDMF wants grids described.
std::string data_item_zyx(const Vec3& v);
/// Names an array as a scalar or, with three components, a vector field.
std::string attribute(const std::string& name, Centre centre, int components, const Array& array);

/// One grid of a time series: its topology, geometry and attributes.
struct Grid {
    Real t = 0;
    std::string body;
};

/// A time series of grids in one XDMF file. The file is replaced as a whole after each frame, so
/// that it is complete at every moment.
class Series {
public:
    Series(std::filesystem::path path, std::string name);
    /// Goes on from the first `frames` grids of the file, which holds so many.
    void keep(Index frames);
    /// Whether the file holds that many grids.
    bool holds(Index frames) const { return first(frames).has_value(); }
    /// Goes on from these, whatever the file holds.
    void keep(const std::vector<Grid>& grids);
    /// Adds a grid; times must increase.
    void add(const Grid& grid);

private:
    std::optional<std::string> first(Index frames) const;
    std::string text_of(const Grid& grid) const;
    void replace() const;

    std::filesystem::path path_;
    std::string name_;
    std::string frames_;
};

} // namespace starling::xdmf
