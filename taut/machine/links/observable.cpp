#include "taut/machine/links/observable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>

#include "taut/base/array.hpp"
#include "taut/machine/links/motion_links.hpp"
#include "taut/units/parse.hpp"

namespace taut::machine {
namespace {

/// What a path may end with.
struct Named {
  const char* name;
  Observed quantity;
  Unit unit;
  const char* words;
};
using ObservableNames = Array<Named>;

const ObservableNames of_place = {{.name = "x", .quantity = Observed::x, .unit = si::m, .words = "place"},
                                  {.name = "y", .quantity = Observed::y, .unit = si::m, .words = "place"},
                                  {.name = "z", .quantity = Observed::z, .unit = si::m, .words = "place"},
                                  {.name = "vx", .quantity = Observed::vx, .unit = si::m_per_s, .words = "velocity"},
                                  {.name = "vy", .quantity = Observed::vy, .unit = si::m_per_s, .words = "velocity"},
                                  {.name = "vz", .quantity = Observed::vz, .unit = si::m_per_s, .words = "velocity"}};
const ObservableNames of_body = {
    {.name = "rx", .quantity = Observed::rx, .unit = si::rad, .words = "rotation about x, first"},
    {.name = "ry", .quantity = Observed::ry, .unit = si::rad, .words = "then about y"},
    {.name = "rz", .quantity = Observed::rz, .unit = si::rad, .words = "then about z"},
    {.name = "wx", .quantity = Observed::wx, .unit = si::per_s, .words = "angular velocity"},
    {.name = "wy", .quantity = Observed::wy, .unit = si::per_s, .words = "angular velocity"},
    {.name = "wz", .quantity = Observed::wz, .unit = si::per_s, .words = "angular velocity"}};
const ObservableNames of_rope = {
    {.name = "T_start", .quantity = Observed::T_start, .unit = si::N, .words = "tension at the start of its path"},
    {.name = "T_end", .quantity = Observed::T_end, .unit = si::N, .words = "tension at the end of its path"},
    {.name = "T_max", .quantity = Observed::T_max, .unit = si::N, .words = "largest tension in it"},
    {.name = "length",
     .quantity = Observed::length,
     .unit = si::m,
     .words = "unstretched length at its temperature, what is on drums left out"}};
const ObservableNames of_branch = {{.name = "T",
                                    .quantity = Observed::branch_T,
                                    .unit = si::N,
                                    .words = "largest tension of branch N, from 1 along the path"},
                                   {.name = "length",
                                    .quantity = Observed::branch_length,
                                    .unit = si::m,
                                    .words = "its unstretched length at its temperature"}};
const ObservableNames of_sheave = {
    {.name = "T_in", .quantity = Observed::T_in, .unit = si::N, .words = "tension before it along the path"},
    {.name = "T_out", .quantity = Observed::T_out, .unit = si::N, .words = "tension behind it"},
    {.name = "speed",
     .quantity = Observed::sheave_speed,
     .unit = si::m_per_s,
     .words = "speed of its rim along the path"},
    {.name = "omega", .quantity = Observed::sheave_omega, .unit = si::per_s, .words = "angular velocity"},
    {.name = "angle", .quantity = Observed::sheave_angle, .unit = si::rad, .words = "angle that it has turned"},
    {.name = "torque",
     .quantity = Observed::sheave_torque,
     .unit = si::N_m,
     .words = "torque of its motor along the path"},
    {.name = "power", .quantity = Observed::sheave_power, .unit = si::W, .words = "power of its motor"},
    {.name = "slip",
     .quantity = Observed::slip,
     .unit = si::m_per_s,
     .words = "speed of the rope less that of the rim, along the path"}};
const ObservableNames of_load = {
    {.name = "T_in", .quantity = Observed::T_in, .unit = si::N, .words = "tension before it along the path"},
    {.name = "T_out", .quantity = Observed::T_out, .unit = si::N, .words = "tension behind it"},
    {.name = "speed", .quantity = Observed::slip, .unit = si::m_per_s, .words = "speed of the rope there"}};
const ObservableNames of_drum = {
    {.name = "T", .quantity = Observed::drum_T, .unit = si::N, .words = "tension where the rope leaves it"},
    {.name = "speed",
     .quantity = Observed::drum_speed,
     .unit = si::m_per_s,
     .words = "speed of its rim, taking in > 0"},
    {.name = "length",
     .quantity = Observed::drum_length,
     .unit = si::m,
     .words = "unstretched rope on it (without a 'length_on_drum': taken in), of several ropes the first one's"},
    {.name = "torque", .quantity = Observed::drum_torque, .unit = si::N_m, .words = "torque of its drive"},
    {.name = "power", .quantity = Observed::drum_power, .unit = si::W, .words = "power"}};
const ObservableNames of_contact = {
    {.name = "N", .quantity = Observed::contact_N, .unit = si::N, .words = "normal force"},
    {.name = "Ff", .quantity = Observed::contact_F, .unit = si::N, .words = "friction force, of the same sign"},
    {.name = "speed",
     .quantity = Observed::contact_speed,
     .unit = si::m_per_s,
     .words = "sliding speed, from 'from' to 'to' of the face"},
    {.name = "state", .quantity = Observed::contact_state, .unit = si::one, .words = "0 apart, 1 slides, 2 sticks"}};
const ObservableNames of_actuator = {
    {.name = "F", .quantity = Observed::actuator_F, .unit = si::N, .words = "force"},
    {.name = "speed", .quantity = Observed::actuator_speed, .unit = si::m_per_s, .words = "speed at which it extends"},
    {.name = "length", .quantity = Observed::actuator_length, .unit = si::m, .words = "length"},
    {.name = "power", .quantity = Observed::actuator_power, .unit = si::W, .words = "power"}};
const ObservableNames of_energy = {
    {.name = "kinetic", .quantity = Observed::kinetic, .unit = si::J, .words = "energy of motion"},
    {.name = "elastic", .quantity = Observed::elastic, .unit = si::J, .words = "energy of stretched ropes and springs"},
    {.name = "potential", .quantity = Observed::potential, .unit = si::J, .words = "energy of height"},
    {.name = "dissipated", .quantity = Observed::dissipated, .unit = si::J, .words = "lost since the start"},
    {.name = "supplied", .quantity = Observed::supplied, .unit = si::J, .words = "by drives since the start"},
    {.name = "residual", .quantity = Observed::residual, .unit = si::J, .words = "what the ledger leaves open"}};

const Named* find(const ObservableNames& names, std::string_view name) {
  const auto at = std::find_if(names.begin(), names.end(), [&](const Named& n) { return name == n.name; });
  return at == names.end() ? nullptr : &*at;
}

/// "ext[2].T" -> ext, 2, T; "ext[2,7].x" -> ext, 2, 7, x. Names of parts may have dots: the last one counts.
struct Path {
  std::string name;
  std::optional<int> number, joint;
  std::string quantity;
};

Path split(const std::string& text) {
  Path p;
  const std::size_t dot = text.rfind('.');
  p.name = text.substr(0, dot);
  if (dot != std::string::npos) p.quantity = text.substr(dot + 1);
  const std::size_t open = p.name.rfind('[');
  if (open != std::string::npos && p.name.back() == ']') {
    const std::size_t comma = p.name.find(',', open);
    const auto whole = [&](std::size_t from, std::size_t to) -> std::optional<int> {
      int number = 0;
      const auto [end, error] = std::from_chars(p.name.data() + from, p.name.data() + to, number);
      return error == std::errc{} && end == p.name.data() + to ? std::optional(number) : std::nullopt;
    };
    const std::size_t last = p.name.size() - 1;
    const auto number = whole(open + 1, std::min(comma, last));
    if (comma != std::string::npos) p.joint = whole(comma + 1, last);
    if (number && (comma == std::string::npos || p.joint)) {
      p.number = number;
      p.name.resize(open);
    }
  }
  return p;
}

class Resolver {
 public:
  Resolver(const std::string& text, const Model& model) : text_(text), path_(split(text)), model_(model) {}

