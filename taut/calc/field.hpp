#pragma once
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "taut/units/unit.hpp"

namespace taut {

struct Description;

/// Allowed values of a number, in SI.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_included = true;
  bool high_included = true;
  bool contains(double x) const;
};

/// A text that stands for an enumerator.
struct Choice {
  std::function<bool(const std::string&)> set;  ///< false when the text is none of the choices
  std::function<std::string()> get;
};

/// A nested struct: one, an optional one, or a list.
struct Record {
  std::function<void*()> create;  ///< the struct to fill: the only one, or a new one at the end of the list
  std::function<std::vector<const void*>()> all;  ///< the structs that exist
};

/// Structs that the deck names: `points: {head: ..., tail: ...}`, in the order of the deck.
struct NamedRecords {
  std::function<void*(const std::string& name)> create;
  std::function<std::vector<std::pair<std::string, const void*>>()> all;
};

/// Three components of one quantity along x, y, z.
using Triple = std::array<double, 3>;

/// Pointer to the value of a field in one particular struct.
using Slot = std::variant<double*, std::optional<double>*, std::vector<double>*, int*, std::optional<int>*, bool*,
                          std::string*, std::optional<std::string>*, Choice, Record, Triple*, std::optional<Triple>*,
                          std::vector<std::string>*, NamedRecords>;

/// What a field holds.
enum class FieldKind {
  number,
  numbers,
  whole_number,
  flag,
  text,
  choice,
  record,
  records,
  triple,
  texts,
  named_records
};

/// Description of one key of a deck or of one result value. Deck reading, range errors, the schema, the section "Given"
/// of the report and the reference are all made from it.
struct Field {
  FieldKind kind = FieldKind::number;
  std::string key;     ///< the deck's key, or the name of a result value
  std::string symbol;  ///< the source's letter, "alpha_s"; may be empty
  Unit unit;
  std::string words;   ///< meaning, in one line
  std::string source;  ///< outputs: the equation it comes from, "(4)-(6)"
  Range range;
  bool required = false;
  bool may_be_infinite = false;
  bool is_list = false;  ///< a list of numbers (one number is a list of one), or of records
  std::vector<std::string> choices;
  const Description* record = nullptr;  ///< fields of a nested struct, or of the map that may replace a triple
  /// Of a triple: the struct for a map in its place, `at: {chainage: ...}`; it exists only where the deck has the map.
  std::function<Record(void*)> map_form;
  std::string shorthand;  ///< nested structs: a value that is not a map is taken as this field, `head: [0 m, 0 m, 1 m]`
  /// Named structs: the shorthand may replace the whole map; it is then one struct without a name.
  bool one_for_all = false;
  bool detail = false;  ///< outputs: not what the method is about, in the appendix of a report only
  bool rest = false;    ///< named structs: their maps stand directly beside the other keys, without this key
  std::function<Slot(void*)> slot;
};

/// A key that is reserved for a later version: taut reports it by name and does not read it.
struct LaterKey {
  std::string key;
  std::string words;  ///< why it is not computed yet, "contacts come with the dynamics"
};

/// The fields of one struct, and a function that makes the struct with its defaults.
struct Description {
  std::vector<Field> fields;
  std::vector<std::vector<std::string>> exactly_one;  ///< of each group the deck must give exactly one key
  std::vector<LaterKey> later;
  std::function<std::shared_ptr<void>()> make_default;

  const Field* find(const std::string& key) const;
  std::vector<std::string> keys() const;
};

/// The part of Describe that does not depend on the struct. It is compiled once, in field.cpp, because tables of fields
/// are long.
class DescriptionBuilder {
 public:
  operator Description() const { return description_; }  // the end of the chain

 protected:
  Field& add(FieldKind kind, std::string_view key, std::string_view symbol, const Unit& unit, std::string_view words);
  Field& add(FieldKind kind, std::string_view key, std::string_view words, const Description& record);
  Field& last() { return description_.fields.back(); }

  Description description_;
};

