#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "taut/checks/judge.hpp"
#include "taut/checks/parts.hpp"
#include "taut/machine/state.hpp"
#include "taut/math/index.hpp"

/// Whether a machine stands in a motion: on its feet, upright.
namespace taut::checks {
namespace {

constexpr double dragged_way = 0.1;                      ///< m; feet give way by less under what they hold
constexpr double upright = 10 * std::numbers::pi / 180;  ///< rad; a load that is lifted swings by less
constexpr double rounded_slope = 1e-3;                   ///< rad; of the places of a deck, as a slope from foot to foot

/// Whether a rope meets a body at such a node.
template <class Such>
bool meets_ropes(const machine::Model& m, int body, const Such& such) {
  return std::any_of(m.reevings.begin(), m.reevings.end(), [&](const machine::Reeving& rope) {
    return std::any_of(rope.nodes.begin(), rope.nodes.end(),
                       [&](const machine::Node& node) { return node.at.body == body && such(node); });
  });
}

/// By drums or sheaves on it, also those that are points: a machine, or a part of one, no load.
bool carries_ropes(const machine::Model& m, int body) {
  return meets_ropes(
      m, body, [](const machine::Node& node) { return node.kind != machine::NodeKind::anchor || node.radius > 0; });
}

bool holds_ropes(const machine::Model& m, int body) {
  return meets_ropes(m, body, [](const machine::Node&) { return true; });
}

/// A winch that stands there. What has only sheaves may be skidded by their ropes.
bool has_drum(const machine::Model& m, int body) {
  return meets_ropes(m, body, [](const machine::Node& node) { return node.drum.has_value(); });
}

/// Whether ropes end on it at one of these anchors.
bool ends_ropes(const machine::Model& m, int body, const std::vector<AnchorCheckRequest>& anchors) {
  return meets_ropes(m, body, [&](const machine::Node& node) {
    return node.kind == machine::NodeKind::anchor &&
           std::any_of(anchors.begin(), anchors.end(), [&](const auto& one) { return one.name == node.name; });
  });
}

bool is_fixed(const machine::Model& m, int body) {
  return body == machine::ground || (m.bodies[body].free.empty() && m.bodies[body].driven.empty());
}

/// By a signal, out of the upright; or a point of a rope, or a section of a beam, which no deck turns.
bool is_turned_by_deck(const machine::Body& body) {
  return body.of_rope || body.beam ||
         std::any_of(body.driven.begin(), body.driven.end(),
                     [](const machine::DrivenWay& way) { return way.about.head<2>().norm() > 0; });
}

/// Bodies where the deck has them.
machine::State as_described(const machine::Model& m) {
  machine::State state;
  for (const machine::Body& body : m.bodies)
    state.bodies.push_back({.position = body.position, .orientation = body.orientation});
  return state;
}

Vector3 normal_of(const machine::Face& face, const machine::State& state) {
  return machine::in_ground(state, {.body = face.body, .at = face.from + face.normal}) -
         machine::in_ground(state, {.body = face.body, .at = face.from});
}

/// What is fixed, or stands on that: a mat.
bool bears(const machine::Model& m, int body) {
  return is_fixed(m, body) || std::any_of(m.contacts.begin(), m.contacts.end(), [&](const machine::FaceContact& one) {
           return one.body == body && is_fixed(m, m.faces[one.face].body);
         });
}

/// Contacts by which each body stands on what is fixed, or on a mat there: on a face that looks up rather than aside,
/// no bumper's.
std::map<int, std::vector<std::size_t>> feet_of(const machine::Model& m) {
  const machine::State state = as_described(m);
  std::map<int, std::vector<std::size_t>> feet;
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    const machine::Face& face = m.faces[m.contacts[i].face];
    if (is_fixed(m, m.contacts[i].body) || !bears(m, face.body)) continue;
    const Vector3 normal = normal_of(face, state);
    if (normal.z() > normal.head<2>().norm()) feet[m.contacts[i].body].push_back(i);
  }
  return feet;
}

/// A body and what it carries in its faces and by cylinders, from one to the next. What stands on it by feet, as on a
/// mat, is not a part of it.
std::set<int> carried_by(const machine::Model& m, int body, const std::map<int, std::vector<std::size_t>>& feet) {
  std::set<int> all = {body};
  bool more = true;
  const auto join = [&](int one, int other) {
    if (is_fixed(m, one) || is_fixed(m, other) || all.contains(one) == all.contains(other)) return;
    all.insert({one, other});
    more = true;
  };
  const auto is_foot = [&](std::size_t contact) {
    const auto own = feet.find(m.contacts[contact].body);
    return own != feet.end() && std::find(own->second.begin(), own->second.end(), contact) != own->second.end();
  };
  while (more) {
    more = false;
    for (std::size_t i = 0; i < m.contacts.size(); ++i) {
      if (!is_foot(i)) join(m.contacts[i].body, m.faces[m.contacts[i].face].body);
    }
    for (const machine::Actuator& actuator : m.actuators) join(actuator.from_body, actuator.to_body);
  }
  return all;
}

/// By a plain end of a rope whose other end a body hangs on: below it rather than aside.
bool hangs_loads(const machine::Model& m, int body) {
  const machine::State state = as_described(m);
  return std::any_of(m.reevings.begin(), m.reevings.end(), [&](const machine::Reeving& rope) {
    const auto hangs_on = [&](const machine::Node& held, const machine::Node& by) {
      if (rope.closed || by.at.body != body || held.at.body == body || is_fixed(m, held.at.body)) return false;
      const Vector3 up = machine::in_ground(state, by.at) - machine::in_ground(state, held.at);
      return up.z() > up.head<2>().norm();
    };
    return hangs_on(rope.nodes.front(), rope.nodes.back()) || hangs_on(rope.nodes.back(), rope.nodes.front());
  });
}

/// How far a foot is over its face, m.
double gap_of(const machine::Model& m, const machine::FaceContact& foot, const machine::State& state) {
  const machine::Face& face = m.faces[foot.face];
  const Vector3 off = machine::in_ground(state, {.body = foot.body, .at = foot.at}) -
                      machine::in_ground(state, {.body = face.body, .at = face.from});
  return off.dot(normal_of(face, state)) + foot.clearance;
}

/// Whether a foot is no higher over the ground than another one of the same body.
bool as_low_as(const machine::Model& m, std::size_t foot, std::size_t other, const machine::State& state) {
  const machine::FaceContact &one = m.contacts[foot], &two = m.contacts[other];
  return gap_of(m, one, state) <= gap_of(m, two, state) + rounded_slope * (one.at - two.at).norm();
}

/// How a body is turned from where the deck has it.
Matrix3 turned_to(const machine::Model& m, const solve::TransientFrame& moment, std::size_t body) {
  return moment.bodies[body].orientation * m.bodies[body].orientation.transpose();
}

/// By which angle what was upright leans then, rad.
double leans_by(const Matrix3& turned) { return std::acos(std::clamp(turned(2, 2), -1.0, 1.0)); }

/// Bodies that a signal turns, and those that keep their attitude to one of them with which they are in contact by a
/// face: the sections of a boom that luffs.
std::vector<bool> turned_with_deck(const machine::Model& m, const solve::TransientFrame& moment) {
  std::vector<bool> with;
  for (const machine::Body& body : m.bodies) with.push_back(is_turned_by_deck(body));
  for (bool more = true; more;) {
    more = false;
    for (const auto& contact : m.contacts) {
      const int face = m.faces[contact.face].body;
      if (contact.body == machine::ground || face == machine::ground) continue;
      const std::size_t one = as_size(contact.body), other = as_size(face);
      if (with[one] == with[other]) continue;
      if (leans_by(turned_to(m, moment, one).transpose() * turned_to(m, moment, other)) > fallen_angle) continue;
      with[one] = with[other] = more = true;
    }
  }
  return with;
}

}  // namespace

