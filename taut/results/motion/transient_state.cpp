#include "taut/results/motion/transient_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "taut/math/index.hpp"

namespace taut::results {
namespace {

using solve::DynamicState;
using Json = nlohmann::ordered_json;

constexpr int format = 4;
constexpr double last = 1e9;  ///< s, thirty years: beyond, a time has too few digits left for the steps of a motion

/// What JSON has no number for.
Json json_number(double x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return x;
}
double number_in(const Json& j) {
  if (!j.is_string()) return j.get<double>();
  const auto text = j.get<std::string>();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  if (text == "inf") return infinity;
  if (text == "-inf") return -infinity;
  throw std::out_of_range("a number");
}

Json numbers(const std::vector<double>& all) {
  Json list = Json::array();
  for (const double x : all) list.push_back(json_number(x));
  return list;
}
std::vector<double> numbers_in(const Json& j) {
  std::vector<double> all;
  for (const Json& x : j) all.push_back(number_in(x));
  return all;
}

Json vector(const Vector3& v) { return {json_number(v.x()), json_number(v.y()), json_number(v.z())}; }
Vector3 vector_in(const Json& j) { return {number_in(j.at(0)), number_in(j.at(1)), number_in(j.at(2))}; }

Json vectors(const std::vector<Vector3>& all) {
  Json list = Json::array();
  for (const Vector3& v : all) list.push_back(vector(v));
  return list;
}
std::vector<Vector3> vectors_in(const Json& j) {
  std::vector<Vector3> all;
  for (const Json& v : j) all.push_back(vector_in(v));
  return all;
}

Json matrix(const Matrix3& m) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < 3; ++i) rows.push_back(vector(m.row(i).transpose()));
  return rows;
}
Matrix3 matrix_in(const Json& j) {
  Matrix3 m;
  for (Eigen::Index i = 0; i < 3; ++i) m.row(i) = vector_in(j.at(static_cast<std::size_t>(i))).transpose();
  return m;
}

/// What tells one event of a deck from another: of those with the same words each counts once.
std::string key_of(const machine::Event& event) {
  if (event.at) return fmt::format("{} at {:.12g} s", event.words, *event.at);
  const char* sense = event.when->above ? ">" : "<";
  return fmt::format("{} when {} {} {:.12g}", event.words, event.when->of.name, sense, event.when->threshold);
}

Json happened(const solve::DynamicState& state, const machine::Model& m) {
  Json keys = Json::array();
  for (std::size_t i = 0; i < m.events.size() && i < state.happened.size(); ++i) {
    if (state.happened[i] != 0) keys.push_back(key_of(m.events[i]));
  }
  for (const std::string& key : state.done) keys.push_back(key);
  return keys;
}

/// Which events of the machine have happened. Why it can't go on with one, in words; else empty.
std::string take_happened(const Json& keys, const machine::Model& m, solve::DynamicState& s) {
  auto left = keys.get<std::vector<std::string>>();
  for (const machine::Event& event : m.events) {
    const auto found = std::find(left.begin(), left.end(), key_of(event));
    s.happened.push_back(found != left.end() ? 1 : 0);
    if (found != left.end()) {
      left.erase(found);
    } else if (event.at && *event.at < s.t) {
      return fmt::format(
          "'{}' at {:.6g} s has not happened in it, and it is of {:.6g} s: give the event a later time, "
          "or leave it out",
          event.words, *event.at, s.t);
    }
  }
  s.done = std::move(left);
  return {};
}

/// A drive in the state, and who gave it: the deck gives it anew from then on.
Json drive(const machine::Drive& is, const machine::Drive& described, const machine::Model& m, double t) {
  using machine::DriveKind;
  const machine::Drive& given = is.by ? m.events[as_size(*is.by)].drive : described;
  const machine::SignalValue now = machine::at(is.signal, t);
  Json j;
  j["is"] = {static_cast<int>(is.kind), json_number(now.value), json_number(now.rate)};
  if (is.by) j["by"] = key_of(m.events[as_size(*is.by)]);
  j["let_go"] = is.kind == DriveKind::free && given.kind == DriveKind::held;
  j["brake_described"] = described.brake;
  j["brake"] = is.brake;
  j["brake_since"] = json_number(is.brake_since);
  return j;
}

