#include "web/deck_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "taut/base/gravity.hpp"
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

/// A quantity as it stands in the text.
struct Quantity {
  double si = 0;
  std::string unit;
  double factor = 1;
  std::size_t decimals = 0;
  Range place;
};

std::optional<Quantity> quantity_of(const io::Node& n, const Unit& target) {
  if (n.kind != io::Node::Kind::scalar || !n.literal) return std::nullopt;
  const auto si = parse_quantity(n.text, target);
  if (!si) return std::nullopt;
  const std::size_t digits = n.text.find_first_not_of("+-0123456789.eE");
  if (digits == std::string::npos) return std::nullopt;
  const std::size_t unit = n.text.find_first_not_of(" \t", digits);
  if (unit == std::string::npos) return std::nullopt;
  const auto factor = unit_factor(n.text.substr(unit), target);
  if (!factor) return std::nullopt;
  const std::size_t point = n.text.find('.');
  const std::size_t decimals =
      point == std::string::npos ? 0 : n.text.find_first_not_of("0123456789", point + 1) - point - 1;
  const io::Spot spot = n.inside(0, n.text.size());
  return Quantity{.si = *si,
                  .unit = n.text.substr(unit),
                  .factor = *factor,
                  .decimals = decimals,
                  .place = {spot.offset, spot.offset + spot.width}};
}

using Direction = std::array<double, 3>;
constexpr std::array<Direction, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

std::string_view text_of(const io::Node& map, std::string_view key) {
  const io::Node* n = map.find(key);
  return n != nullptr && n->kind == io::Node::Kind::scalar ? std::string_view(n->text) : std::string_view();
}

/// The horizontal direction of `along: [x, y]`; without it that of x. None where it is an expression.
std::optional<Direction> direction_of(const io::Node& map) {
  const io::Node* along = map.find("along");
  if (along == nullptr) return axes[0];
  if (along->kind != io::Node::Kind::sequence || along->items.size() != 2) return std::nullopt;
  const auto x = parse_number(along->items[0].text), y = parse_number(along->items[1].text);
  if (!x || !y || std::hypot(*x, *y) == 0) return std::nullopt;
  return Direction{*x / std::hypot(*x, *y), *y / std::hypot(*x, *y), 0};
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

  void find_handles(const io::Node& root) {
    const io::Node* machine = root.find("machine");
    if (machine != nullptr && machine->kind == io::Node::Kind::map) {
      find_positions(*machine);
      find_loads(*machine);
    }
    find_carriage(root);
  }

  std::string json() const {
    return Json{{"outline", outline_}, {"handles", handles_}}.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

 private:
  /// Positions of the machine's parts: `points: {NAME: [x, y, z]}`, `GROUP: {NAME: {at: [x, y, z]}}`.
  void find_positions(const io::Node& machine) {
    for (const io::Entry& group : machine.entries) {
      if (group.value.kind != io::Node::Kind::map) continue;
      for (const io::Entry& part : group.value.entries) {
        const std::string path = fmt::format("machine.{}.{}", group.key, part.key);
        if (group.key == "points" && part.value.kind == io::Node::Kind::sequence) {
          handle(path, group.key, part.key, part.value);
        } else if (part.value.kind == io::Node::Kind::map && part.value.find("body") == nullptr) {
          const io::Node* at = part.value.find("at");
          // of a carriage it is where the search for its place begins: it moves no carriage whose ropes place it
          const std::string kind = group.key == "carriages" ? "guess" : group.key;
          if (at != nullptr) handle(path + ".at", kind, part.key, *at);
        }
      }
    }
  }

  /// Weights and forces: arrows at the place of what they act on, which the result knows.
  void find_loads(const io::Node& machine) {
    const io::Node* loads = machine.find("loads");
    if (loads == nullptr || loads->kind != io::Node::Kind::sequence) return;
    for (std::size_t i = 0; i < loads->items.size(); ++i) {
      const io::Node& load = loads->items[i];
      const std::string_view at = text_of(load, "at");
      if (at.empty()) continue;
      const std::string path = fmt::format("machine.loads[{}]", i);
      const auto add = [&](const char* key, Json numbers) {
        handles_.push_back({{"path", fmt::format("{}.{}", path, key)},
                            {"name", at},
                            {"kind", "load"},
                            {"on", at},
                            {"numbers", std::move(numbers)}});
      };
      const io::Node* mass = load.find("mass");
      const auto kg = mass == nullptr ? std::nullopt : quantity_of(*mass, si::kg);
      if (kg) {
        Json one = number(*kg, {0, 0, -gravity_of(machine)});
        one["least"] = 0;
        add("mass", Json::array({std::move(one)}));
      }
      const io::Node* force = load.find("force");
      if (force == nullptr || force->kind != io::Node::Kind::sequence || force->items.size() != 3) continue;
      Json numbers = Json::array();
      for (std::size_t k = 0; k < 3; ++k) {
        const auto newtons = quantity_of(force->items[k], si::N);
        if (newtons) numbers.push_back(number(*newtons, axes[k]));
      }
      if (numbers.size() == 3) add("force", std::move(numbers));
    }
  }

  static double gravity_of(const io::Node& machine) {
    const auto g = parse_quantity(text_of(machine, "gravity"), si::m_per_s2);
    return g ? *g : standard_gravity;
  }

  /// The place that the first equilibrium gives its carriage: `equilibrium: {carriage: car, x: 100 m, z: 20 m}`. The
  /// picture shows that equilibrium.
  void find_carriage(const io::Node& root) {
    const io::Node* analyses = root.find("analyses");
    if (analyses == nullptr) return;
    for (std::size_t i = 0; i < analyses->items.size(); ++i) {
      const io::Node* equilibrium = analyses->items[i].find("equilibrium");
      if (equilibrium == nullptr) continue;
      const std::string_view carriage = text_of(*equilibrium, "carriage");
      const std::optional<Direction> along = direction_of(*equilibrium);
      if (carriage.empty() || !along) return;
      Json numbers = Json::array();
      for (const io::Entry& e : equilibrium->entries) {
        if (e.key != "x" && e.key != "z") continue;
        if (const auto metres = quantity_of(e.value, si::m))
          numbers.push_back(number(*metres, e.key == "x" ? *along : axes[2]));
      }
      if (numbers.empty()) return;
      handles_.push_back({{"path", fmt::format("analyses[{}].equilibrium.x", i)},
                          {"name", carriage},
                          {"kind", "carriage"},
                          {"on", carriage},
                          {"numbers", std::move(numbers)}});
      return;
    }
  }

  Json number(const Quantity& q, const Direction& along) const {
    return {{"from", utf16_(q.place.from)},
            {"to", utf16_(q.place.to)},
            {"unit", q.unit},
            {"factor", q.factor},
            {"decimals", q.decimals},
            {"value", q.si},
            {"along", along}};
  }

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
    for (std::size_t k = 0; k < 3; ++k) {
      const auto length = quantity_of(at.items[k], si::m);
      if (!length) return;
      place.push_back(length->si);
      numbers.push_back(number(*length, axes[k]));
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