/// Bodies that carry ropes, or are an anchor, or have loads hang on them, and stand by feet; a chassis has these on
/// what it carries by its own faces and cylinders.
std::map<int, std::vector<std::size_t>> Judge::standing(const machine::Model& m) const {
  std::map<int, std::vector<std::size_t>> feet = feet_of(m);
  std::erase_if(feet, [&](const std::pair<const int, std::vector<std::size_t>>& one) {
    const std::set<int> all = carried_by(m, one.first, feet);
    return one.second.size() < 2 || std::none_of(all.begin(), all.end(), [&](int body) {
             return carries_ropes(m, body) || is_anchor(m, body) || hangs_loads(m, body);
           });
  });
  return feet;
}

/// The end of a rope that the deck checks as an anchor.
bool Judge::is_anchor(const machine::Model& m, int body) const {
  return deck_->checks && ends_ropes(m, body, deck_->checks->anchors);
}

/// Feet that have stood so far, or are meant to: as low as one that has, where the deck has them. Another may hang
/// above the ground.
std::vector<std::size_t> Judge::meant_to_stand(const machine::Model& m, std::vector<std::size_t> feet) const {
  const machine::State described = as_described(m);
  const std::vector<std::size_t> all = feet;
  std::erase_if(feet, [&](std::size_t foot) {
    return !stood_.contains(foot) && std::none_of(all.begin(), all.end(), [&](std::size_t other) {
      return stood_.contains(other) && as_low_as(m, foot, other, described);
    });
  });
  return feet;
}

