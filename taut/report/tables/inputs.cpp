#include "taut/report/tables/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr int widest_row = 100;      ///< characters of a table that stand side by side on a page
constexpr int least_of_others = 50;  ///< of them for the column that holds what has no other

bool is_default(const Given& g) { return g.is_default && !g.chosen; }

/// Of a deck's blocks those whose parts have names: "machine.points.stump.at".
bool has_named_parts(std::string_view block) { return block == "machine" || block == "checks" || block == "design"; }

std::vector<std::string_view> tokens_of(std::string_view key) {
  std::vector<std::string_view> tokens;
  for (std::size_t at = 0; at <= key.size();) {
    const std::size_t end = std::min(key.find('.', at), key.size());
    tokens.push_back(key.substr(at, end - at));
    at = end + 1;
  }
  return tokens;
}

/// The number in "[3]"; nothing for anything else.
std::optional<std::size_t> index_in(std::string_view brackets) {
  if (brackets.size() < 3 || brackets.front() != '[' || brackets.back() != ']') return std::nullopt;
  std::size_t index = 0;
  const char* last = brackets.data() + brackets.size() - 1;
  const auto [end, error] = std::from_chars(brackets.data() + 1, last, index);
  return error == std::errc{} && end == last ? std::optional(index) : std::nullopt;
}

/// Keys below keys, as a deck writes them.
struct Branch {
  std::string key;   ///< empty for the entries of a list
  std::string text;  ///< of a leaf
  std::vector<Branch> below = {};

  Branch& at(std::string_view name) {
    const auto known = std::find_if(below.begin(), below.end(), [&](const Branch& b) { return b.key == name; });
    if (known != below.end()) return *known;
    below.push_back({.key = std::string(name), .text = {}});
    return below.back();
  }
};

std::string flow_of(const Branch& b) {
  if (b.below.empty()) return b.text;
  const bool list = b.below.front().key.starts_with('[');
  std::string out;
  for (const Branch& one : b.below) {
    if (!out.empty()) out += ", ";
    out += list ? flow_of(one) : fmt::format("{}: {}", one.key, flow_of(one));
  }
  return list ? "[" + out + "]" : "{" + out + "}";
}

void put(Branch& root, std::string_view field, std::string text) {
  Branch* at = &root;
  for (const std::string_view token : tokens_of(field)) {
    const std::size_t open = token.find('[');
    at = &at->at(token.substr(0, open));
    if (open != std::string_view::npos) at = &at->at(token.substr(open));
  }
  at->text = std::move(text);
}

/// A part: what the deck gives of it, and the first key of all that it has.
struct Part {
  std::string name;
  std::vector<std::pair<std::string, const Given*>> fields = {};
  std::string kind = {};  ///< "equilibrium" where all keys are below that one
  const Given* find(std::string_view field) const {
    const auto at = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.first == field; });
    return at == fields.end() ? nullptr : at->second;
  }
};

struct PartList {
  std::string list;
  std::vector<Part> parts = {};
  std::map<std::string, std::size_t, std::less<>> by_name = {};

  Part& part(const std::string& name) {
    const auto [at, is_new] = by_name.try_emplace(name, parts.size());
    if (is_new) parts.push_back({.name = name});
    return parts[at->second];
  }
};

std::vector<PartList> lists_of(const std::vector<Given>& given) {
  std::vector<PartList> all;
  std::map<std::string, std::size_t, std::less<>> by_key;
  const std::vector<InputPlace> places = places_of(given);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Given& g = given[i];
    const InputPlace& place = places[i];
    if (place.list.empty()) continue;
    const auto [at, is_new] = by_key.try_emplace(place.list, all.size());
    if (is_new) all.push_back({.list = place.list});
    Part& part = all[at->second].part(place.record);
    const std::string first = place.field.substr(0, place.field.find('.'));
    const bool has_more = first.size() < place.field.size();
    if (has_more && part.kind.empty()) part.kind = first;
    if (!has_more || part.kind != first) part.kind = "-";
    if (!is_default(g)) part.fields.emplace_back(place.field, &g);
  }
  return all;
}

/// The fields that at least half of the parts give, in the order in which they come.
std::vector<std::string> common_fields(const PartList& list) {
  std::vector<std::pair<std::string, std::size_t>> count;
  for (const Part& part : list.parts) {
    for (const auto& [field, given] : part.fields) {
      if (field.find_first_of(".[") != std::string::npos || given->numbers.size() > 3) continue;
      const auto known =
          std::find_if(count.begin(), count.end(), [&name = field](const auto& c) { return c.first == name; });
      if (known == count.end()) {
        count.emplace_back(field, 1);
      } else {
        ++known->second;
      }
    }
  }
  std::vector<std::string> fields;
  for (const auto& [field, times] : count) {
    if (2 * times >= list.parts.size()) fields.push_back(field);
  }
  return fields;
}