  /// Empty, with `reason`, when there is nothing of this kind.
  std::optional<Observable> resolve() {
    for (const auto attempt :
         {&Resolver::measure, &Resolver::signal, &Resolver::energy, &Resolver::body, &Resolver::rope, &Resolver::sheave,
          &Resolver::drum, &Resolver::contact, &Resolver::actuator, &Resolver::place}) {
      if (auto found = (this->*attempt)()) return found;
      if (!reason.empty()) return std::nullopt;
    }
    if (offered_.empty()) {
      reason = fmt::format("'{}' names no body, rope, sheave, drum, contact, actuator, point or signal{}", path_.name,
                           did_you_mean(path_.name, all_names()));
    } else {
      reason = fmt::format("'{}' has {}{}", path_.name, fmt::join(offered_, ", "),
                           path_.quantity.empty() ? "" : fmt::format(", not '{}'", path_.quantity));
    }
    return std::nullopt;
  }

  std::string reason;

 private:
  std::optional<Observable> make(const ObservableNames& names, int index, std::optional<int> part = std::nullopt) {
    const Named* named = find(names, path_.quantity);
    if (named != nullptr)
      return Observable{.name = text_,
                        .quantity = named->quantity,
                        .unit = named->unit,
                        .index = index,
                        .part = part,
                        .at = Vector3::Zero()};
    for (const Named& n : names) offered_.emplace_back(n.name);
    return std::nullopt;
  }