/// What holds ropes may not fall over; what carries them and stands by feet may not lift one of those once all that are
/// meant to stand have stood. A load, or a hook block, may be picked up: then all of its feet are off the ground.
void Judge::take_stand(const machine::Model& m, const solve::TransientFrame& moment, const std::string& words) {
  const std::vector<bool> with_deck = turned_with_deck(m, moment);
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (!with_deck[b] && holds_ropes(m, static_cast<int>(b))) take_lean(m, moment, b, words);
  }
  for (std::size_t i = 0; i < std::min(m.contacts.size(), moment.faces.size()); ++i) {
    if (moment.faces[i].closed) stood_.insert(i);
  }
  if (moment.faces.size() < m.contacts.size()) return;
  const std::map<int, std::vector<std::size_t>> all_feet = feet_of(m);
  for (const auto& [body, all] : standing(m)) {
    const std::vector<std::size_t> feet = meant_to_stand(m, all);
    if (feet.size() < 2) continue;
    if (!std::all_of(feet.begin(), feet.end(), [&](std::size_t i) { return stood_.contains(i); })) continue;
    const std::set<int> parts = carried_by(m, body, all_feet);
    const bool is_load =
        std::none_of(parts.begin(), parts.end(), [&](int part) { return has_drum(m, part) || is_anchor(m, part); });
    if (!is_load) take_ways_of_feet(m, moment, feet, words);
    take_lifted(m, moment, feet, is_load, words);
  }
}

/// Feet of one body that are off the ground.
void Judge::take_lifted(const machine::Model& m, const solve::TransientFrame& moment,
                        const std::vector<std::size_t>& feet, bool is_load, const std::string& words) {
  const int body = m.contacts[feet.front()].body;
  const bool stands = std::any_of(feet.begin(), feet.end(), [&](std::size_t i) { return moment.faces[i].closed; });
  // in a fall a crane may jump off its last foot too
  if (!stands && is_load && leans_by(turned_to(m, moment, as_size(body))) < upright) picked_up_.insert(body);
  for (const std::size_t foot : feet) {
    if (moment.faces[foot].closed) continue;
    const std::string told = fmt::format("{}: '{}' lifts '{}' off the ground: it begins to tip", words,
                                         m.bodies[body].name, m.contacts[foot].name);
    if (is_load) {
      lifted_.try_emplace(foot, told);
    } else {
      warn({.part = {.kind = PartKind::contact, .name = m.contacts[foot].name}, .what = "lifted"}, told, true);
    }
  }
}

/// Of the motion as a whole: feet that were lifted by what may be a load, but was not picked up. And what stands on
/// some of its feet, and never on another that is as low, has tipped from the start.
void Judge::take_feet(const machine::Model& m, const std::string& words) {
  for (const auto& [foot, lifted] : lifted_) {
    if (!picked_up_.contains(m.contacts[foot].body))
      warn({.part = {.kind = PartKind::contact, .name = m.contacts[foot].name}, .what = "lifted"}, lifted, true);
  }
  for (const auto& [body, all] : standing(m)) {
    for (const std::size_t foot : meant_to_stand(m, all)) {
      if (stood_.contains(foot)) continue;
      warn({.part = {.kind = PartKind::contact, .name = m.contacts[foot].name}, .what = "never stood"},
           fmt::format("{}: '{}' never stands on '{}', though it does on feet that are no lower where the deck has "
                       "them: it tips or leans from the start",
                       words, m.bodies[body].name, m.contacts[foot].name),
           true);
    }
  }
}

/// What stands by friction is not to be dragged away. A foot without friction is one that rolls.
void Judge::take_ways_of_feet(const machine::Model& m, const solve::TransientFrame& moment,
                              const std::vector<std::size_t>& feet, const std::string& words) {
  for (const std::size_t foot : feet) {
    const machine::FaceContact& contact = m.contacts[foot];
    const solve::TransientFrame::FaceContact& is = moment.faces[foot];
    if (!(std::max(contact.kinetic_friction, contact.static_friction) > 0)) continue;
    const auto [stood, first] = footprints_.try_emplace(foot, is.point);
    const double way = (is.point - stood->second).norm();
    if (first || way <= dragged_way) continue;
    warn({.part = part_of_body(m, contact.body), .what = "dragged"},
         fmt::format("{}: '{}' is dragged {} from where it stood: the friction of '{}' does not hold it", words,
                     m.bodies[contact.body].name, deck_->display.brief(way, si::m), contact.name),
         true, way);
  }
}

void Judge::take_lean(const machine::Model& m, const solve::TransientFrame& moment, std::size_t body,
                      const std::string& words) {
  const std::string& name = m.bodies[body].name;
  const double lean = leans_by(turned_to(m, moment, body));
  if (lean <= fallen_angle) return;
  warn({.part = part_of_body(m, static_cast<int>(body)), .what = "fallen"},
       fmt::format("{}: '{}' has tipped over, or begins far from where it works: it leans {} from where the "
                   "deck has it; where that is its work, describe it in the middle of its range",
                   words, name, deck_->display.brief(lean, si::rad)),
       true, lean);
}

}  // namespace taut::checks
