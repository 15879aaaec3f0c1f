#include "web/deck_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "taut/io/deck/document.hpp"
#include "taut/units/parse.hpp"

namespace taut::web {
namespace {

using Json = nlohmann::ordered_json;

/// Bytes of a UTF-8 text as UTF-16 units of the same text.
class Utf16 {
 public:
  explicit Utf16(std::string_view text) {
    at_.reserve(text.size() + 1);
    std::size_t units = 0;
    for (const char c : text) {
      at_.push_back(units);
      const auto byte = static_cast<unsigned char>(c);
      if ((byte & 0xC0U) != 0x80U) units += byte >= 0xF0U ? 2 : 1;
    }
    at_.push_back(units);
  }
  std::size_t operator()(std::size_t byte) const { return at_[std::min(byte, at_.size() - 1)]; }

 private:
  std::vector<std::size_t> at_;
};

struct Range {
  std::size_t from = 0, to = 0;
};

Range range_of(const io::Node& n) {
  Range r{n.spot.offset, n.spot.offset + n.spot.width};
  for (const io::Node& item : n.items) r.to = std::max(r.to, range_of(item).to);
  for (const io::Entry& e : n.entries) {
    r.from = std::min(r.from, e.key_spot.offset);
    r.to = std::max({r.to, e.key_spot.offset + e.key_spot.width, range_of(e.value).to});
  }
  return r;
}

std::string_view kind_of(const io::Node& n) {
  switch (n.kind) {
    case io::Node::Kind::null:
      return "null";
    case io::Node::Kind::scalar:
      return "scalar";
    case io::Node::Kind::sequence:
      return "sequence";
    case io::Node::Kind::map:
      return "map";
  }
  return "null";
}

/// A length as it stands in the text.
struct Length {
  double metres = 0;
  std::string unit;
  double factor = 1;
  std::size_t decimals = 0;
  Range place;
};

std::optional<Length> length_of(const io::Node& n) {
  if (n.kind != io::Node::Kind::scalar || !n.literal) return std::nullopt;
  const auto metres = parse_quantity(n.text, si::m);
  if (!metres) return std::nullopt;
  const std::size_t digits = n.text.find_first_not_of("+-0123456789.eE");
  if (digits == std::string::npos) return std::nullopt;
  const std::size_t unit = n.text.find_first_not_of(" \t", digits);
  if (unit == std::string::npos) return std::nullopt;
  const auto factor = unit_factor(n.text.substr(unit), si::m);
  if (!factor) return std::nullopt;
  const std::size_t point = n.text.find('.');
  const std::size_t decimals =
      point == std::string::npos ? 0 : n.text.find_first_not_of("0123456789", point + 1) - point - 1;
  const io::Spot spot = n.inside(0, n.text.size());
  return Length{.metres = *metres,
                .unit = n.text.substr(unit),
                .factor = *factor,
                .decimals = decimals,
                .place = {spot.offset, spot.offset + spot.width}};
}

class Places {
 public:
  explicit Places(std::string_view text) : utf16_(text) {}

  void walk(const io::Node& n, const std::string& path) {
    if (n.kind == io::Node::Kind::sequence) {
      for (std::size_t i = 0; i < n.items.size(); ++i) {
        const std::string below = fmt::format("{}[{}]", path, i);
        note(below, nullptr, n.items[i]);
        walk(n.items[i], below);
      }
    }
    for (const io::Entry& e : n.entries) {
      const std::string below = path.empty() ? e.key : fmt::format("{}.{}", path, e.key);
      note(below, &e, e.value);
      walk(e.value, below);
    }
  }

  /// Positions of the machine's parts: `points: {NAME: [x, y, z]}`, `GROUP: {NAME: {at: [x, y, z]}}`.
  void find_handles(const io::Node& root) {
    const io::Node* machine = root.find("machine");
    if (machine == nullptr || machine->kind != io::Node::Kind::map) return;
    for (const io::Entry& group : machine->entries) {
      if (group.value.kind != io::Node::Kind::map) continue;
      for (const io::Entry& part : group.value.entries) {
        const std::string path = fmt::format("machine.{}.{}", group.key, part.key);
        if (group.key == "points" && part.value.kind == io::Node::Kind::sequence) {
          handle(path, group.key, part.key, part.value);
        } else if (part.value.kind == io::Node::Kind::map && part.value.find("body") == nullptr) {
          const io::Node* at = part.value.find("at");
          if (at != nullptr) handle(path + ".at", group.key, part.key, *at);
        }
      }
    }
  }

  std::string json() const {
    return Json{{"outline", outline_}, {"handles", handles_}}.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

 private:
  Json range(const Range& r) const { return {utf16_(r.from), utf16_(r.to)}; }

  void note(const std::string& path, const io::Entry* entry, const io::Node& n) {
    Json one = {{"path", path}, {"kind", kind_of(n)}, {"value", range(range_of(n))}};
    if (entry != nullptr) {
      one["key"] = range({entry->key_spot.offset, entry->key_spot.offset + entry->key_spot.width});
    }
    if (n.kind == io::Node::Kind::scalar) one["text"] = n.text;
    outline_.push_back(std::move(one));
  }

  void handle(const std::string& path, const std::string& kind, const std::string& name, const io::Node& at) {
    if (at.kind != io::Node::Kind::sequence || at.items.size() != 3) return;
    Json place = Json::array(), numbers = Json::array();
    for (const io::Node& item : at.items) {
      const auto length = length_of(item);
      if (!length) return;
      place.push_back(length->metres);
      numbers.push_back({{"from", utf16_(length->place.from)},
                         {"to", utf16_(length->place.to)},
                         {"unit", length->unit},
                         {"factor", length->factor},
                         {"decimals", length->decimals}});
    }
    handles_.push_back({{"path", path}, {"name", name}, {"kind", kind}, {"at", place}, {"numbers", numbers}});
  }

  Utf16 utf16_;
  Json outline_ = Json::array();
  Json handles_ = Json::array();
};

}  // namespace

std::string places_of(std::string_view deck) {
  const auto document = io::parse(deck, std::string("deck"));
  if (!document) return "{}";
  // what stands before the text that was read: a byte order mark
  Places places(document->source->text);
  places.walk(document->root, "");
  places.find_handles(document->root);
  return places.json();
}

}  // namespace taut::web
