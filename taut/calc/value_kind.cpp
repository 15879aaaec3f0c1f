#include "taut/calc/value_kind.hpp"

#include <algorithm>
#include <cctype>

namespace taut {
namespace {

constexpr std::string_view between_words = "._";

bool stands_for_something(std::string_view word) {
  const bool capitals = std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isupper(c) != 0; });
  return capitals && (word.size() >= 3 || word == "N");
}

}  // namespace

const ValueKind& named(const std::vector<ValueKind>& kinds, std::string_view name) {
  for (const ValueKind& one : kinds) {
    if (one.about.name == name) return one;
  }
  no_such_quantity(name);
}

std::string name_with(std::string_view name, std::string_view part) {
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t end = std::min(name.find_first_of(between_words, at), name.size());
    if (stands_for_something(name.substr(at, end - at))) {
      return std::string(name.substr(0, at)).append(part).append(name.substr(end));
    }
    at = end + 1;
  }
  return std::string(name);
}

Value make_value(const ValueKind& kind, const std::string& part, const std::string& ending, double x,
                 const std::string& label) {
  Value value;
  value.name = name_with(kind.about.name, part) + ending;
  value.value = x;
  value.unit = kind.about.unit;
  value.symbol = kind.about.symbol.empty() ? value.name : name_with(kind.about.symbol, part);
  value.label = label;
  value.detail = kind.about.detail;
  return value;
}

std::vector<ValueKind> kinds_of(const std::vector<QuantityWords>& words, const std::string& of,
                                const std::string& page) {
  std::vector<ValueKind> all;
  all.reserve(words.size());
  for (const QuantityWords& one : words) all.push_back({.about = one, .of = of, .page = page});
  return all;
}

}  // namespace taut
