#pragma once
/// The parts of the page's data, each made from the files of a run; web/src reads them.
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "config/case.hpp"
#include "output/frame_file.hpp"
#include "output/read_table.hpp"

namespace starling::report {

using Json = nlohmann::ordered_json;

/// What the reader of the page has to know: what was left out, and why.
using Notes = std::vector<std::string>;

/// A table as columns {name, unit, values}, at most `most_rows` of its rows.
Json table_data(const std::string& file, const TableContents& table, Notes& notes);

/// The case in words, and its numbers as rows {label, value, unit}.
Json case_data(const Case& c);

/// The key numbers as rows {label, value, unit} and, where there is theory, {theory, difference}.
/// `summary` is summary.json, null where the run has not ended: then from the last row of the
/// series.
Json result_data(const Json& summary, const TableContents& series, const Case& c);

/// The wall: triangles, and points and fields of as many of the frames as fit; null where there
/// is none.
Json wall_data(const std::vector<ListedFrame>& frames, Notes& notes);

/// A plane through the axis of as many of the fluid's frames as fit, inside the tube as it stands
/// in the wall's frame nearest in time; null where there is none.
Json flow_data(const std::vector<ListedFrame>& fluid, const std::vector<ListedFrame>& wall,
               Notes& notes);

} // namespace starling::report
