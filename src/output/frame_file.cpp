#include "output/frame_file.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "output/file_name.hpp"

namespace starling {

namespace fs = std::filesystem;

namespace {

constexpr const char* triangles = "triangles"; ///< stand in the first frame of the wall

template <class F>
auto or_refuse(const fs::path& path, F f)
{
    try {
        return f();
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& e) {
        throw InputError(path.string() + ": " + e.what());
    }
}

[[noreturn]] void refuse(const std::string& why) { throw std::runtime_error(why); }

} // namespace

FrameFile::FrameFile(fs::path path) : path_(std::move(path))
{
    check_seal(path_, frame_seal);
    or_refuse(path_, [&] {
        const hdf5::File file = hdf5::File::open(path_);
        head_ = {file.text_attribute("/", "of"), file.real_attribute("/", "t"),
                 file.index_attribute("/", "step"), file.text_attribute("/", "unit_of_t")};
    });
}

std::vector<std::string> FrameFile::arrays() const
{
    return or_refuse(path_, [&] {
        auto names = hdf5::File::open(path_).names("/");
        std::erase(names, triangles);
        return names;
    });
}

FrameArray FrameFile::read(const std::string& name) const
{
    return or_refuse(path_, [&] {
        const hdf5::File file = hdf5::File::open(path_);
        FrameArray a;
        a.name = name;
        a.unit = file.text_attribute("/" + name, "unit");
        const auto shape = file.shape("/" + name);
        a.shape.assign(shape.begin(), shape.end());
        const bool vectors = shape.size() == 2 || shape.size() == 4;
        if (vectors) {
            if (shape.back() != 3) refuse(name + " is no list of vectors");
            a.components = 3;
            a.shape.pop_back();
        }
        a.values.resize(file.size("/" + name));
        file.read("/" + name, a.values);
        return a;
    });
}

void FrameFile::check_is_of(const std::string& what) const
{
    if (head_.of != what)
        throw InputError(path_.string() + ": is a frame of the " + head_.of + ", not of the " +
                         what);
}

std::vector<std::array<std::int32_t, 3>> FrameFile::read_triangles(std::size_t vertices) const
{
    std::string first = path_.filename();
    first.replace(first.find_last_of('_') + 1, std::string::npos, "000000.h5");
    const fs::path path = path_.parent_path() / first;
    check_seal(path, frame_seal);
    return or_refuse(path, [&] {
        const hdf5::File file = hdf5::File::open(path);
        const std::string name = std::string("/") + triangles;
        std::vector<std::int32_t> corners(file.size(name));
        file.read(name, corners);
        const auto is_vertex = [&](std::int32_t v) {
            return v >= 0 && static_cast<std::size_t>(v) < vertices;
        };
        if (corners.size() % 3 != 0 || !std::ranges::all_of(corners, is_vertex))
            refuse("its triangles are not of the points");
        std::vector<std::array<std::int32_t, 3>> all(corners.size() / 3);
        for (std::size_t n = 0; n < corners.size(); ++n) all[n / 3][n % 3] = corners[n];
        return all;
    });
}

WallFrame FrameFile::read_wall() const
{
    check_is_of("wall");
    WallFrame frame{head_, read("points"), {}, {}, {}};
    frame.triangles = read_triangles(frame.points.count());
    for (const std::string& name : arrays()) {
        if (name == "points") continue;
        const std::string at = or_refuse(
            path_, [&] { return hdf5::File::open(path_).text_attribute("/" + name, "at"); });
        (at == "vertex" ? frame.at_vertex : frame.at_element).push_back(read(name));
    }
    const auto fits = [](std::size_t count) {
        return [count](const FrameArray& a) { return a.count() == count; };
    };
    if (!std::ranges::all_of(frame.at_vertex, fits(frame.points.count())) ||
        !std::ranges::all_of(frame.at_element, fits(frame.triangles.size())))
        throw InputError(path_.string() + ": its arrays do not fit the mesh");
    return frame;
}

FluidFrame FrameFile::read_fluid() const
{
    check_is_of("fluid");
    FluidFrame frame;
    frame.head = head_;
    or_refuse(path_, [&] {
        const hdf5::File file = hdf5::File::open(path_);
        frame.origin = file.vector_attribute("/", "origin");
        frame.spacing = file.vector_attribute("/", "spacing");
        frame.unit_of_length = file.text_attribute("/", "unit_of_length");
    });
    for (const std::string& name : arrays()) {
        FrameArray a = read(name);
        if (a.shape.size() != 3) throw InputError(path_.string() + ": " + name + " is on no grid");
        const std::array<std::size_t, 3> cells = {a.shape[2], a.shape[1], a.shape[0]};
        if (!frame.at_cell.empty() && cells != frame.cells)
            throw InputError(path_.string() + ": " + name + " is on another grid");
        frame.cells = cells;
        frame.at_cell.push_back(std::move(a));
    }
    return frame;
}

FrameArray at_vertices(const FrameArray& a, const WallFrame& frame)
{
    FrameArray mean{a.name, a.unit, frame.points.shape, a.components, {}};
    const std::size_t vertices = frame.points.count();
    const auto components = static_cast<std::size_t>(a.components);
    mean.values.resize(vertices * components);
    std::vector<int> around(vertices);
    for (std::size_t e = 0; e < frame.triangles.size(); ++e)
        for (const std::int32_t corner : frame.triangles[e]) {
            const auto v = static_cast<std::size_t>(corner);
            ++around[v];
            for (std::size_t c = 0; c < components; ++c)
                mean.values[v * components + c] += a.values[e * components + c];
        }
    for (std::size_t v = 0; v < vertices; ++v)
        for (std::size_t c = 0; c < components; ++c)
            mean.values[v * components + c] /= around[v]; // NaN where there is none
    return mean;
}

std::vector<ListedFrame> list_frames(const fs::path& run_directory, const std::string& of)
{
    std::vector<ListedFrame> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(run_directory / "frames", none)) {
        const std::string name = entry.path().filename();
        if (is_numbered_name(name, of + "_", 6, ".h5")) found.push_back({entry.path(), {}, ""});
    }
    std::ranges::sort(found, {}, &ListedFrame::path);
    for (ListedFrame& frame : found) {
        try {
            frame.head = FrameFile(frame.path).head();
        } catch (const InputError& e) {
            frame.problem = std::string(e.what()).substr(frame.path.string().size() + 2);
        }
    }
    return found;
}

} // namespace starling
