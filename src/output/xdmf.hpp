#pragma once
/// XDMF: the small XML file beside an HDF5 file that tells ParaView what the arrays mean.
#include <filesystem>
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

/// A time series of grids in one XDMF file. The file is replaced as a whole after each frame, so
/// that it is complete at every moment.
class Series {
public:
    Series(std::filesystem::path path, std::string name);
    /// Goes on from the first `frames` grids of the file; throws InputError where it has fewer.
    void keep(Index frames);
    /// Throws as `keep` does, and changes nothing.
    void check(Index frames) const { first(frames); }
    /// Adds a grid whose topology, geometry and attributes are `body`; times must increase.
    void add(Real t, const std::string& body);

private:
    std::string first(Index frames) const;
    void replace() const;

    std::filesystem::path path_;
    std::string name_;
    std::string frames_;
};

} // namespace starling::xdmf
