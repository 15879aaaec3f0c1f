#include "taut/study/deck/parameter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "taut/base/suggest.hpp"
#include "taut/units/parse.hpp"

namespace taut::study {
namespace {

using Found = tl::expected<Parameter, std::string>;

/// "a.b[2].c" as a, b, 2, c. Names with dots are put together again where they are looked for.
std::vector<std::string> steps_of(const std::string& path) {
  std::vector<std::string> steps(1);
  for (const char c : path) {
    if (c == '.' || c == '[') {
      steps.emplace_back();
    } else if (c != ']') {
      steps.back() += c;
    }
  }
  std::erase(steps, std::string{});
  return steps;
}

std::optional<std::size_t> number_of(const std::string& text) {
  std::size_t n = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (code != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return n;
}

std::string text_of(const Field& f, void* object) {
  const Slot slot = f.slot(object);
  if (const auto* text = std::get_if<std::string*>(&slot)) return **text;
  if (const auto* text = std::get_if<std::optional<std::string>*>(&slot)) return (*text)->value_or("");
  return {};
}

class Finder {
 public:
  explicit Finder(const std::string& path) : path_(path), steps_(steps_of(path)) {}

  Found find(const Description& d, void* object) { return in_struct(d, object, 0); }

 private:
  /// Words for what is wrong at a step.
  Found no(std::size_t at, const std::string& why) const {
    const std::string step = at < steps_.size() ? steps_[at] : std::string{};
    return tl::unexpected(step.empty() ? fmt::format("'{}': {}", path_, why)
                                       : fmt::format("'{}': {} {}", path_, fmt::format("'{}'", step), why));
  }

  Found in_struct(const Description& d, void* object, std::size_t at) {
    if (at >= steps_.size()) return no(at, "names a group of fields, not a number");
    const Field* f = d.find(steps_[at]);
    if (f == nullptr || f->rest)
      return no(at, fmt::format("is not a field there{}", did_you_mean(steps_[at], d.keys())));
    return in_field(*f, object, at + 1);
  }

  void enter(const std::string& key) { place_ += place_.empty() ? key : "." + key; }
  void enter(std::size_t index) { place_ += fmt::format("[{}]", index); }

  Found in_field(const Field& f, void* object, std::size_t at) {
    enter(f.key);
    if (f.map_form) {
      const Record map = f.map_form(object);
      if (!map.all().empty()) return in_record(f, map, at);
    }
    const Slot slot = f.slot(object);
    if (auto* const* x = std::get_if<double*>(&slot)) return number(f, at, **x, [p = *x](double v) { *p = v; });
    if (auto* const* x = std::get_if<std::optional<double>*>(&slot)) {
      return number(f, at, (*x)->value_or(std::nan("")), [p = *x](double v) { *p = v; });
    }
    if (auto* const* x = std::get_if<Triple*>(&slot)) return component(f, at, **x);
    if (auto* const* x = std::get_if<std::optional<Triple>*>(&slot)) {
      return *x != nullptr && (*x)->has_value() ? component(f, at, ***x) : no(at, "is not given in the deck");
    }
    if (auto* const* x = std::get_if<std::vector<double>*>(&slot)) return element(f, at, **x);
    if (const auto* record = std::get_if<Record>(&slot)) return in_record(f, *record, at);
    if (const auto* named = std::get_if<NamedRecords>(&slot)) return in_named(f, *named, at);
    if (std::holds_alternative<int*>(slot) || std::holds_alternative<std::optional<int>*>(slot)) {
      return tl::unexpected(fmt::format("'{}': is a whole number; what changes by steps can't be followed", path_));
    }
    return tl::unexpected(fmt::format("'{}': is not a number", path_));
  }

  Found number(const Field& f, std::size_t at, double now, std::function<void(double)> set) const {
    if (at < steps_.size()) return no(at, "is beyond a number");
    return Parameter{.field = &f, .unit = f.unit, .value = now, .set = std::move(set), .path = path_, .place = place_};
  }

  Found component(const Field& f, std::size_t at, Triple& v) {
    if (at >= steps_.size()) return no(at, "is a vector: name a component, [0], [1], [2] or x, y, z, or its angle");
    if (at + 1 < steps_.size()) return no(at + 1, "is beyond a component");
    Triple* const p = &v;
    if (steps_[at] == "angle") {
      const double length = std::hypot(v[0], v[2]);
      if (!(length > 0)) return no(at, "of a vector without length in the plane of x and z");
      enter("angle");
      return Parameter{.field = &f,
                       .unit = si::rad,
                       .value = std::atan2(v[2], v[0]),
                       .set =
                           [p, length](double angle) {
                             (*p)[0] = length * std::cos(angle);
                             (*p)[2] = length * std::sin(angle);
                           },
                       .path = path_,
                       .place = place_};
    }
    auto i = number_of(steps_[at]);
    if (steps_[at] == "x") i = 0;
    if (steps_[at] == "y") i = 1;
    if (steps_[at] == "z") i = 2;
    if (!i || *i > 2) return no(at, "is not a component: x, y, z, [0], [1], [2] or angle");
    enter(*i);
    return Parameter{.field = &f,
                     .unit = f.unit,
                     .value = v[*i],
                     .set = [p, k = *i](double x) { (*p)[k] = x; },
                     .path = path_,
                     .place = place_};
  }

  Found element(const Field& f, std::size_t at, std::vector<double>& v) {
    const auto i = at < steps_.size() ? number_of(steps_[at]) : std::nullopt;
    if (!i || *i >= v.size()) return no(at, fmt::format("is not one of its {} numbers, [0] and so on", v.size()));
    if (at + 1 < steps_.size()) return no(at + 1, "is beyond a number");
    enter(*i);
    return Parameter{.field = &f,
                     .unit = f.unit,
                     .value = v[*i],
                     .set = [p = &v, k = *i](double x) { (*p)[k] = x; },
                     .path = path_,
                     .place = place_};
  }

  /// Entries of a list, and by how many steps they are named.
  struct Called {
    std::vector<std::size_t> entries;
    std::size_t steps = 0;
  };

  /// The entries that the step calls by what they have at a key; `known`: all that they have there.
  Called called(const Description& entry, const char* key, const std::vector<void*>& all, std::size_t at,
                std::vector<std::string>& known) const {
    Called found;
    const Field* text = entry.find(key);
    if (text == nullptr || text->kind != FieldKind::text) return found;
    for (std::size_t i = 0; i < all.size(); ++i) {
      known.push_back(text_of(*text, all[i]));
      const std::size_t count = fits(known.back(), at);
      if (count > found.steps) found = {.entries = {}, .steps = count};  // "a.b" before "a"
      if (count > 0 && count == found.steps) found.entries.push_back(i);
    }
    // what has no name of its own is called by its rope, place or body
    const Field* name = entry.find("name");
    const auto named = [&](std::size_t i) { return name != nullptr && !text_of(*name, all[i]).empty(); };
    auto& entries = found.entries;
    if (const auto own = std::find_if_not(entries.begin(), entries.end(), named);
        own != entries.end() && std::all_of(own + 1, entries.end(), named)) {
      entries = {*own};
    }
    return found;
  }

  Found in_record(const Field& f, const Record& record, std::size_t at) {
    std::vector<void*> all;
    all.reserve(record.all().size());
    // the slot was made of an object that may be changed
    for (const void* one : record.all()) all.push_back(const_cast<void*>(one));
    if (!f.is_list) {
      if (all.empty()) return no(at, "is part of something that the deck does not have");
      return in_struct(*f.record, all.front(), at);
    }
    if (at >= steps_.size()) return no(at, "is a list: name an entry, [0] and so on");
    if (const auto i = number_of(steps_[at])) {
      if (*i >= all.size()) return no(at, fmt::format("is not one of its {} entries", all.size()));
      enter(*i);
      return in_struct(*f.record, all[*i], at + 1);
    }
    std::vector<std::string> known;
    for (const char* key : {"name", "rope", "at", "body"}) {
      const auto [entries, steps] = called(*f.record, key, all, at, known);
      if (entries.size() > 1) {
        return no(at, fmt::format("is the '{}' of {} entries: write the index of one, [{}]", key, entries.size(),
                                  fmt::join(entries, "], [")));
      }
      if (entries.empty()) continue;
      enter(entries.front());
      return in_struct(*f.record, all[entries.front()], at + steps);
    }
    return no(at, fmt::format("is not an entry of the list{}", did_you_mean(steps_[at], known)));
  }

  Found in_named(const Field& f, const NamedRecords& named, std::size_t at) {
    if (at >= steps_.size()) return no(at, "is a map of names: name one");
    std::vector<std::string> known;
    const std::string* found = nullptr;
    void* object = nullptr;
    std::size_t longest = 0;  // "a.b" before "a"
    const auto all = named.all();
    for (const auto& [name, one] : all) {
      known.push_back(name);
      const std::size_t count = fits(name, at);
      if (count <= longest) continue;
      longest = count;
      found = &name;
      object = const_cast<void*>(one);
    }
    if (found == nullptr) return no(at, fmt::format("is not among them{}", did_you_mean(steps_[at], known)));
    enter(*found);
    const std::size_t next = at + longest;
    const Field* alone = f.shorthand.empty() ? nullptr : f.record->find(f.shorthand);
    const bool short_form = alone != nullptr && (next >= steps_.size() || f.record->find(steps_[next]) == nullptr);
    return short_form ? in_field(*alone, object, next) : in_struct(*f.record, object, next);
  }

  /// How many steps from there on are this name, which may have dots; 0: they are not.
  std::size_t fits(const std::string& name, std::size_t at) const {
    const auto own = steps_of(name);
    const bool same = steps_.size() - at >= own.size() &&
                      std::equal(own.begin(), own.end(), steps_.begin() + static_cast<std::ptrdiff_t>(at));
    return same ? own.size() : 0;
  }

  std::string path_;
  std::vector<std::string> steps_;
  std::string place_;  ///< by field and index, of the steps that were gone
};

}  // namespace

tl::expected<Parameter, std::string> find_parameter(const Description& description, void* object,
                                                    const std::string& path) {
  return parameter_at(description, object, path.starts_with("machine.") ? path.substr(8) : path);
}

tl::expected<Parameter, std::string> parameter_at(const Description& description, void* object,
                                                  const std::string& path) {
  return Finder(path).find(description, object);
}

Range Parameter::range() const { return unit.is_angle && !field->unit.is_angle ? Range{} : field->range; }

Outcome put(const Parameter& parameter, double value) {
  if (!std::isfinite(value) || !parameter.range().contains(value)) {
    return infeasible(fmt::format("'{}' must be {}", parameter.path, range_text(*parameter.field)));
  }
  parameter.set(value);
  return {};
}

std::optional<double> value_of(const std::string& text, const Parameter& parameter, const std::string& path,
                               std::vector<Complaint>& complaints) {
  const auto number = parse_quantity(text, parameter.unit);
  if (!number) {
    complaints.push_back({path, number.error().message});
    return {};
  }
  if (!parameter.range().contains(*number)) {
    complaints.push_back({path, fmt::format("must be {}, not {}", range_text(*parameter.field), text)});
    return {};
  }
  return *number;
}

std::string below_machine(const std::string& path) { return path.starts_with("machine.") ? path.substr(8) : path; }

}  // namespace taut::study