/// Whether every part that gives this field gives three numbers, as a place has.
bool is_place(const PartList& list, std::string_view field) {
  return field == "at" && std::all_of(list.parts.begin(), list.parts.end(), [&](const Part& part) {
           const Given* g = part.find(field);
           return g == nullptr || g->numbers.size() == 3;
         });
}

std::string shown_list(const std::vector<double>& numbers, const ShownUnit& u) {
  std::string out;
  for (const double x : numbers) out += (out.empty() ? "" : ", ") + number_shown(u.of(x), 6);
  return out;
}

/// FNV-1a over the numbers in full precision.
std::uint64_t fingerprint(const std::vector<double>& numbers) {
  std::uint64_t hash = 14695981039346656037U;
  for (const double x : numbers) {
    for (const char c : fmt::format("{:.17g} ", x)) {
      hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    }
  }
  return hash;
}

std::string without_unit(const Given& g, const ShownUnit& u) {
  if (g.numbers.empty()) return g.text;
  if (g.numbers.size() == 1) return number_shown(u.of(g.numbers[0]), 6);
  return "[" + shown_list(g.numbers, u) + "]";
}

int width_of_column(const InputTable& t, std::size_t k) {
  int width = std::max(length(t.columns[k].name), length(t.columns[k].unit));
  for (const auto& row : t.rows) width = std::max(width, length(row[k].text));
  return width + 2;
}

/// A column, or three, for a field; false when the page has no room beside the others.
bool add_column(const PartList& list, const std::string& field, int most_width, const Display& display, InputTable& t) {
  InputTable more{.list = {}, .title = {}, .columns = {}, .rows = t.rows};
  const bool place = is_place(list, field);
  const std::size_t columns = place ? 3 : 1;
  constexpr std::array<const char*, 3> axes{"x", "y", "z"};
  more.columns = t.columns;
  for (std::size_t k = 0; k < columns; ++k) {
    more.columns.push_back({.name = place ? axes[k] : field, .words = {}, .unit = {}});
  }
  for (std::size_t i = 0; i < list.parts.size(); ++i) {
    const Given* g = list.parts[i].find(field);
    for (std::size_t k = 0; k < columns; ++k) {
      InputColumn& column = more.columns[t.columns.size() + k];
      InputCell cell;
      if (g != nullptr) {
        const ShownUnit u = shown_unit(g->unit, display);
        column.words = g->words;
        column.unit = unit_text(u);
        column.numbers = column.numbers || !g->numbers.empty();
        cell = {.text = place ? number_shown(u.of(g->numbers[k]), 6) : without_unit(*g, u), .chosen = g->chosen};
      }
      more.rows[i].push_back(cell);
    }
  }
  int width = 0;
  for (std::size_t k = 0; k < more.columns.size(); ++k) width += width_of_column(more, k);
  if (width > most_width) return false;
  t.columns = std::move(more.columns);
  t.rows = std::move(more.rows);
  return true;
}

/// What has no column, in the deck's spelling.
InputCell other_fields(const Part& part, const std::vector<std::string>& shown, const Display& display) {
  Branch root;
  InputCell cell;
  for (const auto& [field, given] : part.fields) {
    if (std::find(shown.begin(), shown.end(), field) != shown.end()) continue;
    put(root, field, input_text(*given, display) + (given->chosen ? " (chosen)" : ""));
  }
  if (part.fields.empty() && part.kind != "-") {
    cell.text = part.kind + ": {}";
  } else if (!root.below.empty()) {
    const std::string flow = flow_of(root);
    cell.text = flow.substr(1, flow.size() - 2);
  }
  return cell;
}

