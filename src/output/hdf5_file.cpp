#include "output/hdf5_file.hpp"

#include "output/replace_file.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace starling::hdf5 {

namespace {

constexpr hsize_t largest_chunk = 65536; ///< values; a chunk is compressed at once
constexpr unsigned deflate_level = 4;
constexpr Real most_values_per_byte = 1032; ///< what deflate can make of a constant

/// HDF5 reports through `Handle` and `check`, not on standard error.
void silence()
{
    static const bool done = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
    (void)done;
}

herr_t keep_first_message(unsigned n, const H5E_error2_t* error, void* text)
{
    if (n == 0 && error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
    return 0;
}

[[noreturn]] void fail(const std::string& what)
{
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first_message, &reason);
    throw std::runtime_error("cannot " + what + (reason.empty() ? "" : " (HDF5: " + reason + ")"));
}

void check(herr_t status, const std::string& what)
{
    if (status < 0) fail(what);
}

/// A viewer that reads while a run writes must not stop the run, so the file is not locked.
Handle access()
{
    silence();
    Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "set up HDF5");
    check(H5Pset_file_locking(list.get(), false, true), "set up HDF5");
    check(H5Pset_fclose_degree(list.get(), H5F_CLOSE_STRONG), "set up HDF5");
    return list;
}

/// Whole rows of the slowest dimension, as many as `largest_chunk` allows.
std::vector<hsize_t> chunk_shape(std::vector<hsize_t> shape)
{
    hsize_t size = std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies<>());
    for (hsize_t& n : shape) {
        const hsize_t row = size / n;
        n = std::clamp(largest_chunk / row, hsize_t{1}, n);
        size = n * row;
    }
    return shape;
}

Handle compression(const std::vector<hsize_t>& shape)
{
    Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "set up HDF5");
    check(H5Pset_obj_track_times(list.get(), false), "set up HDF5");
    const bool empty = std::ranges::any_of(shape, [](hsize_t n) { return n == 0; });
    if (empty) return list;
    const auto chunk = chunk_shape(shape);
    check(H5Pset_chunk(list.get(), static_cast<int>(chunk.size()), chunk.data()), "set up HDF5");
    check(H5Pset_shuffle(list.get()), "set up HDF5");
    check(H5Pset_deflate(list.get(), deflate_level), "set up HDF5");
    return list;
}

Handle in_one_piece()
{
    Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "set up HDF5");
    check(H5Pset_obj_track_times(list.get(), false), "set up HDF5");
    return list;
}

/// Values are read into room for one.
void check_single(const Handle& attribute, const std::string& what)
{
    const Handle space(H5Aget_space(attribute.get()), H5Sclose, what);
    if (H5Sget_simple_extent_npoints(space.get()) != 1)
        throw std::runtime_error("cannot " + what + ": it is no single value");
}

} // namespace

Handle::Handle(hid_t id, Close close, const std::string& what) : id_(id), close_(close)
{
    if (id_ < 0) fail(what);
}

Handle::Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}

Handle::~Handle()
{
    if (id_ >= 0) close_(id_);
}

File::File(Handle file, std::filesystem::path path, Layout layout)
    : file_(std::move(file)), path_(std::move(path)), layout_(layout)
{
}

File File::create(const std::filesystem::path& path, Layout layout, hsize_t user_block)
{
    constexpr std::size_t increment = std::size_t{1} << 22;
    const Handle list = access();
    check(H5Pset_fapl_core(list.get(), increment, false), "set up HDF5");
    const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "set up HDF5");
    check(H5Pset_userblock(creation.get(), user_block), "set up HDF5");
    return {Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), list.get()), H5Fclose,
                   "create " + path.string()),
            path, layout};
}

File File::open(const std::filesystem::path& path)
{
    const Handle list = access();
    return {Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, list.get()), H5Fclose,
                   "open " + path.string()),
            path, Layout::compressed};
}

