#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "taut/checks/judge.hpp"
#include "taut/checks/parts.hpp"

/// What the verdict speaks of.
namespace taut::checks {
namespace {

constexpr double of_largest = 1e-9;    ///< a rope carries tension from this share of the machine's largest one on
constexpr double on_own_limit = 1e-6;  ///< a state of a payload lies on a limit to this share of it

/// "sheaves a, b" of the names; nothing of none.
std::string listed(const char* kind, const std::vector<std::string>& names) {
  return names.empty() ? std::string{} : fmt::format("{} {}", kind, fmt::join(names, ", "));
}

template <class Things>
std::vector<std::string> names_of_all(const Things& things) {
  std::vector<std::string> names;
  names.reserve(things.size());
  for (const auto& one : things) names.push_back(one.name);
  return names;
}

/// A state of a payload lies on its own limit, to the tolerance of its search.
void pass_on_own_limit(std::vector<Check>& checks) {
  for (Check& c : checks) {
    if (c.passes || c.refused || !(std::abs(c.utilisation - 1) <= on_own_limit)) continue;
    c.value = c.limit;
    c.utilisation = 1;
    c.passes = true;
  }
}

/// The names of what holds ropes in the ground, each once.
std::vector<std::string> anchors_in_ground(const machine::Model& m) {
  std::vector<std::string> anchors;
  for (const machine::Reeving& rope : m.reevings) {
    if (rope.closed) continue;
    for (const machine::Node* end : {&rope.nodes.front(), &rope.nodes.back()}) {
      const bool held = end->kind == machine::NodeKind::anchor && !end->drum && end->at.body == machine::ground;
      if (held && std::find(anchors.begin(), anchors.end(), end->name) == anchors.end()) anchors.push_back(end->name);
    }
  }
  return anchors;
}

}  // namespace

void Judge::add_scope_of(const Part& part, const std::vector<Part>& exempt, Result& r) const {
  const bool limited =
      std::any_of(r.checks.begin(), r.checks.end(), [&](const Check& c) { return judges(c, part.name); });
  const bool out = std::find(exempt.begin(), exempt.end(), part) != exempt.end();
  if (!limited && !out) r.unjudged.push_back(part.name);
}

void Judge::add_scope(Result& r) const {
  const ChecksRequest asked = deck_->checks.value_or(ChecksRequest{});
  r.exempt = asked.exempt;
  const std::vector<Part> exempt = exempt_parts(asked, deck_->machine);
  take_out(exempt, r);
  const bool payload = std::any_of(deck_->analyses.begin(), deck_->analyses.end(),
                                   [](const auto& one) { return one.payload.has_value(); });
  if (payload) pass_on_own_limit(r.checks);
  // what is slack at rest may be loaded by a motion
  const auto most = [](const RopeWorst& rope) { return std::max(rope.T, rope.peak); };
  double largest = 0;
  for (const auto& [name, rope] : ropes_) largest = std::max(largest, most(rope));
  for (const auto& [name, rope] : ropes_) {
    if (!rope.carries || most(rope) <= of_largest * largest) continue;
    add_scope_of({.kind = PartKind::rope, .name = name}, exempt, r);
  }
  for (const machine::Beam& beam : model_->beams) add_scope_of({.kind = PartKind::beam, .name = beam.name}, exempt, r);
  const auto add_beside = [&](const char* words, std::initializer_list<PartKind> kinds,
                              std::vector<std::string> names) {
    std::erase_if(names, [&](const std::string& name) {
      return std::any_of(r.checks.begin(), r.checks.end(), [&](const Check& c) {
        return c.part == name && std::find(kinds.begin(), kinds.end(), c.kind) != kinds.end();
      });
    });
    if (const std::string text = listed(words, names); !text.empty()) r.beside.push_back(text);
  };
  add_beside("sheaves", {PartKind::sheave}, names_of_all(deck_->machine.sheaves));
  add_beside("supports", {PartKind::sheave}, names_of_all(deck_->machine.supports));
  add_beside("carriages", {PartKind::carriage}, names_of_all(deck_->machine.carriages));
  add_beside("anchors", {PartKind::point, PartKind::body}, anchors_in_ground(*model_));
  add_beside("contacts", {PartKind::contact}, names_of_all(model_->contacts));
  for (const std::string& rope : off_ground_) {
    r.beside.push_back(fmt::format("the ground below {}, off the line of the terrain", rope));
  }
  for (const std::string& rope : slack_over_ground_) {
    r.beside.push_back(fmt::format("the ground below {} where it is slack or nearly so", rope));
  }
  add_beside("cylinders", {PartKind::cylinder}, names_of_all(deck_->machine.actuators));
}

}  // namespace taut::checks