/// Builds the Description of struct `S`: each call adds a field, the modifiers after it change that field.
///   Describe<Input>().field(&Input::span, "span", "l", si::m, "horizontal span").required().above(0)
template <class S>
class Describe : public DescriptionBuilder {
 public:
  Describe() {
    description_.make_default = [] { return std::static_pointer_cast<void>(std::make_shared<S>()); };
  }

  /// A number, optional number, list of numbers, three components, whole number, flag, text or list of texts.
  template <class Member>
  Describe& field(Member S::*member, std::string_view key, std::string_view symbol, const Unit& unit,
                  std::string_view words) {
    add(kind_of_member<Member>(), key, symbol, unit, words).slot = [member](void* s) -> Slot {
      return &(static_cast<S*>(s)->*member);
    };
    return *this;
  }
  /// A flag or a text: no symbol, no unit.
  template <class Member>
  Describe& field(Member S::*member, std::string_view key, std::string_view words) {
    return field(member, key, "", si::one, words);
  }
  /// A text that stands for an enumerator.
  template <class E>
  Describe& choice(E S::*member, std::string_view key, std::vector<std::pair<std::string, E>> names,
                   std::string_view words) {
    Field& f = add(FieldKind::choice, key, "", si::one, words);
    for (const auto& [text, e] : names) f.choices.push_back(text);
    f.slot = [member, names = std::move(names)](void* s) -> Slot {
      E* target = &(static_cast<S*>(s)->*member);
      return Choice{[target, names](const std::string& text) {
                      for (const auto& [name, e] : names) {
                        if (name == text) return *target = e, true;
                      }
                      return false;
                    },
                    [target, names] {
                      for (const auto& [name, e] : names) {
                        if (e == *target) return name;
                      }
                      return std::string{};
                    }};
    };
    return *this;
  }
  /// A nested struct that always exists.
  template <class R>
  Describe& record(R S::*member, std::string_view key, std::string_view words) {
    add(FieldKind::record, key, words, R::describe()).slot = [member](void* s) -> Slot {
      R* r = &(static_cast<S*>(s)->*member);
      return Record{[r]() -> void* { return r; }, [r] { return std::vector<const void*>{r}; }};
    };
    return *this;
  }
  template <class R>
  Describe& record(std::optional<R> S::*member, std::string_view key, std::string_view words) {
    add(FieldKind::record, key, words, R::describe()).slot = [member](void* s) -> Slot {
      return record_of(&(static_cast<S*>(s)->*member));
    };
    return *this;
  }
  template <class R>
  Describe& record(std::vector<R> S::*member, std::string_view key, std::string_view words) {
    add(FieldKind::records, key, words, R::describe()).slot = [member](void* s) -> Slot {
      std::vector<R>* r = &(static_cast<S*>(s)->*member);
      return Record{[r]() -> void* { return &r->emplace_back(); },
                    [r] {
                      std::vector<const void*> all;
                      for (const R& one : *r) all.push_back(&one);
                      return all;
                    }};
    };
    return *this;
  }

  /// Structs that the deck names; R has a member `name`.
  template <class R>
  Describe& named_records(std::vector<R> S::*member, std::string_view key, std::string_view words) {
    add(FieldKind::named_records, key, words, R::describe()).slot = [member](void* s) -> Slot {
      std::vector<R>* r = &(static_cast<S*>(s)->*member);
      return NamedRecords{[r](const std::string& name) -> void* {
                            r->emplace_back().name = name;
                            return &r->back();
                          },
                          [r] {
                            std::vector<std::pair<std::string, const void*>> all;
                            for (const R& one : *r) all.emplace_back(one.name, &one);
                            return all;
                          }};
    };
    return *this;
  }
  /// A map that may replace the three components of the field before.
  template <class R>
  Describe& or_map(std::optional<R> S::*member) {
    last().record = &R::describe();
    last().map_form = [member](void* s) { return record_of(&(static_cast<S*>(s)->*member)); };
    return *this;
  }
  /// The deck must give exactly one of these keys.
  Describe& exactly_one(std::vector<std::string> keys) {
    return description_.exactly_one.push_back(std::move(keys)), *this;
  }
  Describe& later(std::string_view key, std::string_view words) {
    return description_.later.push_back({std::string(key), std::string(words)}), *this;
  }

