#include "taut/io/deck/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "taut/base/suggest.hpp"
#include "taut/units/display.hpp"
#include "taut/units/parse.hpp"

namespace taut::io {
namespace {

constexpr std::size_t most_keys_listed = 12;

/// One field being read.
class FieldReader {
 public:
  FieldReader(const Field& f, const Entry& entry, Diagnostics& mistakes) : f_(f), entry_(entry), mistakes_(mistakes) {}

  void operator()(double* x) const {
    if (const auto value = number(entry_.value)) *x = *value;
  }
  void operator()(std::optional<double>* x) const {
    if (const auto value = number(entry_.value)) *x = value;
  }
  void operator()(std::vector<double>* x) const {
    x->clear();
    const Node& n = entry_.value;
    if (n.kind != Node::Kind::sequence) {
      if (const auto value = number(n)) x->push_back(*value);
      return;
    }
    if (n.items.empty()) wrong(n.spot, "the list is empty");
    for (const Node& item : n.items) {
      if (enough(mistakes_)) return;
      if (const auto value = number(item)) x->push_back(*value);
    }
  }
  void operator()(int* x) const {
    if (const auto value = whole_number()) *x = *value;
  }
  void operator()(std::optional<int>* x) const {
    if (const auto value = whole_number()) *x = value;
  }
  void operator()(bool* x) const {
    if (!is_scalar(entry_.value, "true or false")) return;
    const std::string& text = entry_.value.text;
    const bool yes = text == "true" || text == "True" || text == "TRUE";
    const bool no = text == "false" || text == "False" || text == "FALSE";
    if (entry_.value.quoted || (!yes && !no)) {
      wrong(entry_.value.spot, fmt::format("{} is neither true nor false{}", in_quotes(text),
                                           entry_.value.quoted ? ": leave the quotes away" : ""));
      return;
    }
    *x = yes;
  }
  void operator()(std::string* x) const {
    if (is_text()) *x = entry_.value.text;
  }
  void operator()(std::optional<std::string>* x) const {
    if (is_text()) *x = entry_.value.text;
  }
  void operator()(Triple* x) const {
    if (const auto value = triple()) *x = *value;
  }
  void operator()(std::optional<Triple>* x) const {
    if (const auto value = triple()) *x = *value;
  }
  void operator()(std::vector<std::string>* x) const {
    x->clear();
    const Node& n = entry_.value;
    if (n.kind != Node::Kind::sequence) {
      if (one_text(n)) x->push_back(n.text);
      return;
    }
    for (const Node& item : n.items) {
      if (enough(mistakes_)) return;
      if (one_text(item)) x->push_back(item.text);
    }
  }
  void operator()(const Choice& choice) const {
    if (!is_scalar(entry_.value, fmt::format("one of {}", fmt::join(f_.choices, ", ")))) return;
    if (choice.set(entry_.value.text)) return;
    const std::string hint = did_you_mean(entry_.value.text, f_.choices);
    wrong(entry_.value.spot, fmt::format("{} is not a choice{}", in_quotes(entry_.value.text),
                                         hint.empty() ? fmt::format("; write {}", fmt::join(f_.choices, ", ")) : hint));
  }
  void operator()(const Record& record) const {
    if (f_.kind == FieldKind::records) {
      read_records(record);
    } else {
      read(in_record(entry_.value), *f_.record, record.create(), f_.key, mistakes_);
    }
  }
  void operator()(const NamedRecords& named) const {
    const Node& n = entry_.value;
    if (f_.one_for_all && n.kind == Node::Kind::scalar) {
      read(in_record(n), *f_.record, named.create({}), f_.key, mistakes_);
      return;
    }
    if (n.kind != Node::Kind::map) {
      wrong(n.spot, fmt::format("a map of names is expected ('name: ...' on each line), not {}", kind_text(n)));
      return;
    }
    for (const Entry& e : n.entries) {
      if (enough(mistakes_)) return;
      if (e.key.empty()) add(mistakes_, e.key_spot, fmt::format("{}: the name is empty", f_.key));
      Node value = in_record(e.value);
      if (e.value.kind == Node::Kind::null) value.spot = e.key_spot;
      const std::string what = f_.rest ? e.key : fmt::format("{}.{}", f_.key, e.key);
      read(value, *f_.record, named.create(e.key), what, mistakes_);
    }
  }