std::string list_title(std::string_view list) {
  const std::size_t dot = list.find('.');
  const bool of_block = dot != std::string_view::npos && list.substr(0, dot) != "machine";
  std::string name(list.substr(dot == std::string_view::npos ? 0 : dot + 1));
  if (of_block) name = fmt::format("{} of {}", list.substr(0, dot), name);
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

InputTable table_of(const PartList& list, const Display& display) {
  InputTable t{.list = list.list, .title = list_title(list.list), .columns = {}, .rows = {}};
  t.columns.push_back({.name = "", .words = {}, .unit = {}});
  for (const Part& part : list.parts) t.rows.push_back({{.text = part.name}});
  const std::vector<std::string> common = common_fields(list);
  int others_width = 0;
  for (const Part& part : list.parts) {
    others_width = std::max(others_width, length(other_fields(part, common, display).text));
  }
  const int most_width = widest_row - std::min(others_width, least_of_others);
  std::vector<std::string> shown;
  for (const std::string& field : common) {
    if (add_column(list, field, most_width, display, t)) shown.push_back(field);
  }
  std::vector<InputCell> others;
  others.reserve(list.parts.size());
  for (const Part& part : list.parts) others.push_back(other_fields(part, shown, display));
  if (std::all_of(others.begin(), others.end(), [](const InputCell& c) { return c.text.empty(); })) return t;
  t.columns.push_back({.name = shown.empty() ? "as given" : "also", .words = {}, .unit = {}});
  for (std::size_t i = 0; i < others.size(); ++i) t.rows[i].push_back(std::move(others[i]));
  return t;
}

}  // namespace

InputPlace place_of(std::string_view key) {
  const std::size_t open = key.find('[');
  const std::vector<std::string_view> tokens = tokens_of(key.substr(0, open));
  constexpr std::size_t block_kind_name = 3;
  if (has_named_parts(tokens[0]) && tokens.size() > block_kind_name) {
    const std::size_t list = tokens[0].size() + 1 + tokens[1].size(), record = list + 1 + tokens[2].size();
    return {.list = std::string(key.substr(0, list)),
            .record = std::string(tokens[2]),
            .field = std::string(key.substr(record + 1))};
  }
  if (open == std::string_view::npos || open == 0) return {};
  const std::size_t close = key.find(']', open);
  if (close == std::string_view::npos || close + 2 >= key.size() || key[close + 1] != '.') return {};
  const auto index = index_in(key.substr(open, close + 1 - open));
  if (!index) return {};
  return {.list = std::string(key.substr(0, open)),
          .record = std::to_string(*index + 1),
          .field = std::string(key.substr(close + 2))};
}

std::vector<InputPlace> places_of(const std::vector<Given>& given) {
  std::vector<InputPlace> places;
  std::set<std::pair<std::string, std::string>> whole;  // names with something directly below them
  for (const Given& g : given) {
    places.push_back(place_of(g.key));
    const InputPlace& p = places.back();
    if (p.field.find('.') == std::string::npos || g.key[p.list.size()] == '[') whole.emplace(p.list, p.record);
  }
  for (InputPlace& p : places) {
    const std::size_t dot = p.field.find('.');
    if (dot == std::string::npos || whole.contains({p.list, p.record})) continue;
    p.record += "." + p.field.substr(0, dot);
    p.field = p.field.substr(dot + 1);
  }
  return places;
}

std::vector<InputTable> input_tables(const std::vector<Given>& given, const Display& display) {
  std::vector<InputTable> tables;
  for (const PartList& list : lists_of(given)) tables.push_back(table_of(list, display));
  return tables;
}

std::vector<const Given*> single_inputs(const std::vector<Given>& given, bool defaults) {
  std::vector<const Given*> single;
  for (const Given& g : given) {
    if (is_default(g) == defaults && place_of(g.key).list.empty()) single.push_back(&g);
  }
  return single;
}

std::vector<InputDefault> input_defaults(const std::vector<Given>& given, const Display& display) {
  std::vector<InputDefault> all;
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  const std::vector<InputPlace> places = places_of(given);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Given& g = given[i];
    const InputPlace& place = places[i];
    if (!is_default(g)) continue;
    if (place.list.empty()) {
      all.push_back({.given = &g, .key = g.key, .parts = {}});
      continue;
    }
    const std::string key = fmt::format("{}.*.{}", place.list, place.field);
    const auto [at, is_new] = known.try_emplace({key, input_text(g, display)}, all.size());
    if (is_new) {
      all.push_back({.given = &g, .key = key, .parts = place.record});
    } else {
      all[at->second].parts += ", " + place.record;
    }
  }
  return all;
}

std::string input_text(const Given& g, const Display& display) {
  const ShownUnit u = shown_unit(g.unit, display);
  const std::string unit = unit_text(u);
  std::string text = without_unit(g, u);
  if (g.numbers.size() > most_numbers_of_input) {
    text = fmt::format("{} numbers, {} … {}, fingerprint {:016x}", g.numbers.size(),
                       number_shown(u.of(g.numbers.front()), 6), number_shown(u.of(g.numbers.back()), 6),
                       fingerprint(g.numbers));
  }
  if (unit.empty() || g.numbers.empty()) return text;
  return unit == "°" ? text + unit : fmt::format("{} {}", text, unit);
}

}  // namespace taut::report