/// The drums, or the driven sheaves, of a machine: how it describes their drives, and as a state has them.
template <class All>
Json drives(const std::vector<machine::Drive>& state, const All& all, const machine::Model& m, double t) {
  Json list = Json::array();
  for (std::size_t i = 0; i < all.size() && i < state.size(); ++i) list.push_back(drive(state[i], all[i].drive, m, t));
  return list;
}

/// A drive from a state on. Kind and signal are those of the deck, or of the event that gave them; a brake is as the
/// state has it, or is set then where the deck describes it so for the first time. `anew`: it is no more what it was.
struct DriveOn {
  machine::Drive drive;
  bool anew = false;
};

tl::expected<DriveOn, std::string> drive_on(const Json& j, const machine::Drive& described, const std::string& name,
                                            const machine::Model& m, double t) {
  using machine::DriveKind;
  DriveOn on{.drive = described};
  machine::Drive& now = on.drive;
  if (j.contains("by")) {
    const auto key = j.at("by").get<std::string>();
    const auto by = std::find_if(m.events.begin(), m.events.end(), [&](const auto& e) { return key_of(e) == key; });
    if (by == m.events.end()) {
      return tl::unexpected(
          fmt::format("its event '{}' has given '{}' the drive that it has there: leave that event "
                      "in the deck, also where another one follows it",
                      key, name));
    }
    now.kind = by->drive.kind;
    now.signal = by->drive.signal;
    now.by = static_cast<int>(by - m.events.begin());
  }
  if (j.at("let_go").get<bool>() && now.kind == DriveKind::held) now.kind = DriveKind::free;
  const bool brake = j.at("brake").get<bool>(), sets = described.brake && !j.at("brake_described").get<bool>();
  now.brake = brake || sets;
  now.brake_since = brake || !sets ? number_in(j.at("brake_since")) : t;
  // a drum that pulls does not know how fast it turns
  const bool pulled = j.at("is").at(0).get<int>() == static_cast<int>(DriveKind::pull) && !brake;
  if (pulled && (now.kind != DriveKind::pull || now.brake)) {
    return tl::unexpected(
        fmt::format("'{}' pulls its rope in it: an event has to give it another drive, or set its brake", name));
  }
  const machine::SignalValue goes = machine::at(now.signal, t);
  const Json is = {static_cast<int>(now.kind), json_number(goes.value), json_number(goes.rate)};
  on.anew = is != j.at("is") || now.brake != brake;
  return on;
}

/// All drives of the drums, or of the driven sheaves. Why they can't go on, in words; else empty.
template <class All>
std::string take_drives(const Json& list, const All& all, const machine::Model& m, solve::DynamicState& s,
                        std::vector<machine::Drive>& to) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto on = drive_on(list.at(i), all[i].drive, all[i].name, m, s.t);
    if (!on) return on.error();
    to.push_back(std::move(on->drive));
    s.begins_anew = s.begins_anew || on->anew;
  }
  return {};
}

std::vector<machine::ActuatorMode> modes_in(const Json& list) {
  std::vector<machine::ActuatorMode> all;
  for (const Json& mode : list) {
    const int value = mode.get<int>();
    if (value < 0 || value > static_cast<int>(machine::ActuatorMode::free)) throw std::out_of_range("mode");
    all.push_back(static_cast<machine::ActuatorMode>(value));
  }
  return all;
}

Json bodies(const solve::DynamicState& state) {
  Json list = Json::array();
  for (const auto& b : state.bodies) {
    list.push_back({{"position", vector(b.position)},
                    {"orientation", matrix(b.orientation)},
                    {"velocity", vector(b.velocity)},
                    {"spin", vector(b.spin)}});
  }
  return list;
}