 private:
  void wrong(const Spot& spot, std::string_view message) const {
    add(mistakes_, spot, fmt::format("{}: {}", f_.key, message));
  }

  bool is_scalar(const Node& n, std::string_view expected) const {
    // an expression that is still there has no value, which has been reported (parameters.hpp)
    if (n.kind == Node::Kind::scalar) return n.text.empty() || n.text.front() != '=';
    if (n.kind == Node::Kind::null) {
      wrong(n.spot, fmt::format("there is no value; {} is expected", expected));
    } else {
      wrong(n.spot, fmt::format("{} is expected, not {}", expected, kind_text(n)));
    }
    return false;
  }

  bool is_text() const {
    if (!is_scalar(entry_.value, "a text")) return false;
    if (!f_.required || !entry_.value.text.empty()) return true;
    wrong(entry_.value.spot, "the text is empty");
    return false;
  }

  /// A text of a list; one of the choices when the field has some.
  bool one_text(const Node& n) const {
    if (!is_scalar(n, "a text")) return false;
    const auto& choices = f_.choices;
    if (choices.empty() || std::find(choices.begin(), choices.end(), n.text) != choices.end()) return true;
    const std::string hint = did_you_mean(n.text, choices);
    wrong(n.spot, fmt::format("{} is not a choice{}", in_quotes(n.text),
                              hint.empty() ? fmt::format("; write {}", fmt::join(choices, ", ")) : hint));
    return false;
  }

  std::optional<Triple> triple() const {
    const Node& n = entry_.value;
    if (n.kind != Node::Kind::sequence || n.items.size() != 3) {
      const std::string have =
          n.kind == Node::Kind::sequence ? fmt::format("{} of them", n.items.size()) : std::string(kind_text(n));
      wrong(n.spot,
            fmt::format("three components along x, y, z are expected, such as {}{}, not {}", example_value(f_),
                        f_.map_form ? fmt::format(" (or a map of {})", fmt::join(f_.record->keys(), ", ")) : "", have));
      return std::nullopt;
    }
    Triple all{};
    bool good = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = number(n.items[i]);
      good = good && value.has_value();
      all[i] = value.value_or(0);
    }
    return good ? std::optional(all) : std::nullopt;
  }

  std::optional<double> number(const Node& n) const {
    const std::string expected = f_.unit.needs_text()
                                     ? fmt::format("a {} such as '{}'", f_.unit.kind, example_number(f_))
                                     : fmt::format("a number such as {}", example_number(f_));
    if (!is_scalar(n, expected)) return std::nullopt;
    const auto value = parse_quantity(n.text, f_.unit, f_.may_be_infinite);
    if (!value) {
      const auto& e = value.error();
      wrong(n.inside(static_cast<std::size_t>(e.offset), static_cast<std::size_t>(e.width)), e.message);
      return std::nullopt;
    }
    if (n.is_difference) {
      wrong(n.spot,
            "a temperature is expected, and this is the difference of two: add it to one, as in '20 degC + 5 K'");
      return std::nullopt;
    }
    if (f_.range.contains(*value)) return *value;
    wrong(n.spot, fmt::format("must be {}, not {}", range_text(f_), n.text));
    return std::nullopt;
  }

  std::optional<int> whole_number() const {
    const Node& n = entry_.value;
    if (!is_scalar(n, fmt::format("a whole number such as {}", example_number(f_)))) return std::nullopt;
    const auto value = parse_number(n.text);
    if (!value) {
      const auto& e = value.error();
      wrong(n.inside(static_cast<std::size_t>(e.offset), static_cast<std::size_t>(e.width)), e.message);
    } else if (*value != std::floor(*value) || std::abs(*value) > std::numeric_limits<int>::max()) {
      wrong(n.spot, fmt::format("a whole number is expected, not {}", n.text));
    } else if (!f_.range.contains(*value)) {
      wrong(n.spot, fmt::format("must be {}, not {}", range_text(f_), n.text));
    } else {
      return static_cast<int>(*value);
    }
    return std::nullopt;
  }

