#include "taut/machine/links/links.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/base/array.hpp"
#include "taut/base/suggest.hpp"
#include "taut/machine/compile/carriages.hpp"

namespace taut::machine {
namespace {

std::string_view words(Thing thing) {
  switch (thing) {
    case Thing::point:
      return "point";
    case Thing::body:
      return "body";
    case Thing::carriage:
      return "carriage";
    case Thing::sheave:
      return "sheave or support";
    case Thing::drum:
      return "drum";
  }
  return "";
}

bool among(std::initializer_list<Thing> kinds, Thing thing) {
  return std::find(kinds.begin(), kinds.end(), thing) != kinds.end();
}

}  // namespace

Links::Links(const Machine& machine, std::vector<Complaint>& complaints)
    : beams_(machine, static_cast<int>(machine.bodies.size() + machine.carriages.size()), complaints) {
  all_.reserve(machine.points.size() + machine.markers.size() + machine.bodies.size() + machine.carriages.size() +
               machine.sheaves.size() + machine.supports.size() + machine.drums.size());
  const auto add = [&](Thing thing, const char* list, const auto& one, int index) {
    const Vector3 at = vector_of(one.at);
    const auto place = [&] {
      return place_on(machine, *one.body, at, fmt::format("{}.{}.body", list, one.name), complaints);
    };
    all_.push_back({thing, one.name, index, one.body ? place() : Place{.body = ground, .at = at}});
  };
  int index = 0;
  for (const auto& point : machine.points) add(Thing::point, "points", point, index++);
  for (const auto& marker : machine.markers) add(Thing::point, "markers", marker, index++);
  index = 0;
  for (const auto& body : machine.bodies) {
    all_.push_back({Thing::body, body.name, index, {.body = index, .at = Vector3::Zero()}});
    ++index;
  }
  const int first_carriage = index;
  index = 0;
  for (const auto& car : machine.carriages) {
    all_.push_back({Thing::carriage, car.name, index, {.body = first_carriage + index, .at = Vector3::Zero()}});
    ++index;
  }
  index = 0;
  for (const auto& sheave : machine.sheaves) add(Thing::sheave, "sheaves", sheave, index++);
  for (const auto& support : machine.supports) {
    const auto twin = std::find_if(machine.sheaves.begin(), machine.sheaves.end(),
                                   [&](const auto& sheave) { return sheave.name == support.name; });
    if (twin != machine.sheaves.end()) {
      complaints.push_back({fmt::format("supports.{}", support.name), "there is a sheave of this name already"});
    }
    add(Thing::sheave, "supports", support, index++);
  }
  index = 0;
  for (const auto& drum : machine.drums) add(Thing::drum, "drums", drum, index++);
  for (const auto& [name, body] : beams_.tops())
    all_.push_back({Thing::body, name, body, {.body = body, .at = Vector3::Zero()}});
}

Place Links::place_on(const Machine& machine, const std::string& body, const Vector3& at, const std::string& path,
                      std::vector<Complaint>& complaints) const {
  const auto of_name = [&](const auto& all) {
    return std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == body; });
  };
  const auto own = of_name(machine.bodies);
  if (own != machine.bodies.end()) return {.body = static_cast<int>(own - machine.bodies.begin()), .at = at};
  const auto car = of_name(machine.carriages);
  if (car != machine.carriages.end()) {
    if (!pitches(*car) && at != Vector3::Zero()) {
      complaints.push_back({path, fmt::format("carriage '{}' is a point; give it 'rollers' with a 'wheelbase', or a "
                                              "'height', to have places on it",
                                              car->name)});
    }
    const auto index = static_cast<std::size_t>(car - machine.carriages.begin());
    return {.body = static_cast<int>(machine.bodies.size() + index), .at = at};
  }
  if (beams_.knows(body)) return beams_.place(body, at);
  std::vector<std::string> known;
  known.reserve(machine.bodies.size() + machine.beams.size());
  for (const auto& one : machine.bodies) known.push_back(one.name);
  for (const auto& beam : machine.beams) known.push_back(beam.name);
  complaints.push_back({path, fmt::format("there is no body '{}'{}", body, did_you_mean(body, known))});
  return {.body = ground, .at = at};
}

Array<NamedPlace> Links::places() const {
  Array<NamedPlace> all;
  all.reserve(all_.size());
  for (const Thing kind : {Thing::point, Thing::sheave, Thing::drum}) {
    for (const Target& t : all_) {
      if (t.thing == kind) all.push_back({.name = t.name, .place = t.place});
    }
  }
  return all;
}

const Target* Links::find(const std::string& name, std::initializer_list<Thing> kinds, const DeckPlace& path,
                          std::vector<Complaint>& complaints) const {
  const Target* found = nullptr;
  for (const Thing kind : kinds) {
    const auto at =
        std::find_if(all_.begin(), all_.end(), [&](const Target& t) { return t.thing == kind && t.name == name; });
    if (at == all_.end()) continue;
    if (found == nullptr) {
      found = &*at;
    } else if (found->place.body != at->place.body || found->place.at != at->place.at) {
      complaints.push_back({path.text(), fmt::format("'{}' is a {} and, at another place, a {}: rename one of them",
                                                     name, words(found->thing), words(at->thing))});
      return nullptr;
    }
  }
  if (found != nullptr) return found;
  Array<std::string_view> wanted;
  wanted.reserve(kinds.size());
  for (const Thing kind : kinds) wanted.push_back(words(kind));
  const std::string kinds_text = fmt::format("{}", fmt::join(wanted, ", "));
  const auto other = std::find_if(all_.begin(), all_.end(), [&](const Target& t) { return t.name == name; });
  if (other != all_.end()) {
    complaints.push_back(
        {path.text(), fmt::format("'{}' is a {}; here a {} is named", name, words(other->thing), kinds_text)});
    return nullptr;
  }
  if (beams_.knows(name)) {
    complaints.push_back(
        {path.text(), fmt::format("'{}' is a beam: name its free top '{}.top', or a point on it, 'points: "
                                  "{{p: {{body: {}, at: [...]}}}}'",
                                  name, name, name)});
    return nullptr;
  }
  std::vector<std::string> names;
  for (const Target& t : all_) {
    if (among(kinds, t.thing)) names.push_back(t.name);
  }
  std::string hint = did_you_mean(name, names);
  if (hint.empty() && !names.empty() && names.size() <= 12) hint = fmt::format("; there is {}", fmt::join(names, ", "));
  complaints.push_back({path.text(), fmt::format("there is no {} '{}'{}", kinds_text, name, hint)});
  return nullptr;
}

}  // namespace taut::machine