void File::make_group(const std::string& path)
{
    const Handle group(H5Gcreate2(file_.get(), path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                       H5Gclose, "write " + path_.string() + ":" + path);
}

void File::write_raw(const std::string& path, const std::vector<hsize_t>& shape, const void* values,
                     hid_t memory_type, hid_t file_type)
{
    const std::string what = "write " + path_.string() + ":" + path;
    const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                       H5Sclose, what);
    const Handle list = layout_ == Layout::compressed ? compression(shape) : in_one_piece();
    const Handle set(H5Dcreate2(file_.get(), path.c_str(), file_type, space.get(), H5P_DEFAULT,
                                list.get(), H5P_DEFAULT),
                     H5Dclose, what);
    check(H5Dwrite(set.get(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), what);
}

void File::write(const std::string& path, const std::vector<hsize_t>& shape,
                 std::span<const Real> values, Precision precision)
{
    write_raw(path, shape, values.data(), H5T_NATIVE_DOUBLE,
              precision == Precision::single ? H5T_IEEE_F32LE : H5T_IEEE_F64LE);
}

void File::write(const std::string& path, const std::vector<hsize_t>& shape,
                 std::span<const std::int32_t> values)
{
    write_raw(path, shape, values.data(), H5T_NATIVE_INT32, H5T_STD_I32LE);
}

void File::write(const std::string& path, std::span<const std::uint8_t> values)
{
    write_raw(path, {values.size()}, values.data(), H5T_NATIVE_UINT8, H5T_STD_U8LE);
}

void File::link(const std::string& path, const std::string& other_file, const std::string& target)
{
    check(H5Lcreate_external(other_file.c_str(), target.c_str(), file_.get(), path.c_str(),
                             H5P_DEFAULT, H5P_DEFAULT),
          "write " + path_.string() + ":" + path);
}

std::vector<std::string> File::names(const std::string& path) const
{
    const std::string what = "read " + path_.string() + ":" + path;
    const Handle group(H5Gopen2(file_.get(), path.c_str(), H5P_DEFAULT), H5Gclose, what);
    H5G_info_t info = {};
    check(H5Gget_info(group.get(), &info), what);
    std::vector<std::string> found;
    for (hsize_t n = 0; n < info.nlinks; ++n) {
        const auto name = [&](char* text, std::size_t room) {
            return H5Lget_name_by_idx(group.get(), ".", H5_INDEX_NAME, H5_ITER_INC, n, text, room,
                                      H5P_DEFAULT);
        };
        const ssize_t length = name(nullptr, 0);
        if (length < 0) fail(what);
        std::string text(static_cast<std::size_t>(length) + 1, '\0');
        if (name(text.data(), text.size()) < 0) fail(what);
        text.pop_back();
        found.push_back(text);
    }
    std::ranges::sort(found);
    return found;
}

std::vector<hsize_t> File::shape(const std::string& path) const
{
    const std::string what = "read " + path_.string() + ":" + path;
    const Handle set(H5Dopen2(file_.get(), path.c_str(), H5P_DEFAULT), H5Dclose, what);
    const Handle space(H5Dget_space(set.get()), H5Sclose, what);
    std::vector<hsize_t> shape(
        static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space.get()), 0)));
    check(H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr), what);
    Real values = 1;
    for (hsize_t n : shape) values *= static_cast<Real>(n);
    if (values > most_values_per_byte * static_cast<Real>(std::filesystem::file_size(path_)))
        throw std::runtime_error("cannot " + what + ": it claims more values than the file holds");
    return shape;
}

std::size_t File::size(const std::string& path) const
{
    const auto all = shape(path);
    return std::accumulate(all.begin(), all.end(), hsize_t{1}, std::multiplies<>());
}

