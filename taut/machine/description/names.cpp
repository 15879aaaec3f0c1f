#include "taut/machine/description/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "taut/base/suggest.hpp"

namespace taut::machine {
namespace {

class KnownNames {
 public:
  explicit KnownNames(const Machine& machine) : machine_(machine) {
    add(machine.bodies, bodies_);
    add(machine.carriages, bodies_);
    add(machine.beams, bodies_);
    add(machine.ropes, ropes_);
    for (const auto& one : machine.reevings) reevings_.push_back(name_of(one));
    for (const auto& beam : machine.beams) bodies_.push_back(beam.name + ".top");
    places_ = bodies_;
    add(machine.points, places_);
    add(machine.markers, places_);
    add(machine.sheaves, places_);
    add(machine.supports, places_);
    add(machine.drums, places_);
  }

  std::vector<Complaint> check() {
    owners("points", machine_.points);
    owners("markers", machine_.markers);
    owners("sheaves", machine_.sheaves);
    owners("supports", machine_.supports);
    owners("drums", machine_.drums);
    for (const auto& car : machine_.carriages) carriage(car, fmt::format("carriages.{}.", car.name));
    for (std::size_t i = 0; i < machine_.reevings.size(); ++i) {
      reeving(machine_.reevings[i], fmt::format("reevings[{}]", i));
    }
    for (const auto& guy : machine_.guys) {
      look(guy.rope, "rope", ropes_, fmt::format("guys.{}.rope", guy.name));
      look(guy.from, "point or body", places_, fmt::format("guys.{}.from", guy.name));
      look(guy.to, "point or body", places_, fmt::format("guys.{}.to", guy.name));
    }
    for (const auto& beam : machine_.beams) {
      look(beam.from, "point or body", places_, fmt::format("beams.{}.from", beam.name));
      look(beam.to, "point or body", places_, fmt::format("beams.{}.to", beam.name));
    }
    each(machine_.loads, "loads", [&](const auto& one, const std::string& path) {
      look(one.at, "body, carriage or point", places_, path + ".at");
    });
    each(machine_.take_up, "take_up", [&](const auto& one, const std::string& path) {
      look(one.body, "body or carriage", bodies_, path + ".body");
    });
    each(machine_.rope_loads, "rope_loads",
         [&](const auto& one, const std::string& path) { look(one.rope, "reeving", reevings_, path + ".rope"); });
    return std::move(complaints_);
  }

 private:
  template <class All>
  static void add(const All& all, std::vector<std::string>& names) {
    for (const auto& one : all) names.push_back(one.name);
  }

  template <class All, class Look>
  void each(const All& all, const char* list, const Look& look) {
    for (std::size_t i = 0; i < all.size(); ++i) look(all[i], fmt::format("{}[{}]", list, i));
  }

  /// An empty name is one that is missing, which was reported when it was read.
  void look(const std::string& name, const char* kind, const std::vector<std::string>& all, const std::string& path) {
    if (name.empty() || std::find(all.begin(), all.end(), name) != all.end()) return;
    complaints_.push_back({path, fmt::format("there is no {} '{}'{}", kind, name, did_you_mean(name, all))});
  }

  void look(const std::optional<std::string>& name, const char* kind, const std::vector<std::string>& all,
            const std::string& path) {
    if (name) look(*name, kind, all, path);
  }

  template <class All>
  void owners(const char* list, const All& all) {
    for (const auto& one : all) look(one.body, "body", bodies_, fmt::format("{}.{}.body", list, one.name));
  }

  void carriage(const description::Carriage& car, const std::string& path) {
    look(car.rides, "reeving", reevings_, path + "rides");
    look(car.fixed_to, "reeving", reevings_, path + "fixed_to");
    look(car.mainline, "reeving", reevings_, path + "mainline");
    look(car.haulback, "reeving", reevings_, path + "haulback");
  }

  void reeving(const description::Reeving& one, const std::string& path) {
    look(one.rope, "rope", ropes_, path + ".rope");
    for (std::size_t k = 0; k < one.path.size(); ++k) {
      const description::PathElement& e = one.path[k];
      const std::string at = fmt::format("{}.path[{}]", path, k);
      look(e.anchor, "point or body", places_, at + ".anchor");
      look(e.over, "sheave or support", places_, at + ".over");
      look(e.through, "carriage", places_, at + ".through");
      look(e.drum, "drum", places_, at + ".drum");
      for (std::size_t b = 0; b < e.between.size(); ++b) {
        look(e.between[b], "sheave", places_, fmt::format("{}.between[{}]", at, b));
      }
    }
  }

  const Machine& machine_;
  std::vector<std::string> bodies_, ropes_, reevings_, places_;
  std::vector<Complaint> complaints_;
};

}  // namespace

std::vector<Complaint> unknown_names(const Machine& machine) { return KnownNames(machine).check(); }

}  // namespace taut::machine
