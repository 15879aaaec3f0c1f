#include "taut/machine/compile/given.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "taut/base/array.hpp"
#include "taut/machine/compile/drums.hpp"

namespace taut::machine {
namespace {

using description::Haul;

/// The tension that the drum at an end of the path gives by its pull, or by its torque.
std::optional<double> pull_of(const Machine& machine, const Model& model, const description::PathElement& e,
                              const RopeData& rope, int copies, DriveKind kind) {
  if (!e.drum) return std::nullopt;
  for (std::size_t i = 0; i < machine.drums.size(); ++i) {
    const Drive& drive = model.drums[i].drive;
    if (machine.drums[i].name != *e.drum || drive.kind != kind) continue;
    return kind == DriveKind::pull ? at(drive.signal, 0).value : pull_of_torque(machine.drums[i], drive, rope, copies);
  }
  return std::nullopt;
}

/// The motor on the path, if there is one.
const Motor* motor_on(const Model& model, const description::Reeving& given) {
  for (const auto& e : given.path) {
    for (const Motor& motor : model.motors) {
      if (e.over && motor.name == *e.over) return &motor;
    }
  }
  return nullptr;
}

bool gives_torque(const Motor& motor) { return motor.drive.kind == DriveKind::torque; }

int haul_of(const description::Reeving& given, const Reeving& reeving) {
  if (given.haul != Haul::automatic) return given.haul == Haul::to_end ? 1 : -1;
  if (given.closed) return 1;
  if (given.path.front().drum) return -1;
  if (given.path.back().drum) return 1;
  const bool pulled_at_end = reeving.also && reeving.also->first == Given::tension_at_end;
  return reeving.given == Given::tension_at_end || pulled_at_end ? 1 : -1;
}

}  // namespace

void set_given(const Machine& machine, const Model& model, const description::Reeving& given, const RopeData& rope,
               const std::string& path, Reeving& reeving, std::vector<Complaint>& complaints) {
  struct Said {
    Given what;
    double value;
    const char* words;
  };
  Array<Said> said;
  const auto take = [&](const std::optional<double>& value, Given what, const char* words) {
    if (value) said.push_back({what, *value, words});
  };
  take(given.length, Given::length, "length");
  take(given.tension_at_start, Given::tension_at_start, "tension_at_start");
  take(given.tension_at_end, Given::tension_at_end, "tension_at_end");
  if (given.install) said.push_back({Given::length, 0, "install"});
  const Motor* motor = motor_on(model, given);
  if (given.install && (given.closed || (motor != nullptr && !gives_torque(*motor)))) {
    complaints.push_back({path + ".install", "is for ropes with two ends and without a motor on their path"});
    return;
  }
  if (given.closed) {
    if (said.empty() && motor != nullptr && gives_torque(*motor)) take(0, Given::torque, "torque");
    if (said.empty()) complaints.push_back({path, "an endless rope is given by its 'length', or its motor's 'torque'"});
    if (said.size() == 1 && said[0].what != Given::length && said[0].what != Given::torque) {
      complaints.push_back({path, "an endless rope has no ends with tensions: give its 'length'"});
    }
  } else if (!given.path.empty()) {
    const auto pull = [&](const description::PathElement& e, DriveKind kind) {
      return pull_of(machine, model, e, rope, given.copies, kind);
    };
    take(pull(given.path.front(), DriveKind::pull), Given::tension_at_start, "the pull of its first drum");
    take(pull(given.path.back(), DriveKind::pull), Given::tension_at_end, "the pull of its last drum");
    // beside a length or tension a torque is what a motion begins with
    if (said.empty()) {
      take(pull(given.path.front(), DriveKind::torque), Given::tension_at_start, "the torque of its first drum");
      take(pull(given.path.back(), DriveKind::torque), Given::tension_at_end, "the torque of its last drum");
    }
  }
  std::vector<std::string> words;
  words.reserve(said.size());
  for (const Said& one : said) words.emplace_back(one.words);
  const bool takes_two = !given.closed && motor != nullptr && !gives_torque(*motor);
  if (takes_two && (said.size() != 2 || said[0].what == said[1].what)) {
    complaints.push_back({path, fmt::format("runs over a sheave with a motor: needs two of length, tension_at_start, "
                                            "tension_at_end, or the motor's 'torque'; it has {}",
                                            words.empty() ? "none" : fmt::format("{}", fmt::join(words, " and ")))});
  } else if (said.empty() && !given.closed) {
    complaints.push_back(
        {path, "needs one of length, install, tension_at_start, tension_at_end (or a drum with a pull or a torque)"});
  } else if (said.size() > 1 && !takes_two) {
    complaints.push_back({path, fmt::format("has {}; give one of them", fmt::join(words, " and "))});
  }
  if (!said.empty()) {
    reeving.given = said[0].what;
    reeving.value = said[0].value;
  }
  if (takes_two && said.size() == 2) reeving.also = std::pair(said[1].what, said[1].value);
  if (!given.path.empty()) reeving.haul = haul_of(given, reeving);
}

}  // namespace taut::machine