  std::optional<Observable> measure() {
    const auto i = index_of(model_.measures, text_);
    return i ? std::optional(model_.measures[*i]) : std::nullopt;
  }
  std::optional<Observable> signal() {
    const auto i = index_of(model_.signals, text_);
    if (!i) return std::nullopt;
    return Observable{.name = text_,
                      .quantity = Observed::signal,
                      .unit = model_.signals[*i].unit,
                      .index = *i,
                      .part = {},
                      .at = Vector3::Zero()};
  }
  std::optional<Observable> energy() {
    return path_.name == "energy" && !path_.number ? make(of_energy, ground) : std::nullopt;
  }
  std::optional<Observable> body() {
    const auto i = index_of(model_.bodies, path_.name);
    if (!i || path_.number) return std::nullopt;
    if (auto found = make(of_place, *i)) return found;
    return make(of_body, *i);
  }
  std::optional<Observable> rope() {
    const auto i = index_of(model_.reevings, path_.name);
    if (!i) return std::nullopt;
    if (!path_.number) return make(of_rope, *i);
    const int branches = branch_count(model_.reevings[*i]), segments = model_.reevings[*i].segments;
    if (*path_.number < 1 || *path_.number > branches) {
      reason = fmt::format("'{}' has the branches 1 to {} along its path", path_.name, branches);
      return std::nullopt;
    }
    if (!path_.joint) return make(of_branch, *i, *path_.number - 1);
    if (segments > 1 && *path_.joint >= 1 && *path_.joint < segments) {
      auto found = make(of_place, *i, *path_.number - 1);
      if (found) found->joint = path_.joint;
      return found;
    }
    reason = segments > 1 ? fmt::format("a branch of '{}' has the joints 1 to {}", path_.name, segments - 1)
                          : fmt::format("'{}' has no joints: give it 'segments'", path_.name);
    return std::nullopt;
  }
  std::optional<Observable> sheave() {
    int count = 0;
    for (std::size_t r = 0; r < model_.reevings.size(); ++r) {
      const auto& nodes = model_.reevings[r].nodes;
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        const bool load = nodes[n].kind == NodeKind::load;
        const bool over = nodes[n].kind == NodeKind::contact || nodes[n].kind == NodeKind::drive;
        if (load && nodes[n].name == text_.substr(0, text_.rfind('.'))) {
          return make(of_load, static_cast<int>(r), static_cast<int>(n));
        }
        if (!over || nodes[n].name != path_.name) continue;
        if (path_.joint || ++count != path_.number.value_or(1)) continue;
        auto found = make(of_sheave, static_cast<int>(r), static_cast<int>(n));
        const bool of_motor =
            found && (found->quantity == Observed::sheave_torque || found->quantity == Observed::sheave_power);
        if (!of_motor || nodes[n].motor) return found;
        reason = fmt::format("'{}' has no motor, so no {}", path_.name, path_.quantity);
        return std::nullopt;
      }
    }
    if (count > 0) reason = fmt::format("ropes run over '{}' {} times: [1] to [{}]", path_.name, count, count);
    return std::nullopt;
  }
  std::optional<Observable> drum() {
    const auto i = index_of(model_.drums, path_.name);
    return i && !path_.number ? make(of_drum, *i) : std::nullopt;
  }
  std::optional<Observable> contact() {
    const auto i = index_of(model_.contacts, path_.name);
    return i && !path_.number ? make(of_contact, *i) : std::nullopt;
  }
  std::optional<Observable> actuator() {
    const auto i = index_of(model_.actuators, path_.name);
    return i && !path_.number ? make(of_actuator, *i) : std::nullopt;
  }
  std::optional<Observable> place() {
    const auto i = index_of(model_.places, path_.name);
    if (!i || path_.number) return std::nullopt;
    const Place& place = model_.places[*i].place;
    auto found = make(of_place, place.body);
    if (found) found->at = place.at;
    return found;
  }

  std::vector<std::string> all_names() const {
    std::vector<std::string> names = {"energy"};
    const auto add = [&](const auto& all) {
      for (const auto& one : all) names.push_back(one.name);
    };
    add(model_.measures), add(model_.signals), add(model_.bodies), add(model_.reevings), add(model_.drums),
        add(model_.contacts);
    add(model_.actuators);
    for (const Reeving& rope : model_.reevings) add(rope.nodes);
    return names;
  }

