#include "taut/app/explain/listing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "taut/app/explain/starters.hpp"
#include "taut/app/methods.hpp"
#include "taut/base/suggest.hpp"
#include "taut/catalogue/forestry/carriage.hpp"
#include "taut/catalogue/forestry/yarder.hpp"
#include "taut/catalogue/rope_search.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/catalogue/steel.hpp"
#include "taut/units/parse.hpp"

namespace taut::app {
namespace {

using Rows = std::vector<std::vector<std::string>>;
using Listing = tl::expected<Rows, std::string>;

constexpr double millimetre = 1e-3;

std::string number(double x) { return fmt::format("{:.5g}", x); }

/// Reads the filters that are quantities and keeps the first that can't be read.
class QuantityReader {
 public:
  std::optional<double> read(const char* option, const std::string& text, const Unit& unit) {
    if (text.empty()) return std::nullopt;
    const auto value = parse_quantity(text, unit);
    if (value) return *value;
    if (error_.empty()) error_ = fmt::format("--{} '{}': {}", option, text, value.error().message);
    return std::nullopt;
  }
  const std::string& error() const { return error_; }

 private:
  std::string error_;
};

catalogue::Trust least_trust(const ListFilter& f) {
  return f.verified_only ? catalogue::Trust::verified : catalogue::Trust::unverified;
}

bool contains(std::string_view text, std::string_view part) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

Listing ropes(const ListFilter& f) {
  QuantityReader reader;
  catalogue::RopeFilter wanted;
  wanted.construction = f.construction;
  wanted.core = f.core;
  wanted.standard = f.standard;
  wanted.grade = reader.read("grade", f.grade, si::Pa);
  wanted.min_breaking_force = reader.read("min-breaking-force", f.min_breaking_force, si::N);
  wanted.min_diameter = reader.read("min-diameter", f.min_diameter, si::m);
  wanted.max_diameter = reader.read("max-diameter", f.max_diameter, si::m);
  wanted.min_area = reader.read("min-area", f.min_area, si::m2);
  wanted.min_trust = least_trust(f);
  if (!reader.error().empty()) return tl::unexpected(reader.error());
  Rows rows = {{"id", "d mm", "area mm2", "mass kg/m", "breaking force kN", "trust"}};
  for (const auto& r : catalogue::ropes_by(catalogue::RopeOrder::breaking_force, wanted)) {
    rows.push_back({r.id, number(r.diameter / millimetre), number(r.area * 1e6), number(r.mass_per_length),
                    number(r.breaking_force / 1e3), std::string(catalogue::to_text(r.trust))});
  }
  return rows;
}

Listing sections(const ListFilter& f) {
  QuantityReader reader;
  catalogue::SectionFilter wanted;
  wanted.standard = f.standard;
  wanted.min_area = reader.read("min-area", f.min_area, si::m2);
  wanted.max_height = reader.read("max-height", f.max_height, si::m);
  wanted.min_W_el_y = reader.read("min-section-modulus", f.min_section_modulus, si::m3);
  wanted.min_trust = least_trust(f);
  if (!reader.error().empty()) return tl::unexpected(reader.error());
  if (!f.shape.empty()) {
    wanted.shape = catalogue::parse_shape(f.shape);
    if (!wanted.shape) return tl::unexpected(fmt::format("--shape '{}': write CHS, SHS or RHS", f.shape));
  }
  if (!f.forming.empty()) {
    wanted.forming = catalogue::parse_forming(f.forming);
    if (!wanted.forming)
      return tl::unexpected(fmt::format("--forming '{}': write hot, cold, seamless or welded", f.forming));
  }
  Rows rows = {{"name", "standard", "H mm", "B mm", "t mm", "A mm2", "W_el cm3", "I cm4", "mass kg/m", "trust"}};
  for (const auto& s : catalogue::sections_by_mass(wanted)) {
    rows.push_back({s.name, s.standard, number(s.height / millimetre), number(s.width / millimetre),
                    number(s.thickness / millimetre), number(s.area * 1e6), number(s.W_el_y * 1e6), number(s.I_y * 1e8),
                    number(s.mass_per_length), std::string(catalogue::to_text(s.trust))});
  }
  return rows;
}

Listing steels(const ListFilter& f) {
  Rows rows = {{"name", "standard", "basis", "over mm", "to mm", "yield MPa", "ultimate MPa", "trust"}};
  for (const auto& s : catalogue::steels()) {
    if (!contains(s.name, f.name) || !contains(s.standard, f.standard)) continue;
    if (!catalogue::at_least(s.trust, least_trust(f))) continue;
    for (const auto& r : s.ranges) {
      rows.push_back({s.name, s.standard, std::string(catalogue::to_text(s.basis)), number(r.over / millimetre),
                      number(r.to / millimetre), number(r.yield / 1e6), number(r.ultimate / 1e6),
                      std::string(catalogue::to_text(s.trust))});
    }
  }
  return rows;
}

Listing rules(const ListFilter& f) {
  Rows rows = {{"id", "value", "unit", "field", "meaning", "source", "trust"}};
  for (const auto& r : catalogue::rules()) {
    if (!contains(r.id, f.name) && !contains(r.field, f.name)) continue;
    if (!catalogue::at_least(r.trust, least_trust(f))) continue;
    std::string value;
    if (r.low && r.high) value = *r.low == *r.high ? number(*r.low) : fmt::format("{:.5g}..{:.5g}", *r.low, *r.high);
    rows.push_back({r.id, value, r.unit, r.field, r.item + (r.text.empty() ? "" : ": " + r.text), r.source,
                    std::string(catalogue::to_text(r.trust))});
  }
  return rows;
}

std::string figure(const std::optional<double>& x, double unit) { return x ? number(*x / unit) : ""; }

Listing carriages(const ListFilter& f) {
  Rows rows = {{"name", "kind", "mass kg", "payload kg", "rope mm", "to mm", "trust", "source"}};
  for (const auto& c : catalogue::carriages()) {
    if (!contains(c.name, f.name) || !catalogue::at_least(c.trust, least_trust(f))) continue;
    rows.push_back({c.name, c.kind, number(c.mass), number(c.payload), figure(c.rope_least, millimetre),
                    figure(c.rope_most, millimetre), std::string(catalogue::to_text(c.trust)), c.trust_text});
  }
  return rows;
}

/// One row for each drum.
Listing yarders(const ListFilter& f) {
  Rows rows = {{"yarder", "tower m", "drum", "m", "of mm", "pull kN", "hold kN", "speed m/s", "trust", "source"}};
  for (const auto& y : catalogue::yarders()) {
    if (!contains(y.name, f.name)) continue;
    for (const auto& d : y.drums) {
      if (!catalogue::at_least(d.trust, least_trust(f))) continue;
      rows.push_back({y.name, figure(y.tower_height, 1), d.line, figure(d.capacity, 1),
                      figure(d.at_diameter, millimetre), number(d.pull / 1e3), figure(d.hold, 1e3), figure(d.speed, 1),
                      std::string(catalogue::to_text(d.trust)), d.trust_text});
    }
  }
  return rows;
}

Listing units(const ListFilter& f) {
  Rows rows = {{"unit", "of", "meaning"}};
  for (const UnitName& u : unit_names()) {
    if (contains(u.name, f.name) || contains(u.kind, f.name)) rows.push_back({u.name, u.kind, u.meaning});
  }
  return rows;
}

Listing method_rows(const ListFilter& f) {
  Rows rows = {{"method", "title", "source"}};
  for (const MethodEntry& m : methods()) {
    if (contains(m.about->name, f.name)) rows.push_back({m.about->name, m.about->title, m.about->short_source});
  }
  return rows;
}

Listing machines(const ListFilter& f) {
  Rows rows = {{"name", "title"}};
  for (const Starter& one : starters()) {
    if (contains(one.name, f.name) || contains(one.title, f.name)) rows.push_back({one.name, one.title});
  }
  return rows;
}

Listing rows_of(const std::string& what, const ListFilter& f) {
  if (what == "methods") return method_rows(f);
  if (what == "ropes") return ropes(f);
  if (what == "sections") return sections(f);
  if (what == "steels") return steels(f);
  if (what == "rules") return rules(f);
  if (what == "carriages") return carriages(f);
  if (what == "yarders") return yarders(f);
  if (what == "units") return units(f);
  if (what == "machines") return machines(f);
  const std::vector<std::string> lists = list_names();
  return tl::unexpected(fmt::format("there is no list of '{}'{}; the lists are {}", what, did_you_mean(what, lists),
                                    fmt::join(lists, ", ")));
}

/// A filter, and the lists that it looks through.
struct FilterUse {
  const char* option;
  bool given;
  std::vector<std::string> lists;
};

std::vector<FilterUse> uses_of(const ListFilter& f) {
  const auto given = [](const std::string& text) { return !text.empty(); };
  return {{.option = "construction", .given = given(f.construction), .lists = {"ropes"}},
          {.option = "core", .given = given(f.core), .lists = {"ropes"}},
          {.option = "grade", .given = given(f.grade), .lists = {"ropes"}},
          {.option = "min-breaking-force", .given = given(f.min_breaking_force), .lists = {"ropes"}},
          {.option = "min-diameter", .given = given(f.min_diameter), .lists = {"ropes"}},
          {.option = "max-diameter", .given = given(f.max_diameter), .lists = {"ropes"}},
          {.option = "min-area", .given = given(f.min_area), .lists = {"ropes", "sections"}},
          {.option = "shape", .given = given(f.shape), .lists = {"sections"}},
          {.option = "forming", .given = given(f.forming), .lists = {"sections"}},
          {.option = "max-height", .given = given(f.max_height), .lists = {"sections"}},
          {.option = "min-section-modulus", .given = given(f.min_section_modulus), .lists = {"sections"}},
          {.option = "standard", .given = given(f.standard), .lists = {"ropes", "sections", "steels"}},
          {.option = "name",
           .given = given(f.name),
           .lists = {"methods", "machines", "steels", "rules", "carriages", "yarders", "units"}},
          {.option = "verified",
           .given = f.verified_only,
           .lists = {"ropes", "sections", "steels", "rules", "carriages", "yarders"}}};
}

/// Why the filters can't be used there: a list that does not look at one would show all its rows as if they matched.
std::optional<std::string> refused_filter(const std::string& what, const ListFilter& filter) {
  std::vector<std::string> refused, apply;
  for (const FilterUse& use : uses_of(filter)) {
    const bool applies = std::find(use.lists.begin(), use.lists.end(), what) != use.lists.end();
    if (applies) apply.push_back(std::string("--") + use.option);
    if (!applies && use.given) refused.push_back(fmt::format("--{} is for {}", use.option, fmt::join(use.lists, ", ")));
  }
  if (refused.empty()) return std::nullopt;
  return fmt::format("{}; {} take {}", fmt::join(refused, "; "), what, fmt::join(apply, ", "));
}

bool looks_like_a_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isdigit(c) != 0 || c == '.' || c == '-' || c == '+' || c == 'e';
  });
}

/// Characters, not bytes: constructions and units have signs beyond ASCII.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0U) != 0x80U; }));
}

}  // namespace

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string pad(widths[i] - width_of(row[i]), ' ');
      const bool right = looks_like_a_number(row[i]);
      line += fmt::format("{}{}{}", i == 0 ? "" : "  ", right ? pad : row[i], right ? row[i] : pad);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::vector<std::string> list_names() {
  return {"methods", "machines", "ropes", "sections", "steels", "rules", "carriages", "yarders", "units"};
}

tl::expected<std::string, std::string> list_text(const std::string& what, const ListFilter& filter) {
  const Listing rows = rows_of(what, filter);
  if (rows) {
    if (auto refused = refused_filter(what, filter)) return tl::unexpected(std::move(*refused));
  }
  if (!rows) return tl::unexpected(rows.error());
  return fmt::format("{}{} {}\n", aligned(*rows), rows->size() - 1, what);
}

}  // namespace taut::app