  /// The node of a record; when its key has no value, an empty map at the key, so that what is missing is reported;
  /// when it stands for one field of the record, a map of that.
  Node in_record(const Node& n) const {
    const bool short_form = !f_.shorthand.empty() && n.kind != Node::Kind::map && n.kind != Node::Kind::null;
    if (n.kind != Node::Kind::null && !short_form) return n;
    Node map;
    map.kind = Node::Kind::map;
    map.spot = n.spot;
    if (short_form) map.entries.push_back({f_.shorthand, n.spot, n});
    return map;
  }

  void read_records(const Record& record) const {
    const Node& n = entry_.value;
    if (n.kind != Node::Kind::sequence) {
      const bool one = n.kind == Node::Kind::map;
      wrong(n.spot, fmt::format("a list is expected, not {}{}", kind_text(n),
                                one ? ": begin each entry with '- '" : ": one '- ' for each entry"));
      return;
    }
    if (n.items.empty()) wrong(n.spot, "the list is empty");
    for (std::size_t i = 0; i < n.items.size() && !enough(mistakes_); ++i) {
      read(in_record(n.items[i]), *f_.record, record.create(), fmt::format("{}[{}]", f_.key, i), mistakes_);
    }
  }

  static std::string example_number(const Field& f) {
    const std::string text = example_value(f);
    return text.front() == '[' ? text.substr(1, text.find_first_of(",]") - 1) : text;
  }

  const Field& f_;
  const Entry& entry_;
  Diagnostics& mistakes_;
};

/// Whether an entry is one of the named structs that stand beside the other fields.
bool is_rest(const Entry& e, const Description& d) {
  const auto rest = std::find_if(d.fields.begin(), d.fields.end(), [](const Field& f) { return f.rest; });
  const Field* own = d.find(e.key);
  if (rest == d.fields.end() || (own != nullptr && !own->rest)) return false;
  return e.value.kind == Node::Kind::map || !rest->shorthand.empty();
}

void note_unknown_keys(const Node& map, const Description& d, std::string_view what, Diagnostics& mistakes) {
  const std::vector<std::string> keys = d.keys();
  for (const Entry& e : map.entries) {
    if (enough(mistakes)) return;
    const Field* field = d.find(e.key);
    if (is_rest(e, d) || (field != nullptr && !field->rest)) continue;
    const auto later =
        std::find_if(d.later.begin(), d.later.end(), [&](const LaterKey& key) { return key.key == e.key; });
    if (later != d.later.end()) {
      add(mistakes, e.key_spot, fmt::format("{} of {} is not computed yet: {}", in_quotes(e.key), what, later->words));
      continue;
    }
    std::string hint = did_you_mean(e.key, keys);
    if (hint.empty() && !keys.empty() && keys.size() <= most_keys_listed) {
      hint = fmt::format("; it has {}", fmt::join(keys, ", "));
    }
    add(mistakes, e.key_spot, fmt::format("{} is not a field of {}{}", in_quotes(e.key), what, hint));
  }
}

void note_missing_keys(const Node& map, const Description& d, std::string_view what, Diagnostics& mistakes) {
  for (const Field& f : d.fields) {
    if (!f.required || map.find(f.key) != nullptr) continue;
    const std::string example = example_value(f);
    const std::string write = example.empty() ? std::string{} : fmt::format("; write '{}: {}'", f.key, example);
    const std::string words = f.words.empty() ? std::string{} : fmt::format(" ({})", f.words);
    add(mistakes, map.spot, fmt::format("{} lacks '{}'{}{}", what, f.key, words, write));
  }
}

void note_exclusive_keys(const Node& map, const Description& d, std::string_view what, Diagnostics& mistakes) {
  for (const std::vector<std::string>& group : d.exactly_one) {
    const Entry* first = nullptr;
    for (const Entry& e : map.entries) {
      if (std::find(group.begin(), group.end(), e.key) == group.end()) continue;
      if (first != nullptr) {
        add(mistakes, e.key_spot, fmt::format("{}: {} has '{}' already; give one of the two", e.key, what, first->key));
      } else {
        first = &e;
      }
    }
    if (first != nullptr) continue;
    const bool waits = std::any_of(map.entries.begin(), map.entries.end(), [&](const Entry& e) {
      return std::any_of(d.later.begin(), d.later.end(), [&](const LaterKey& key) { return key.key == e.key; });
    });
    // a key that is reported as not computed yet may be the one
    if (!waits) add(mistakes, map.spot, fmt::format("{} needs one of {}", what, fmt::join(group, ", ")));
  }
}

/// A round number in the unit of print that the range allows.
double example_in(const Unit& unit, const Range& range) {
  const Display display;
  const bool whole_turn = unit.is_angle;
  const double zero = display.from_si(0.0, unit);  // degrees Celsius have an offset
  for (const double shown :
       {whole_turn ? 30.0 : 1.0, 10.0, 100.0, 2.0, 0.5, 0.1, 5.0, 20.0, 50.0, 0.01, 1000.0, -1.0}) {
    const double si = (shown - zero) / (display.from_si(1.0, unit) - zero);
    if (range.contains(si)) return shown;
  }
  const double inner = std::isfinite(range.low) && std::isfinite(range.high) ? (range.low + range.high) / 2
                       : std::isfinite(range.low)                            ? range.low * 2 + 1
                                                                             : range.high * 2 - 1;
  return display.from_si(inner, unit);
}

}  // namespace