Json ropes(const solve::DynamicState& state) {
  Json list = Json::array();
  for (const auto& r : state.ropes) {
    list.push_back({{"length", numbers(r.length)},
                    {"whole", r.whole},
                    {"angle", numbers(r.angle)},
                    {"spin", numbers(r.spin)},
                    {"passed", numbers(r.passed)},
                    {"wrap", numbers(r.wrap)},
                    {"inside", vectors(r.inside)},
                    {"inside_velocity", vectors(r.inside_velocity)},
                    {"leaves", vectors(r.leaves)},
                    {"arrives", vectors(r.arrives)},
                    {"on_rounds", numbers(r.on_rounds)},
                    {"lumped", numbers(r.lumped)},
                    {"T_static", json_number(r.T_static)}});
  }
  return list;
}

Json tears(const solve::DynamicState& state) {
  Json list = Json::array();
  for (const auto& one : state.tears)
    list.push_back({one.reeving, one.part, json_number(one.from), json_number(one.over)});
  return list;
}

Json on_drums(const solve::DynamicState& state) {
  Json list = Json::array();
  for (const auto& d : state.on_drums)
    list.push_back({{"content", json_number(d.content)}, {"layer", d.layer}, {"strain", numbers(d.strain)}});
  return list;
}

/// Breaks under way.
void add_tears(const Json& list, solve::DynamicState& s) {
  for (const Json& one : list) {
    s.tears.push_back({one.at(0).get<int>(), one.at(1).get<int>(), number_in(one.at(2)), number_in(one.at(3))});
    if (!(s.tears.back().from <= s.t && s.tears.back().over > 0)) throw std::out_of_range("times of a break");
  }
}

solve::DynamicState state_in(const Json& j) {
  solve::DynamicState s;
  s.t = number_in(j.at("t"));
  if (!(s.t >= 0 && s.t <= last)) throw std::out_of_range("a time");
  for (const Json& b : j.at("bodies")) {
    s.bodies.push_back({vector_in(b.at("position")), matrix_in(b.at("orientation")), vector_in(b.at("velocity")),
                        vector_in(b.at("spin"))});
  }
  for (const Json& r : j.at("ropes")) {
    solve::DynamicState::Rope rope;
    rope.length = numbers_in(r.at("length"));
    rope.whole = r.at("whole").get<std::vector<std::uint8_t>>();
    rope.angle = numbers_in(r.at("angle"));
    rope.spin = numbers_in(r.at("spin"));
    rope.passed = numbers_in(r.at("passed"));
    rope.wrap = numbers_in(r.at("wrap"));
    rope.inside = vectors_in(r.at("inside"));
    rope.inside_velocity = vectors_in(r.at("inside_velocity"));
    if (r.contains("leaves")) rope.leaves = vectors_in(r.at("leaves"));
    if (r.contains("arrives")) rope.arrives = vectors_in(r.at("arrives"));
    if (r.contains("on_rounds")) rope.on_rounds = numbers_in(r.at("on_rounds"));
    if (r.contains("lumped")) rope.lumped = numbers_in(r.at("lumped"));
    if (r.contains("T_static")) rope.T_static = number_in(r.at("T_static"));
    s.ropes.push_back(std::move(rope));
  }
  if (j.contains("tears")) add_tears(j.at("tears"), s);
  for (const Json& d : j.at("on_drums"))
    s.on_drums.push_back({number_in(d.at("content")), d.at("layer").get<int>(), numbers_in(d.at("strain"))});
  s.force = numbers_in(j.at("force"));
  s.actuator_mode = modes_in(j.at("actuator_mode"));
  s.damping_time = numbers_in(j.at("damping_time"));
  if (j.contains("memory")) s.memory = numbers_in(j.at("memory"));
  return s;
}

template <class All>
Json names(const All& all) {
  Json list = Json::array();
  for (const auto& one : all) list.push_back(one.name);
  return list;
}

/// A part of the machine of which a state has its own copy, in places and lengths: it can't be another one from then
/// on. Masses, losses, drives, signals and loads can.
struct Kept {
  std::string words;  ///< what is wrong with another one
  std::vector<double> numbers;
};

