#include "taut/catalogue/steel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/expects.hpp"
#include "taut/catalogue/csv.hpp"
#include "taut/catalogue/embedded/steels_csv.hpp"

namespace taut::catalogue {
namespace {

constexpr double same_thickness = 1e-7;  // m: a wall of 16 mm computed as 0.016000000000000004 belongs to "up to 16"

std::vector<std::string> split_names(std::string_view text) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    if (end > 0) out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

/// Adds one line of the table to the steel it belongs to, or begins a new one.
void add_line(CsvReader& csv, std::vector<SteelRow>& rows) {
  SteelRow line;
  line.name = csv.required_text("name");
  line.also = split_names(csv.text("also"));
  line.standard = csv.required_text("standard");
  const std::string& basis = csv.text("basis");
  if (basis != "design" && basis != "product") {
    csv.fail("basis", fmt::format("basis {} is not design or product", in_quotes(basis)));
  }
  line.basis = basis == "product" ? SteelBasis::product : SteelBasis::design;
  SteelRange range;
  range.over = csv.not_negative("t_over_mm");
  range.to = csv.positive("t_to_mm");
  range.yield = csv.positive("fy_MPa");
  range.ultimate = csv.positive("fu_MPa");
  line.trust = csv.trust("trust");
  line.trust_text = csv.text("trust_text");
  if (range.to <= range.over) csv.fail("t_to_mm", "t_to_mm must be above t_over_mm");
  if (range.ultimate < range.yield) csv.fail("fu_MPa", "the ultimate strength is below the yield stress");

  const auto is_same = [&](const SteelRow& row) {
    return row.name == line.name && row.standard == line.standard && row.basis == line.basis;
  };
  const auto known = std::find_if(rows.begin(), rows.end(), is_same);
  if (known == rows.end()) {
    line.ranges = {range};
    rows.push_back(std::move(line));
    return;
  }
  if (std::next(known) != rows.end() || std::abs(known->ranges.back().to - range.over) > same_thickness) {
    csv.fail("t_over_mm", fmt::format("the ranges of {} must stand together, thinnest first, without gap or overlap",
                                      full_name(line)));
  }
  known->ranges.push_back(range);
  known->trust = weaker(known->trust, line.trust);
}

/// How a name asked for may be spelt for this steel, normalised.
std::vector<std::string> spellings(const SteelRow& steel) {
  std::vector<std::string> out;
  std::vector<std::string> names{steel.name};
  names.insert(names.end(), steel.also.begin(), steel.also.end());
  for (const std::string& name : names) {
    for (const std::string& basis : {std::string(), std::string(to_text(steel.basis))}) {
      out.push_back(normalised(name + basis));
      out.push_back(normalised(fmt::format("{}{}{}", steel.standard, name, basis)));
      out.push_back(normalised(fmt::format("{}{}{}", name, steel.standard, basis)));
    }
  }
  return out;
}

std::vector<std::vector<std::string>> spellings_of(const std::vector<SteelRow>& table) {
  std::vector<std::vector<std::string>> all;
  all.reserve(table.size());
  for (const SteelRow& row : table) all.push_back(spellings(row));
  return all;
}

std::vector<std::string> full_names(const std::vector<const SteelRow*>& rows) {
  std::vector<std::string> out;
  out.reserve(rows.size());
  for (const SteelRow* row : rows) out.push_back(full_name(*row));
  return out;
}

LookupError no_such_steel(std::string_view name, const std::vector<SteelRow>& table) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& one) {
    if (std::find(names.begin(), names.end(), one) == names.end()) names.push_back(one);
  };
  for (const SteelRow& row : table) {
    add(row.name);
    std::for_each(row.also.begin(), row.also.end(), add);
  }
  return {.message = fmt::format("no steel {}", in_quotes(name)), .candidates = nearest_names(name, names, 5)};
}

}  // namespace

std::string_view to_text(SteelBasis basis) { return basis == SteelBasis::design ? "design" : "product"; }

std::string full_name(const SteelRow& steel) {
  return fmt::format("{} {}{}", steel.standard, steel.name, steel.basis == SteelBasis::product ? " product" : "");
}

tl::expected<std::vector<SteelRow>, Diagnostics> read_steels(std::string_view csv_text, std::string file) {
  CsvReader csv(csv_text, std::move(file),
                {{.name = "name"},
                 {.name = "also"},
                 {.name = "standard"},
                 {.name = "basis"},
                 {.name = "t_over_mm"},
                 {.name = "t_to_mm"},
                 {.name = "fy_MPa"},
                 {.name = "fu_MPa"},
                 {.name = "trust"},
                 {.name = "trust_text", .required = false}});
  std::vector<SteelRow> rows;
  while (csv.next()) add_line(csv, rows);
  if (csv.failed()) return tl::unexpected(csv.take_diagnostics());
  return rows;
}

const std::vector<SteelRow>& steels() {
  static const std::vector<SteelRow> rows = [] {
    auto read = read_steels(embedded::steels_csv, "data/steels.csv");
    expects(read.has_value(), read ? "" : to_text(read.error()));
    return std::move(*read);
  }();
  return rows;
}

Found<SteelRow> find_steel(std::string_view name, const std::vector<SteelRow>& table) {
  const std::string wanted = normalised(name);
  // a design asks for its steel at each trial: the names of our own table are made once
  static const auto of_ours = spellings_of(steels());
  const auto all = &table == &steels() ? std::nullopt : std::optional(spellings_of(table));
  const auto& names = all ? *all : of_ours;
  std::vector<const SteelRow*> found;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (std::find(names[i].begin(), names[i].end(), wanted) != names[i].end()) found.push_back(&table[i]);
  }
  if (found.empty()) return tl::unexpected(no_such_steel(name, table));
  const auto design_end = std::stable_partition(found.begin(), found.end(),
                                                [](const SteelRow* row) { return row->basis == SteelBasis::design; });
  if (design_end != found.begin()) found.erase(design_end, found.end());
  if (found.size() == 1) return *found.front();
  return tl::unexpected(
      LookupError{.message = fmt::format("steel {} is in {} standards", in_quotes(name), found.size()),
                  .candidates = full_names(found)});
}

double yield(const SteelRow& steel) {
  expects(!steel.ranges.empty(), "a steel has at least one range of thickness");
  return steel.ranges.front().yield;
}

Found<double> yield(const SteelRow& steel, double thickness) {
  expects(!steel.ranges.empty(), "a steel has at least one range of thickness");
  const SteelRange& first = steel.ranges.front();
  // The thinnest range is open at its lower end only when the table says so ("3 to 50 mm").
  if (thickness > first.over) {
    for (const SteelRange& range : steel.ranges) {
      if (thickness <= range.to + same_thickness) return range.yield;
    }
  }
  return tl::unexpected(
      LookupError{.message = fmt::format("{} has no yield stress for {} mm: its table goes from {} to {} mm",
                                         full_name(steel), short_number(thickness * 1e3),
                                         short_number(first.over * 1e3), short_number(steel.ranges.back().to * 1e3)),
                  .candidates = {}});
}

Found<double> yield(std::string_view name, double thickness) {
  return find_steel(name).and_then([&](const SteelRow& steel) { return yield(steel, thickness); });
}

}  // namespace taut::catalogue
