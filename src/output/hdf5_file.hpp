#pragma once
/// The little of HDF5 that result files need: groups, arrays, attributes, links.
#include <filesystem>
#include <functional>
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

/// How arrays lie in the file: in compressed chunks, or in one piece at full speed.
enum class Layout { compressed, contiguous };

/// A file open for writing until it goes out of scope. Every call throws std::runtime_error when
/// HDF5 refuses.
class File {
public:
    /// Creates a file in memory, to be saved at `path` (HDF5 itself may crash when it closes a file
    /// that the disk has no room for). It leaves the first `user_block`
    /// bytes alone (0, or a power of two from 512).
    static File create(const std::filesystem::path& path, Layout layout = Layout::compressed,
                       hsize_t user_block = 0);
    /// Opens a file for reading; every write then fails.
    static File open(const std::filesystem::path& path);

    void make_group(const std::string& path);
    /// Writes values in C order as a chunked, shuffled and deflated array.
    void write(const std::string& path, const std::vector<hsize_t>& shape,
               std::span<const Real> values, Precision precision);
    void write(const std::string& path, const std::vector<hsize_t>& shape,
               std::span<const std::int32_t> values);
    void write(const std::string& path, std::span<const std::uint8_t> values);
    /// Makes `path` lead to `target` in another file, named relative to this one.
    void link(const std::string& path, const std::string& other_file,
              const std::string& target = "/");

    /// Names of what the group at `path` holds, sorted.
    std::vector<std::string> names(const std::string& path) const;
    /// The shape of the array at `path`, and how many values that is. Throws std::runtime_error
    /// also where it claims more of them than the file can hold.
    std::vector<hsize_t> shape(const std::string& path) const;
    std::size_t size(const std::string& path) const;
    /// Reads the whole array into `values`, whose size must be that of the array.
    void read(const std::string& path, std::span<Real> values) const;
    void read(const std::string& path, std::span<std::int32_t> values) const;
    void read(const std::string& path, std::span<std::uint8_t> values) const;

    /// Attributes of the group or array at `path`.
    void attribute(const std::string& path, const std::string& name, const std::string& value);
    void attribute(const std::string& path, const std::string& name, Real value);
    void attribute(const std::string& path, const std::string& name, Index value);
    void attribute(const std::string& path, const std::string& name, const Vec3& value);
    Real real_attribute(const std::string& path, const std::string& name) const;
    Index index_attribute(const std::string& path, const std::string& name) const;
    Vec3 vector_attribute(const std::string& path, const std::string& name) const;
    std::string text_attribute(const std::string& path, const std::string& name) const;
    /// Writes a created file, which until then is in memory only, to its path. Throws
    /// std::runtime_error where the disk is full or the like; the memory is sound all the same.
    /// `prepare` may fill the user block, knowing all that follows it.
    void save(const std::function<void(std::span<char> all)>& prepare = {},
              bool sync = false) const;

private:
    File(Handle file, std::filesystem::path path, Layout layout);
    void read_raw(const std::string& path, hid_t memory_type, void* values, std::size_t size) const;
    hsize_t user_block() const;
    Handle open_attribute(const std::string& path, const std::string& name) const;
    template <class T>
    T scalar(const std::string& path, const std::string& name, hid_t type) const;
    void write_raw(const std::string& path, const std::vector<hsize_t>& shape, const void* values,
                   hid_t memory_type, hid_t file_type);
    void write_attribute(const std::string& path, const std::string& name, hid_t type,
                         const void* value);

    Handle file_;
    std::filesystem::path path_;
    Layout layout_;
};

} // namespace starling::hdf5
