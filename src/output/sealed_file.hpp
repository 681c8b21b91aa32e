#pragma once
/// HDF5 files that can tell whether they are whole.
///
/// In front of the HDF5 file stand 512 bytes of text (HDF5's user block, which its readers skip)
/// with the kind of file, the version of its format, the size and a CRC-64 of all that follows: a
/// damaged file is recognised before HDF5 sees it.
#include <filesystem>
#include <span>
#include <string>

#include "output/hdf5_file.hpp"

namespace starling {

/// What the text in front of a file says besides size and checksum.
struct Seal {
    const char* kind; ///< "checkpoint"
    int version;      ///< of the format
    const char* page; ///< that describes it
};

inline constexpr std::size_t seal_size = 512; ///< bytes in front of the HDF5 file

/// The text that stands in front of these bytes of an HDF5 file.
std::string seal_of(std::span<const char> contents, const Seal& seal);

/// Saves a file that was created with a user block of `seal_size`; throws as File::save does.
void save_sealed(const hdf5::File& file, const Seal& seal, bool sync);

/// Throws InputError, with the reason, for a file that is missing, of another kind, of a newer
/// version, truncated or in which a single bit is wrong.
void check_seal(const std::filesystem::path& path, const Seal& seal);

/// The kind that a file claims to be; empty where it is none of Starling's.
std::string sealed_kind(const std::filesystem::path& path);

} // namespace starling
