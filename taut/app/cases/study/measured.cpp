#include "taut/app/cases/study/measured.hpp"

#include <algorithm>
#include <sstream>

#include "taut/catalogue/csv.hpp"
#include "taut/units/any_quantity.hpp"
#include "taut/units/parse.hpp"

namespace taut::app {
namespace {

const std::vector<std::string> own_columns = {"output", "value", "sd"};

/// The columns of the header that are paths.
std::vector<std::string> paths_in(const std::string& text) {
  std::string head = text.substr(0, text.find_first_of("\r\n"));
  if (head.starts_with("\xEF\xBB\xBF")) head.erase(0, 3);
  std::vector<std::string> paths;
  std::istringstream cells(head);
  for (std::string cell; std::getline(cells, cell, ',');) {
    std::erase(cell, '"');
    const auto from = cell.find_first_not_of(" \t");
    if (from == std::string::npos) continue;
    cell = cell.substr(from, cell.find_last_not_of(" \t") - from + 1);
    if (std::find(own_columns.begin(), own_columns.end(), cell) == own_columns.end()) paths.push_back(cell);
  }
  return paths;
}

catalogue::CsvReader reader_of(const MeasuredTable& table) {
  std::vector<catalogue::CsvColumn> columns = {
      {.name = "output"}, {.name = "value"}, {.name = "sd", .required = false}};
  for (const std::string& path : table.paths) columns.push_back({.name = path});
  return {table.text, table.file, std::move(columns)};
}

void take_mistakes(catalogue::CsvReader& csv, Diagnostics& mistakes) {
  for (Diagnostic& d : csv.take_diagnostics()) mistakes.push_back(std::move(d));
}

}  // namespace

MeasuredTable read_measured(std::string text, std::string file, Diagnostics& mistakes) {
  MeasuredTable table{.file = std::move(file), .text = std::move(text), .outputs = {}, .paths = {}};
  table.paths = paths_in(table.text);
  catalogue::CsvReader csv = reader_of(table);
  while (csv.next()) {
    const std::string output = csv.required_text("output");
    const auto& known = table.outputs;
    if (std::find(known.begin(), known.end(), output) == known.end()) table.outputs.push_back(output);
  }
  take_mistakes(csv, mistakes);
  if (mistakes.empty() && table.outputs.empty()) {
    mistakes.push_back({table.file, {.line = 1, .column = 1}, "it has no measurement", {}, 1});
  }
  return table;
}

Measurements in_si(const MeasuredTable& table, const CaseModel& model, std::size_t first_setting,
                   Diagnostics& mistakes) {
  Measurements all;
  catalogue::CsvReader csv = reader_of(table);
  while (csv.next()) {
    const auto number = [&](const std::string& column, const Unit& unit, bool difference = false) {
      const std::string text = csv.required_text(column);
      const auto x = difference ? parse_difference(text, unit) : parse_quantity(text, unit);
      if (!x) csv.fail(column, x.error().message);
      return x.value_or(1);
    };
    const auto at = std::find(table.outputs.begin(), table.outputs.end(), csv.text("output"));
    const CaseOutput& output = model.outputs[static_cast<std::size_t>(at - table.outputs.begin())];
    all.output.push_back(static_cast<std::size_t>(at - table.outputs.begin()));
    all.values.push_back(number("value", output.unit));
    if (!csv.text("sd").empty()) all.sd.push_back(number("sd", output.unit, true));
    if (!all.sd.empty() && all.sd.size() != all.values.size()) {
      csv.fail("sd", "some rows have an sd and some have none: give it in all or in none");
      break;
    }
    if (csv.text("sd").empty() && !same_kind(output.unit, model.outputs[all.output.front()].unit)) {
      csv.fail("value", "measurements of different kinds need an sd each: nothing else tells how they weigh");
    }
    std::vector<double> state;
    state.reserve(table.paths.size());
    for (std::size_t k = 0; k < table.paths.size(); ++k) {
      state.push_back(number(table.paths[k], model.inputs[first_setting + k].unit));
    }
    const auto known = std::find(all.states.begin(), all.states.end(), state);
    all.state.push_back(static_cast<std::size_t>(known - all.states.begin()));
    if (known == all.states.end()) all.states.push_back(std::move(state));
  }
  take_mistakes(csv, mistakes);
  return all;
}

}  // namespace taut::app
