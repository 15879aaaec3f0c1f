#include "taut/calc/field_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "taut/units/display.hpp"

namespace taut {
namespace {

/// Slots are made for writing; here only their values are looked at.
Slot slot_in(const Field& f, const void* object) { return f.slot(const_cast<void*>(object)); }

DeckPlace place_below(const DeckPlace* up, const std::string& key) {
  return up == nullptr ? DeckPlace(key) : DeckPlace(*up, std::string_view(key));
}

/// Whether a key that excludes others is given; nothing where a value cannot tell, as it is always there. A flag that
/// is set is given, one that is not may be.
struct IsGiven {
  std::optional<bool> operator()(const double*) const { return std::nullopt; }
  std::optional<bool> operator()(const int*) const { return std::nullopt; }
  std::optional<bool> operator()(const Triple*) const { return std::nullopt; }
  std::optional<bool> operator()(const Choice&) const { return std::nullopt; }
  std::optional<bool> operator()(const bool* x) const { return *x ? std::optional(true) : std::nullopt; }
  std::optional<bool> operator()(const std::string* x) const { return !x->empty(); }
  std::optional<bool> operator()(const Record& x) const { return !x.all().empty(); }
  std::optional<bool> operator()(const NamedRecords& x) const { return !x.all().empty(); }
  template <class T>
  std::optional<bool> operator()(const std::optional<T>* x) const {
    return x->has_value();
  }
  template <class T>
  std::optional<bool> operator()(const std::vector<T>* x) const {
    return !x->empty();
  }
};

class StructCheck {
 public:
  std::vector<Complaint> run(const Description& d, const void* object) {
    look(d, object, nullptr);
    return std::move(complaints_);
  }

 private:
  void look(const Description& d, const void* object, const DeckPlace* up) {
    for (const Field& f : d.fields) {
      const DeckPlace place = place_below(up, f.key);
      if (f.map_form && look_at_map(f, object, place)) continue;
      std::visit([&](const auto& slot) { check(f, slot, place); }, slot_in(f, object));
    }
    for (const std::vector<std::string>& group : d.exactly_one) check_group(d, group, object, up);
  }

  /// The map in place of three components, which then do not count; false where there is none.
  bool look_at_map(const Field& f, const void* object, const DeckPlace& place) {
    const auto all = f.map_form(const_cast<void*>(object)).all();
    for (const void* one : all) look(*f.record, one, &place);
    return !all.empty();
  }

  void check(const Field& f, const double* x, const DeckPlace& place) { number(f, *x, place); }
  void check(const Field& f, const int* x, const DeckPlace& place) { number(f, *x, place); }
  void check(const Field&, const bool*, const DeckPlace&) {}
  void check(const Field&, const Choice&, const DeckPlace&) {}
  void check(const Field& f, const std::string* x, const DeckPlace& place) {
    if (f.required && x->empty()) complain(place, "the text is empty");
  }
  void check(const Field& f, const Triple* x, const DeckPlace& place) {
    for (const double component : *x) number(f, component, place);
  }
  template <class T>
  void check(const Field& f, const std::optional<T>* x, const DeckPlace& place) {
    if (*x) check(f, &**x, place);
  }
  void check(const Field& f, const std::vector<double>* x, const DeckPlace& place) {
    if (f.required && x->empty()) complain(place, "the list is empty");
    for (std::size_t i = 0; i < x->size(); ++i) number(f, (*x)[i], DeckPlace(place, i));
  }
  void check(const Field& f, const std::vector<std::string>* x, const DeckPlace& place) {
    if (f.required && x->empty()) complain(place, "the list is empty");
    for (std::size_t i = 0; i < x->size() && !f.choices.empty(); ++i) {
      const std::string& text = (*x)[i];
      if (std::find(f.choices.begin(), f.choices.end(), text) != f.choices.end()) continue;
      complain(DeckPlace(place, i), fmt::format("'{}' is not a choice; write {}", text, fmt::join(f.choices, ", ")));
    }
  }
  void check(const Field& f, const Record& record, const DeckPlace& place) {
    const std::vector<const void*> all = record.all();
    if (f.required && all.empty()) complain(place, f.is_list ? "the list is empty" : "is missing");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const DeckPlace entry = f.is_list ? DeckPlace(place, i) : place;
      look(*f.record, all[i], &entry);
    }
  }
  void check(const Field& f, const NamedRecords& named, const DeckPlace& place) {
    const auto all = named.all();
    for (auto one = all.begin(); one != all.end(); ++one) {
      const DeckPlace entry(place, one->first);
      if (one->first.empty() && !f.one_for_all) complain(place, "the name of an entry is empty");
      if (std::any_of(all.begin(), one, [&](const auto& earlier) { return earlier.first == one->first; }))
        complain(entry, fmt::format("another of '{}' is called so too: give this one another name", f.key));
      look(*f.record, one->second, &entry);
    }
  }

  void number(const Field& f, double x, const DeckPlace& place) {
    if (std::isnan(x)) {
      complain(place, "is not a number");
    } else if (std::isinf(x) && !f.may_be_infinite) {
      complain(place, "must be finite");
    } else if (!f.range.contains(x)) {
      complain(place, fmt::format("must be {}, not {}", range_text(f), Display().quantity(x, f.unit)));
    }
  }

  void check_group(const Description& d, const std::vector<std::string>& group, const void* object,
                   const DeckPlace* up) {
    std::vector<std::string> given;
    bool all_known = true;
    for (const std::string& key : group) {
      const Field* f = d.find(key);
      const std::optional<bool> is = f == nullptr ? std::nullopt : std::visit(IsGiven(), slot_in(*f, object));
      all_known = all_known && is.has_value();
      if (is.value_or(false)) given.push_back(key);
    }
    if (given.size() == 1 || (given.empty() && !all_known)) return;
    complaints_.push_back({up == nullptr ? std::string() : up->text(),
                           given.empty() ? fmt::format("needs one of {}", fmt::join(group, ", "))
                                         : fmt::format("give one of {}, not several", fmt::join(given, ", "))});
  }

  void complain(const DeckPlace& place, std::string message) {
    complaints_.push_back({place.text(), std::move(message)});
  }

  std::vector<Complaint> complaints_;
};

}  // namespace

std::vector<Complaint> broken_fields(const Description& description, const void* object) {
  return StructCheck().run(description, object);
}

}  // namespace taut
