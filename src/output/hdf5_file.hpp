#pragma once
/// The little of HDF5 that result files need: groups, compressed arrays, attributes.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <hdf5.h>

#include "core/types.hpp"

namespace starling::hdf5 {

/// Owns one HDF5 identifier and closes it.
class Handle {
public:
    using Close = herr_t (*)(hid_t);
    /// Throws std::runtime_error naming `what` with HDF5's own reason when `id` is negative.
    Handle(hid_t id, Close close, const std::string& what);
    Handle(Handle&& other) noexcept;
    Handle& operator=(Handle&&) = delete;
    ~Handle();

    hid_t get() const { return id_; }

private:
    hid_t id_;
    Close close_;
};

/// Precision of floating-point arrays in the file.
enum class Precision { single, full };

/// A file open for writing until it goes out of scope. Every call throws std::runtime_error when
/// HDF5 refuses.
class File {
public:
    /// Creates the file or replaces one of the same name.
    static File create(const std::filesystem::path& path);
    /// Opens a file written before in order to add to it.
    static File append(const std::filesystem::path& path);

    void make_group(const std::string& path);
    /// Writes values in C order as a chunked, shuffled and deflated array.
    void write(const std::string& path, const std::vector<hsize_t>& shape,
               std::span<const Real> values, Precision precision);
    void write(const std::string& path, const std::vector<hsize_t>& shape,
               std::span<const std::int32_t> values);
    /// Attributes of the group or array at `path`.
    void attribute(const std::string& path, const std::string& name, const std::string& value);
    void attribute(const std::string& path, const std::string& name, Real value);
    void attribute(const std::string& path, const std::string& name, Index value);
    void attribute(const std::string& path, const std::string& name, const Vec3& value);
    /// Hands everything to the operating system; a file killed after this is whole.
    void flush();

private:
    File(Handle file, std::filesystem::path path);
    void write_raw(const std::string& path, const std::vector<hsize_t>& shape, const void* values,
                   hid_t memory_type, hid_t file_type);
    void write_attribute(const std::string& path, const std::string& name, hid_t type,
                         const void* value);

    Handle file_;
    std::filesystem::path path_;
};

} // namespace starling::hdf5
