#include "taut/machine/compile/given.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "taut/base/array.hpp"
#include "taut/machine/compile/drums.hpp"

namespace taut::machine {
namespace {

using description::Haul;

int ends_on(const Machine& machine, const std::string& drum) {
  int ends = 0;
  for (const description::Reeving& rope : machine.reevings) {
    if (rope.path.empty()) continue;
    for (const auto* e : {&rope.path.front(), &rope.path.back()}) ends += e->drum == drum ? 1 : 0;
  }
  return ends;
}

/// The tension that the drum at an end of the path gives by its pull, or by its torque; no rope alone has a torque that
/// several share.
std::optional<double> pull_of(const Machine& machine, const Model& model, const description::PathElement& e,
                              const DescribedReeving& described, DriveKind kind) {
  if (!e.drum) return std::nullopt;
  for (std::size_t i = 0; i < machine.drums.size(); ++i) {
    const Drive& drive = model.drums[i].drive;
    if (machine.drums[i].name != *e.drum || drive.kind != kind) continue;
    if (kind == DriveKind::pull) return at(drive.signal, 0).value;
    if (ends_on(machine, *e.drum) > 1) return std::nullopt;
    return pull_of_torque(
        {.machine = machine, .ropes = described.ropes, .drum = machine.drums[i], .rope = described.rope}, drive,
        described.given.copies);
  }
  return std::nullopt;
}

bool gives_torque(const Motor& motor) { return motor.drive.kind == DriveKind::torque; }

/// The motor that drives the rope, if there is one: of several the first without a given torque, else the first.
const Motor* motor_on(const Model& model, const description::Reeving& given) {
  const Motor* found = nullptr;
  for (const auto& e : given.path) {
    for (const Motor& motor : model.motors) {
      if (!e.over || motor.name != *e.over) continue;
      if (!gives_torque(motor)) return &motor;
      if (found == nullptr) found = &motor;
    }
  }
  return found;
}

/// The end of a path that draws a carriage at its other end, as the carriage's mainline or haulback; +1: its end.
int off_its_carriage(const Machine& machine, const description::Reeving& given) {
  for (const description::Carriage& car : machine.carriages) {
    if (car.mainline != name_of(given) && car.haulback != name_of(given)) continue;
    if (given.path.back().anchor == car.name) return -1;
    if (given.path.front().anchor == car.name) return 1;
  }
  return 0;
}

void set_haul(const Machine& machine, const description::Reeving& given, Reeving& reeving) {
  reeving.haul = given.haul == Haul::to_end ? 1 : -1;
  reeving.haul_is_told = given.haul != Haul::automatic;
  if (reeving.haul_is_told) return;
  const auto is_given = [&](Given tension) {
    return reeving.given == tension || (reeving.also && reeving.also->first == tension);
  };
  const int off = off_its_carriage(machine, given);
  if (given.closed) {
    reeving.haul = 1;
  } else if (given.path.front().drum || given.path.back().drum) {
    reeving.haul = given.path.front().drum ? -1 : 1;
  } else if (off != 0) {
    reeving.haul = off;
  } else if (is_given(Given::tension_at_end)) {
    reeving.haul = 1;
  }
}

/// One thing that a deck says of a rope.
struct Said {
  Given what;
  double value;
  const char* words;
};

/// All that is said of a rope, by its reeving first, then by its motor or its drums.
Array<Said> said_of(const Machine& machine, const Model& model, const DescribedReeving& described, const Motor* motor) {
  const description::Reeving& given = described.given;
  Array<Said> said;
  const auto take = [&](const std::optional<double>& value, Given what, const char* words) {
    if (value) said.push_back({what, *value, words});
  };
  take(given.length, Given::length, "length");
  take(given.tension_at_start, Given::tension_at_start, "tension_at_start");
  take(given.tension_at_end, Given::tension_at_end, "tension_at_end");
  if (given.install) said.push_back({Given::length, 0, "install"});
  if (given.tension_equals) said.push_back({Given::equal, 0, "tension_equals"});
  if (given.closed) {
    if (said.empty() && motor != nullptr && gives_torque(*motor)) take(0, Given::torque, "torque");
    return said;
  }
  if (given.path.empty()) return said;
  const auto pull = [&](const description::PathElement& e, DriveKind kind) {
    return pull_of(machine, model, e, described, kind);
  };
  take(pull(given.path.front(), DriveKind::pull), Given::tension_at_start, "the pull of its first drum");
  take(pull(given.path.back(), DriveKind::pull), Given::tension_at_end, "the pull of its last drum");
  // beside a length or tension a torque is what a motion begins with
  if (!said.empty()) return said;
  take(pull(given.path.front(), DriveKind::torque), Given::tension_at_start, "the torque of its first drum");
  take(pull(given.path.back(), DriveKind::torque), Given::tension_at_end, "the torque of its last drum");
  return said;
}

/// Why what is said does not give a rope; empty when it does. `two`: it takes two things.
std::string wrong_with(const Array<Said>& said, bool closed, bool two, const Motor* motor) {
  // a motor has one or the other
  const bool by_speed = motor != nullptr && motor->drive.kind == DriveKind::speed;
  const std::string torque = by_speed ? "motor's 'torque' in place of its 'speed'" : "motor's 'torque'";
  if (closed && said.empty()) return fmt::format("an endless rope is given by its 'length', or its {}", torque);
  if (closed && said.size() == 1 && said[0].what != Given::length && said[0].what != Given::torque) {
    return "an endless rope has no ends with tensions: give its 'length'";
  }
  std::vector<std::string> words;
  words.reserve(said.size());
  for (const Said& one : said) words.emplace_back(one.words);
  if (two && (said.size() != 2 || said[0].what == said[1].what)) {
    return fmt::format(
        "runs over a sheave with a motor: needs two of length, tension_at_start, tension_at_end, or the {}; it has "
        "{}{}",
        torque, words.empty() ? "none" : fmt::format("{}", fmt::join(words, " and ")),
        by_speed ? fmt::format(". A motion can begin with the torque, and an event at its start give the speed: "
                               "events: [{{at: 0 s, drive: {}, speed: ...}}]",
                               motor->name)
                 : std::string());
  }
  if (two) return {};
  if (said.empty()) {
    return "needs one of length, install, tension_at_start, tension_at_end, tension_equals (or a drum with a pull, or "
           "with a torque for this rope alone)";
  }
  return said.size() > 1 ? fmt::format("has {}; give one of them", fmt::join(words, " and ")) : std::string();
}

/// The rope whose tension this one is to have. Complaints: there is none, or it has none of its own.
void set_equal(const Machine& machine, const DescribedReeving& described, Reeving& reeving,
               std::vector<Complaint>& complaints) {
  const std::string& wanted = *described.given.tension_equals;
  const auto complain = [&](const std::string& words) {
    complaints.push_back({described.path + ".tension_equals", words});
  };
  for (std::size_t r = 0; r < machine.reevings.size(); ++r) {
    const description::Reeving& other = machine.reevings[r];
    if (name_of(other) != wanted) continue;
    if (&other == &described.given) return complain("a rope has its own tension already: name another one");
    if (other.tension_equals) {
      return complain(fmt::format("'{}' has that of '{}': name that rope here too", wanted, *other.tension_equals));
    }
    if (other.closed) return complain(fmt::format("'{}' is endless: it has no start", wanted));
    reeving.equal_to = static_cast<int>(r);
    return;
  }
  complain(fmt::format("no rope '{}'", wanted));
}

}  // namespace

void set_given(const Machine& machine, const Model& model, const DescribedReeving& described, Reeving& reeving,
               std::vector<Complaint>& complaints) {
  const description::Reeving& given = described.given;
  const Motor* motor = motor_on(model, given);
  const bool by_speed = motor != nullptr && !gives_torque(*motor);
  if (given.install && (given.closed || by_speed)) {
    complaints.push_back({described.path + ".install", "is for ropes with two ends and without a motor on their path"});
    return;
  }
  if (given.tension_equals && (given.closed || by_speed)) {
    complaints.push_back(
        {described.path + ".tension_equals", "is for ropes with two ends and without a motor on their path"});
    return;
  }
  if (given.tension_equals) set_equal(machine, described, reeving, complaints);
  const Array<Said> said = said_of(machine, model, described, motor);
  const bool takes_two = !given.closed && by_speed;
  std::string wrong = wrong_with(said, given.closed, takes_two, motor);
  const auto grooves = std::count_if(given.path.begin(), given.path.end(),
                                     [&](const auto& e) { return motor != nullptr && e.over == motor->name; });
  if (wrong.empty() && !said.empty() && said[0].what == Given::torque && grooves > 1) {
    wrong = fmt::format("runs over '{}' {} times: how they share its torque is not known at rest; give its 'length'",
                        motor->name, grooves);
  }
  if (!wrong.empty()) complaints.push_back({described.path, wrong});
  if (!said.empty()) {
    reeving.given = said[0].what;
    reeving.value = said[0].value;
    if (reeving.given == Given::length) reeving.described_length = given.length;  // none until the line is put up
  }
  if (takes_two && said.size() == 2) reeving.also = std::pair(said[1].what, said[1].value);
  if (!given.path.empty()) set_haul(machine, given, reeving);
}

}  // namespace taut::machine