void File::read_raw(const std::string& path, hid_t memory_type, void* values,
                    std::size_t expected) const
{
    const std::string what = "read " + path_.string() + ":" + path;
    if (size(path) != expected)
        throw std::runtime_error("cannot " + what + ": it has another size than expected");
    const Handle set(H5Dopen2(file_.get(), path.c_str(), H5P_DEFAULT), H5Dclose, what);
    check(H5Dread(set.get(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), what);
}

void File::read(const std::string& path, std::span<Real> values) const
{
    read_raw(path, H5T_NATIVE_DOUBLE, values.data(), values.size());
}

void File::read(const std::string& path, std::span<std::int32_t> values) const
{
    read_raw(path, H5T_NATIVE_INT32, values.data(), values.size());
}

void File::read(const std::string& path, std::span<std::uint8_t> values) const
{
    read_raw(path, H5T_NATIVE_UINT8, values.data(), values.size());
}

Handle File::open_attribute(const std::string& path, const std::string& name) const
{
    return {H5Aopen_by_name(file_.get(), path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
            H5Aclose, "read " + path_.string() + ":" + path + "@" + name};
}

template <class T>
T File::scalar(const std::string& path, const std::string& name, hid_t type) const
{
    const std::string what = "read " + path_.string() + ":" + path + "@" + name;
    const Handle attribute = open_attribute(path, name);
    check_single(attribute, what);
    T value{};
    check(H5Aread(attribute.get(), type, &value), what);
    return value;
}

Vec3 File::vector_attribute(const std::string& path, const std::string& name) const
{
    const std::string what = "read " + path_.string() + ":" + path + "@" + name;
    const Handle attribute = open_attribute(path, name);
    check_single(attribute, what);
    const Handle found(H5Aget_type(attribute.get()), H5Tclose, what);
    hsize_t count = 0;
    if (H5Tget_class(found.get()) != H5T_ARRAY || H5Tget_array_ndims(found.get()) != 1 ||
        H5Tget_array_dims2(found.get(), &count) < 0 || count != 3)
        throw std::runtime_error("cannot " + what + ": it is no vector");
    const Handle type(H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &count), H5Tclose, "set up HDF5");
    std::array<Real, 3> xyz{};
    check(H5Aread(attribute.get(), type.get(), xyz.data()), what);
    return {xyz[0], xyz[1], xyz[2]};
}

Real File::real_attribute(const std::string& path, const std::string& name) const
{
    return scalar<Real>(path, name, H5T_NATIVE_DOUBLE);
}

Index File::index_attribute(const std::string& path, const std::string& name) const
{
    return scalar<Index>(path, name, H5T_NATIVE_INT64);
}

std::string File::text_attribute(const std::string& path, const std::string& name) const
{
    const std::string what = "read " + path_.string() + ":" + path + "@" + name;
    const Handle attribute = open_attribute(path, name);
    check_single(attribute, what);
    const Handle type(H5Aget_type(attribute.get()), H5Tclose, what);
    if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0)
        throw std::runtime_error("cannot " + what + ": it is no text of fixed length");
    std::string text(H5Tget_size(type.get()), '\0');
    check(H5Aread(attribute.get(), type.get(), text.data()), what);
    return text.substr(0, text.find('\0'));
}

void File::write_attribute(const std::string& path, const std::string& name, hid_t type,
                           const void* value)
{
    const std::string what = "write " + path_.string() + ":" + path + "@" + name;
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, what);
    const Handle attribute(H5Acreate_by_name(file_.get(), path.c_str(), name.c_str(), type,
                                             space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose, what);
    check(H5Awrite(attribute.get(), type, value), what);
}

void File::attribute(const std::string& path, const std::string& name, const std::string& value)
{
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "set up HDF5");
    check(H5Tset_size(type.get(), value.size() + 1), "set up HDF5");
    check(H5Tset_cset(type.get(), H5T_CSET_UTF8), "set up HDF5");
    write_attribute(path, name, type.get(), value.c_str());
}

void File::attribute(const std::string& path, const std::string& name, Real value)
{
    write_attribute(path, name, H5T_NATIVE_DOUBLE, &value);
}

void File::attribute(const std::string& path, const std::string& name, Index value)
{
    write_attribute(path, name, H5T_NATIVE_INT64, &value);
}

void File::attribute(const std::string& path, const std::string& name, const Vec3& value)
{
    const hsize_t three = 3;
    const Real xyz[] = {value.x, value.y, value.z};
    const Handle type(H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &three), H5Tclose, "set up HDF5");
    write_attribute(path, name, type.get(), xyz);
}

hsize_t File::user_block() const
{
    const Handle creation(H5Fget_create_plist(file_.get()), H5Pclose, "read " + path_.string());
    hsize_t size = 0;
    check(H5Pget_userblock(creation.get(), &size), "read " + path_.string());
    return size;
}

void File::save(const std::function<void(std::span<char> all)>& prepare, bool sync) const
{
    const std::string what = "write " + path_.string();
    check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), what);
    void* image = nullptr;
    check(H5Fget_vfd_handle(file_.get(), H5P_DEFAULT, &image), what);
    // without the room kept for more; counted from the end of the user block
    const ssize_t size = H5Fget_file_image(file_.get(), nullptr, 0);
    if (size < 0) fail(what);
    const std::span<char> all(*static_cast<char**>(image),
                              static_cast<std::size_t>(size) + user_block());
    if (prepare) prepare(all);
    write_bytes(path_, all, sync);
}

} // namespace starling::hdf5