std::vector<double> components(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

void keep_nodes(const machine::Reeving& rope, std::vector<Kept>& all) {
  for (const machine::Node& node : rope.nodes) {
    if (node.kind == machine::NodeKind::load) continue;
    const auto is = [&](const char* what) { return fmt::format("'{}' has another {}", node.name, what); };
    all.push_back({is("diameter"), {node.radius}});
    all.push_back({is("place"), components(node.at.at)});
    all.push_back({is("axis"), components(node.axis)});
    all.push_back({is("side"), {static_cast<double>(node.side)}});
  }
}

std::vector<Kept> kept_of(const machine::Model& m) {
  std::vector<Kept> all;
  for (const machine::Body& body : m.bodies) {
    if (body.free.empty() && body.driven.empty())
      all.push_back({fmt::format("'{}' has another place", body.name), components(body.position)});
  }
  for (const machine::Actuator& one : m.actuators) {
    all.push_back({fmt::format("'{}' begins with another mode: an event sets it from then on", one.name),
                   {static_cast<double>(one.mode)}});
  }
  for (const machine::Face& face : m.faces) {
    const std::string words = fmt::format("face '{}' has another place", face.name);
    for (const Vector3* one : {&face.from, &face.to, &face.normal}) all.push_back({words, components(*one)});
  }
  for (const machine::Reeving& rope : m.reevings) {
    const auto is = [&](const char* what) { return fmt::format("rope '{}' has another {}", rope.name, what); };
    all.push_back({is("number of copies"), {static_cast<double>(rope.copies)}});
    all.push_back({is("stiffness"), {rope.stiffness}});
    all.push_back({is("mass"), {rope.mass}});
    if (rope.given == machine::Given::length) all.push_back({is("length"), {rope.value}});
    keep_nodes(rope, all);
  }
  return all;
}

Json kept(const machine::Model& m) {
  Json list = Json::array();
  for (const Kept& one : kept_of(m)) list.push_back(numbers(one.numbers));
  return list;
}

/// What of the machine is another one than that of the state, in words; empty where nothing is.
std::string changed(const Json& was, const machine::Model& m) {
  constexpr double rounding = 1e-12;
  const std::vector<Kept> all = kept_of(m);
  if (was.size() != all.size()) return "its ropes have another kind of length";
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<double> before = numbers_in(was.at(i));
    const auto same = [&](double a, double b) { return std::abs(a - b) <= rounding * std::max(1.0, std::abs(b)); };
    if (!std::equal(before.begin(), before.end(), all[i].numbers.begin(), all[i].numbers.end(), same))
      return all[i].words;
  }
  return {};
}

/// How the deck damps a rope: by a time, s, else by a ratio.
struct Damping {
  double time = 0, ratio = 0;
};
Damping damping_of(const machine::Reeving& rope, double otherwise) {
  if (rope.damping_time > 0) return {.time = rope.damping_time};
  return {.ratio = rope.damping_ratio > 0 ? rope.damping_ratio : otherwise};
}

Json damping(const machine::Model& m, double otherwise) {
  Json list = Json::array();
  for (const machine::Reeving& rope : m.reevings) {
    const Damping is = damping_of(rope, otherwise);
    list.push_back(numbers({is.time, is.ratio}));
  }
  return list;
}

/// Ropes get the damping that the deck gives them now. The time that goes with a ratio grows with it; it can't be
/// known where there was none: why not, in words.
std::string damp_anew(const Json& was, const machine::Model& m, double otherwise, solve::DynamicState& s) {
  for (std::size_t r = 0; r < m.reevings.size(); ++r) {
    const Damping now = damping_of(m.reevings[r], otherwise);
    const Damping before{.time = number_in(was.at(r).at(0)), .ratio = number_in(was.at(r).at(1))};
    if (now.time == before.time && now.ratio == before.ratio) continue;
    double& time = s.damping_time[r];
    if (now.ratio > 0 && !(before.ratio > 0)) {
      return fmt::format(
          "rope '{}' has a damping ratio, and had none when its frequency was calculated: give its "
          "'damping_time', or calculate the first part with a ratio, too",
          m.reevings[r].name);
    }
    time = now.ratio > 0 ? time * (now.ratio / before.ratio) : now.time;
  }
  return {};
}

