#include "config/read_along_x.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "config/nearest_name.hpp"
#include "config/read_columns.hpp"

namespace starling {

namespace {

/// A section and its keys.
class AlongXReader {
public:
    AlongXReader(CaseValues& values, std::string section, const std::filesystem::path& folder)
        : values_(values), section_(std::move(section)), folder_(folder)
    {
    }

    AlongX read()
    {
        AlongX a;
        if (!values_.has_section(section_)) return a;
        const bool table = given("x") || given("values"), file = given("file");
        if (given("shape") + table + file != 1)
            problem("shape", "give one: a shape, x and values, or a file");
        else if (given("shape"))
            read_shape(a);
        else
            read_table(a, file);
        return a;
    }

private:
    std::string key(std::string_view name) const { return fmt::format("{}.{}", section_, name); }
    bool given(std::string_view name) const { return values_.given(key(name)); }
    void problem(std::string_view name, const std::string& what)
    {
        values_.problem(key(name), what);
    }

    void read_shape(AlongX& a)
    {
        for (const char* name : {"position", "length", "change"}) values_.require(key(name));
        if (given("x_scale")) problem("x_scale", "belongs to a table");
        if (!values_.sound({key("shape"), key("position"), key("length"), key("change")})) return;
        values_.fill(key("position"), a.position);
        values_.fill(key("length"), a.length);
        values_.fill(key("change"), a.change);
        a.shape =
            values_.text(key("shape"), "") == "bump" ? AlongX::Shape::bump : AlongX::Shape::step;
    }

    void read_table(AlongX& a, bool from_file)
    {
        for (const char* name : {"position", "length", "change"})
            if (given(name)) problem(name, "belongs to a shape");
        if (from_file)
            read_file(a);
        else if (values_.require(key("x")) && values_.require(key("values"))) {
            values_.fill(key("x"), a.x);
            values_.fill(key("values"), a.values);
            if (a.x.size() != a.values.size())
                problem("values", fmt::format("holds {} numbers for {} positions", a.values.size(),
                                              a.x.size()));
        }
        Real scale = 1;
        values_.fill(key("x_scale"), scale);
        for (Real& x : a.x) x *= scale;
        check_rows(a, from_file ? "file" : "x", from_file ? "file" : "values");
        if (values_.sound({key("x"), key("values"), key("file"), key("x_scale")}))
            a.shape = AlongX::Shape::table;
    }

    void check_rows(const AlongX& a, std::string_view positions, std::string_view factors)
    {
        for (std::size_t n = 1; n < a.x.size(); ++n)
            if (a.x[n] <= a.x[n - 1])
                return problem(positions,
                               fmt::format("has positions that do not increase at row {}", n + 1));
        const Range& range = case_key(key("values")).range;
        for (Real value : a.values)
            if (!range.contains(value))
                return problem(factors, fmt::format("holds the factor {:g}; it must be {}", value,
                                                    range.describe()));
    }

    void read_file(AlongX& a)
    {
        if (!values_.has(key("file"))) return;
        const std::filesystem::path file = folder_ / values_.text(key("file"), "");
        try {
            Columns columns = read_columns(file, "x,value");
            a.x = std::move(columns.first);
            a.values = std::move(columns.second);
        } catch (const std::invalid_argument& e) {
            problem("file", fmt::format("{}: {}", in_quotes(file.string()), e.what()));
        }
    }

    CaseValues& values_;
    std::string section_;
    const std::filesystem::path& folder_;
};

} // namespace

void read_along_x(CaseValues& values, Case& c, const std::filesystem::path& folder)
{
    c.tube.rest_radius = AlongXReader(values, "rest_radius", folder).read();
    c.material.stiffness = AlongXReader(values, "stiffness", folder).read();
    if (!c.material.stiffness.uniform() && c.material.bending > 0)
        for (const char* key : {"wall.bending", "wall.bending_modulus", "wall.bending_thickness"})
            if (values.given(key))
                values.problem(key, "cannot be had with [stiffness] yet: the bending stiffness is "
                                    "the same everywhere");
}

} // namespace starling