  const std::string& text_;
  Path path_;
  const Model& model_;
  std::vector<std::string> offered_;
};

/// Calls `f` with those of a body's coordinates x, y, z, rx, ry, rz that are free or driven.
template <class F>
void for_each_moving(const Body& body, const F& f) {
  for (std::size_t k = 0; k < 6; ++k) {
    const auto axis = static_cast<Eigen::Index>(k % 3);
    const auto changes = [&](const auto& way) { return std::abs(k < 3 ? way.along[axis] : way.about[axis]) > 0; };
    const bool free = std::any_of(body.free.begin(), body.free.end(), changes);
    if (free || std::any_of(body.driven.begin(), body.driven.end(), changes)) f(k < 3 ? of_place[k] : of_body[k - 3]);
  }
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? std::string{} : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::optional<Observable> observable(const std::string& text, const Model& model, const std::string& path,
                                     std::vector<Complaint>& complaints) {
  const std::string name = trimmed(text);
  Resolver resolver(name, model);
  auto found = resolver.resolve();
  if (!found) complaints.push_back({path, resolver.reason});
  return found;
}

std::optional<Condition> condition(const std::string& text, const Model& model, const std::string& path,
                                   std::vector<Complaint>& complaints) {
  const std::size_t sign = text.find_first_of("<>");
  if (sign == std::string::npos || text.find_first_of("<>=", sign + 1) != std::string::npos) {
    complaints.push_back({path, fmt::format("'{}' is no condition: write 'car.z > 12 m' or 'car.z < 12 m'", text)});
    return std::nullopt;
  }
  const auto of = observable(text.substr(0, sign), model, path, complaints);
  if (!of) return std::nullopt;
  const auto threshold = parse_quantity(trimmed(text.substr(sign + 1)), of->unit);
  if (!threshold) {
    complaints.push_back({path, threshold.error().message});
    return std::nullopt;
  }
  return Condition{.of = *of, .above = text[sign] == '>', .threshold = *threshold};
}

std::vector<QuantityWords> observable_words() {
  const std::vector<std::pair<std::string, const ObservableNames*>> all = {
      {"BODY.", &of_place},     {"BODY.", &of_body},       {"POINT.", &of_place},       {"ROPE.", &of_rope},
      {"ROPE[N].", &of_branch}, {"ROPE[N,J].", &of_place}, {"SHEAVE.", &of_sheave},     {"LOAD.", &of_load},
      {"DRUM.", &of_drum},      {"CONTACT.", &of_contact}, {"CYLINDER.", &of_actuator}, {"energy.", &of_energy}};
  std::vector<QuantityWords> words;
  for (const auto& [of, names] : all) {
    for (const Named& one : *names) words.push_back({of + one.name, "", one.unit, one.words});
  }
  return words;
}

Array<Observable> usual_observables(const Model& model) {
  Array<Observable> all;
  all.reserve(3 * (model.reevings.size() + model.bodies.size()));
  const auto add_one = [&](const std::string& of, const Named& named, std::size_t index, std::optional<int> part) {
    Observable& one = all.emplace_back();
    one.name.reserve(of.size() + 1 + std::string_view(named.name).size());
    one.name.append(of).append(".").append(named.name);
    one.quantity = named.quantity;
    one.unit = named.unit;
    one.index = static_cast<int>(index);
    one.part = part;
  };
  const auto add = [&](const std::string& of, const ObservableNames& names,
                       std::initializer_list<std::string_view> some, std::size_t index,
                       std::optional<int> part = std::nullopt) {
    for (const std::string_view name : some) add_one(of, *find(names, name), index, part);
  };
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    add(model.reevings[i].name, of_rope, {"T_start", "T_end", "T_max"}, i);
  }
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    if (body.of_rope) continue;
    for_each_moving(body, [&](const Named& coordinate) { add_one(body.name, coordinate, i, std::nullopt); });
  }
  for (std::size_t i = 0; i < model.drums.size(); ++i) add(model.drums[i].name, of_drum, {"speed"}, i);
  Array<bool> seen(model.motors.size(), false);  // one may have several grooves
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    for (std::size_t n = 0; n < model.reevings[r].nodes.size(); ++n) {
      const Node& node = model.reevings[r].nodes[n];
      const bool load = node.kind == NodeKind::load && !(node.load.part > 0);
      if (node.motor && !seen[*node.motor]) add(node.name, of_sheave, {"speed"}, r, static_cast<int>(n));
      if (node.motor) seen[*node.motor] = true;
      if (load) add(node.name, of_load, {"T_in", "T_out"}, r, static_cast<int>(n));
    }
  }
  for (std::size_t i = 0; i < model.contacts.size(); ++i) add(model.contacts[i].name, of_contact, {"N", "Ff"}, i);
  for (std::size_t i = 0; i < model.actuators.size(); ++i) add(model.actuators[i].name, of_actuator, {"F"}, i);
  return all;
}

}  // namespace taut::machine