/// Why a state does not fit a machine; empty when it does.
std::string misfit(const solve::DynamicState& s, const Json& j, const machine::Model& m) {
  const auto same = [&](const char* key, const Json& own) { return j.at("machine").at(key) == own; };
  if (!same("bodies", names(m.bodies)) || s.bodies.size() != m.bodies.size()) return "its bodies are others";
  if (!same("ropes", names(m.reevings)) || s.ropes.size() != m.reevings.size()) return "its ropes are others";
  if (!same("drums", names(m.drums))) return "its drums are others";
  if (!same("motors", names(m.motors))) return "its driven sheaves are others";
  if (!same("actuators", names(m.actuators)) || s.actuator_mode.size() != m.actuators.size())
    return "its actuators are others, or stand in another order";
  if (!same("contacts", names(m.contacts))) return "its contacts are others, or stand in another order";
  for (std::size_t i = 0; i < m.reevings.size(); ++i) {
    const std::size_t nodes = m.reevings[i].nodes.size();
    const auto parts = static_cast<std::size_t>(machine::branch_count(m.reevings[i])) *
                       static_cast<std::size_t>(m.reevings[i].segments);
    const solve::DynamicState::Rope& r = s.ropes[i];
    const bool by_branch = r.length.size() == parts && r.whole.size() == parts;
    if (!by_branch || r.angle.size() != nodes || r.spin.size() != nodes || r.passed.size() != nodes ||
        r.wrap.size() != nodes || r.inside.size() != r.inside_velocity.size() ||
        (!r.on_rounds.empty() && r.on_rounds.size() != 2 * parts)) {
      return fmt::format("rope '{}' runs over other sheaves, or in other segments", m.reevings[i].name);
    }
  }
  return changed(j.at("machine").at("kept"), m);
}

}  // namespace

std::string to_json(const solve::DynamicState& state, const machine::Model& model, double damping_ratio) {
  Json j;
  j["taut_state"] = format;
  j["machine"] = {
      {"bodies", names(model.bodies)}, {"ropes", names(model.reevings)},          {"drums", names(model.drums)},
      {"motors", names(model.motors)}, {"actuators", names(model.actuators)},     {"contacts", names(model.contacts)},
      {"kept", kept(model)},           {"damping", damping(model, damping_ratio)}};
  j["t"] = json_number(state.t);
  j["bodies"] = bodies(state);
  j["ropes"] = ropes(state);
  if (!state.tears.empty()) j["tears"] = tears(state);
  j["on_drums"] = on_drums(state);
  j["force"] = numbers(state.force);
  j["happened"] = happened(state, model);
  j["drum_drive"] = drives(state.drum_drive, model.drums, model, state.t);
  j["motor_drive"] = drives(state.motor_drive, model.motors, model, state.t);
  j["actuator_mode"] = Json::array();
  for (const machine::ActuatorMode mode : state.actuator_mode) j["actuator_mode"].push_back(static_cast<int>(mode));
  j["damping_time"] = numbers(state.damping_time);
  j["memory"] = numbers(state.memory);
  return j.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

tl::expected<solve::DynamicState, std::string> state_from_json(const std::string& text, const machine::Model& model,
                                                               double damping_ratio) {
  const Json j = Json::parse(text, nullptr, false);
  if (j.is_discarded() || !j.is_object() || !j.contains("taut_state")) {
    return tl::unexpected(std::string("it is no saved state of a transient"));
  }
  try {
    if (j.at("taut_state").get<int>() != format) return tl::unexpected(std::string("it is of another version of taut"));
    solve::DynamicState state = state_in(j);
    if (const std::string why = misfit(state, j, model); !why.empty()) {
      return tl::unexpected(fmt::format("it is of another machine: {}", why));
    }
    std::string why = take_happened(j.at("happened"), model, state);
    if (why.empty()) why = take_drives(j.at("drum_drive"), model.drums, model, state, state.drum_drive);
    if (why.empty()) why = take_drives(j.at("motor_drive"), model.motors, model, state, state.motor_drive);
    if (!why.empty()) return tl::unexpected(why);
    // a state of an earlier version says nothing of it
    if (j.at("machine").contains("damping")) {
      why = damp_anew(j.at("machine").at("damping"), model, damping_ratio, state);
      if (!why.empty()) return tl::unexpected(why);
    }
    return state;
  } catch (const std::exception&) {
    return tl::unexpected(std::string("it is damaged: a part is missing, of another kind or out of range"));
  }
}

}  // namespace taut::results