  /// The texts allowed in a list of texts.
  Describe& of(std::vector<std::string> choices) { return last().choices = std::move(choices), *this; }
  Describe& shorthand(std::string_view key) { return last().shorthand = key, *this; }
  Describe& rest() { return last().rest = true, *this; }
  Describe& one_for_all() { return last().one_for_all = true, *this; }
  Describe& required() { return last().required = true, *this; }
  Describe& may_be_infinite() { return last().may_be_infinite = true, *this; }
  Describe& above(double low) { return last().range.low = low, last().range.low_included = false, *this; }
  Describe& at_least(double low) { return last().range.low = low, last().range.low_included = true, *this; }
  Describe& below(double high) { return last().range.high = high, last().range.high_included = false, *this; }
  Describe& at_most(double high) { return last().range.high = high, last().range.high_included = true, *this; }
  Describe& detail() { return last().detail = true, *this; }
  Describe& from(std::string_view source) { return last().source = source, *this; }

 private:
  template <class R>
  static Record record_of(std::optional<R>* r) {
    return Record{[r]() -> void* { return &r->emplace(); },
                  [r] { return r->has_value() ? std::vector<const void*>{&**r} : std::vector<const void*>{}; }};
  }
  template <class Member>
  static constexpr FieldKind kind_of_member() {
    if constexpr (std::is_same_v<Member, double> || std::is_same_v<Member, std::optional<double>>) {
      return FieldKind::number;
    } else if constexpr (std::is_same_v<Member, std::vector<double>>) {
      return FieldKind::numbers;
    } else if constexpr (std::is_same_v<Member, int> || std::is_same_v<Member, std::optional<int>>) {
      return FieldKind::whole_number;
    } else if constexpr (std::is_same_v<Member, bool>) {
      return FieldKind::flag;
    } else if constexpr (std::is_same_v<Member, Triple> || std::is_same_v<Member, std::optional<Triple>>) {
      return FieldKind::triple;
    } else if constexpr (std::is_same_v<Member, std::vector<std::string>>) {
      return FieldKind::texts;
    } else {
      static_assert(std::is_same_v<Member, std::string> || std::is_same_v<Member, std::optional<std::string>>);
      return FieldKind::text;
    }
  }
};

/// A place in a deck, "reevings[0].path[2].over", that is put into words only where something is wrong there: machines
/// are compiled by the thousand, mostly without a mistake. It refers to what it is made of, which must outlive it.
class DeckPlace {
 public:
  DeckPlace(const std::string& path) : key_(path) {}  // NOLINT(google-explicit-constructor)
  DeckPlace(const char* path) : key_(path) {}         // NOLINT(google-explicit-constructor)
  DeckPlace(const DeckPlace& list, std::size_t index) : up_(&list), index_(index) {}
  DeckPlace(const DeckPlace& up, std::string_view key) : up_(&up), key_(key) {}

  std::string text() const;

 private:
  const DeckPlace* up_ = nullptr;
  std::string_view key_;  ///< empty: an entry of a list
  std::size_t index_ = 0;
};

/// A violated rule that concerns several fields. `path`: place below `input` or `machine`, "span.load",
/// "cases[1].falls".
struct Complaint {
  std::string path;
  std::string message;
};

/// Default of a number as the struct sets it, in SI; empty for required ones, lists and records.
std::optional<double> default_number(const Description& d, const Field& f);
/// Default of a choice, text or flag; empty when there is none.
std::string default_text(const Description& d, const Field& f);

/// The range in words, with its limits in the unit shown: "above 0 m and at most 85 deg"; empty when there is no limit.
std::string range_text(const Field& f);

}  // namespace taut