bool read(const Node& map, const Description& description, void* object, std::string_view what, Diagnostics& mistakes) {
  const std::size_t before = mistakes.size();
  if (map.kind != Node::Kind::map) {
    add(mistakes, map.spot,
        fmt::format("{}: a map of fields is expected ('key: value' on each line), not {}", what, kind_text(map)));
    return false;
  }
  note_unknown_keys(map, description, what, mistakes);
  for (const Field& f : description.fields) {
    if (f.rest) {
      Entry rest{.key = f.key, .key_spot = map.spot, .value = map};
      std::erase_if(rest.value.entries, [&](const Entry& e) { return !is_rest(e, description); });
      FieldReader(f, rest, mistakes)(std::get<NamedRecords>(f.slot(object)));
      continue;
    }
    const Entry* entry = map.find_entry(f.key);
    if (entry == nullptr) continue;
    const bool as_map = f.map_form && entry->value.kind == Node::Kind::map;
    std::visit(FieldReader(f, *entry, mistakes), as_map ? Slot(f.map_form(object)) : f.slot(object));
  }
  note_missing_keys(map, description, what, mistakes);
  note_exclusive_keys(map, description, what, mistakes);
  return mistakes.size() == before && before < most_mistakes;
}

bool has_expression(const Node& input) {
  if (input.kind == Node::Kind::scalar) return !input.text.empty() && input.text.front() == '=';
  return std::any_of(input.items.begin(), input.items.end(), has_expression) ||
         std::any_of(input.entries.begin(), input.entries.end(),
                     [](const Entry& e) { return has_expression(e.value); });
}

void place(const Node& input, const std::vector<Complaint>& complaints, Diagnostics& mistakes) {
  for (const Complaint& c : complaints) {
    const Found found = follow(input, c.path);
    add(mistakes, found.node->spot, c.path.empty() ? c.message : fmt::format("{}: {}", c.path, c.message));
  }
}

std::string example_value(const Field& f) {
  switch (f.kind) {
    case FieldKind::number:
    case FieldKind::numbers:
    case FieldKind::triple: {
      const std::string number = short_number(example_in(f.unit, f.range));
      const std::string text = f.unit.needs_text() ? fmt::format("{} {}", number, f.unit.shown) : number;
      if (f.kind == FieldKind::triple) return fmt::format("[{0}, {0}, {0}]", text);
      return f.kind == FieldKind::numbers ? fmt::format("[{0}, {0}]", text) : text;
    }
    case FieldKind::whole_number:
      return short_number(std::ceil(example_in(f.unit, f.range)));
    case FieldKind::flag:
      return "true";
    case FieldKind::choice:
      return f.choices.empty() ? std::string{} : f.choices.front();
    case FieldKind::texts:
      return f.choices.empty() ? std::string{} : fmt::format("[{}]", f.choices.front());
    case FieldKind::text:
    case FieldKind::record:
    case FieldKind::records:
    case FieldKind::named_records:
      return {};
  }
  return {};
}

}  // namespace taut::io
