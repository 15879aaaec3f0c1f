#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/checks/guy/guy_checks.hpp"
#include "taut/checks/mast/machine_masts.hpp"
#include "taut/checks/rope/rope_strength.hpp"
#include "taut/math/index.hpp"
#include "taut/rope/guy.hpp"

namespace taut::checks {
namespace {

bool is_guy(const CheckedDeck& deck, const machine::Reeving& rope) {
  return std::any_of(deck.machine.guys.begin(), deck.machine.guys.end(),
                     [&](const auto& guy) { return guy.name == rope.name; });
}

/// Whether a rope ends at such a body, at whatever point of it.
template <class Is>
bool ends_at(const machine::Reeving& rope, const Is& is) {
  return is(rope.nodes.front().at.body) || is(rope.nodes.back().at.body);
}

/// Guys that are fixed to the mast's beams, and the least of their breaking forces in use (0: one is not known).
struct MastGuys {
  int number = 0;
  double weakest = HUGE_VAL;
  std::string unknown;             ///< why one is not known; empty: all are
  std::string heat;                ///< " x 0.75 (...)", of the weakest
  std::vector<Doubt> doubts = {};  ///< of all
};
MastGuys guys_of(const MastStates& mast, const CheckedDeck& deck, const machine::Model& model) {
  const auto on_mast = [&](int body) {
    if (body == machine::ground || !model.bodies[body].beam) return false;
    return std::find(mast.beams.begin(), mast.beams.end(), as_size(*model.bodies[body].beam)) != mast.beams.end();
  };
  MastGuys all;
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    const machine::Reeving& rope = model.reevings[i];
    if (!is_guy(deck, rope) || !ends_at(rope, on_mast)) continue;
    all.number += rope.copies;
    const StrengthInUse in_use = strength_in_use(deck, i);
    if (rope.breaking_force == 0) all.unknown = "the breaking force of a guy is not known";
    if (!in_use.unknown.empty()) all.unknown = in_use.unknown;
    for (const Doubt& one : in_use.doubts) {
      const bool known = std::any_of(all.doubts.begin(), all.doubts.end(),
                                     [&](const Doubt& other) { return other.source == one.source; });
      if (!known) all.doubts.push_back(one);
    }
    if (in_use.share * rope.breaking_force >= all.weakest) continue;
    all.weakest = in_use.share * rope.breaking_force;
    all.heat = in_use.words;
  }
  return all;
}

}  // namespace

std::optional<double> guy_stiffness(const CheckedDeck& deck, const CheckState& state, std::size_t beam) {
  rope::RingStiffness ring;
  bool any = false;
  const int top = state.model->beams[beam].pieces.back().end.body;
  for (const CheckBranch& span : state.branches) {
    const machine::Reeving& rope = state.model->reevings[span.reeving];
    if (!is_guy(deck, rope) || !ends_at(rope, [&](int body) { return body == top; })) continue;
    any = true;
    if (span.unstretched * (1 + rope.thermal_strain) >= span.chord) continue;  // slack ones give nothing
    const Vector3 d = span.end - span.start;
    rope::GuyLine line;
    line.length = span.chord;
    line.slope = std::atan2(d.z(), std::hypot(d.x(), d.y()));
    line.weight = rope.weight;
    line.stiffness = rope.stiffness;
    line.tension = span.mean;
    rope::RingStiffness one = rope::in_ring(rope::horizontal_stiffness(line), std::atan2(d.y(), d.x()));
    for (int copy = 0; copy < rope.copies; ++copy) ring = ring + one;
  }
  if (!any) return std::nullopt;
  const double mean = (ring.xx + ring.yy) / 2;
  return mean - std::hypot((ring.xx - ring.yy) / 2, ring.xy);
}

void add_top_check(const MastStates& mast, double bending, const machine::Model& model, Result& r) {
  const MastCheckRequest& request = *mast.request;
  if (!request.top_criterion) return;
  double height = 0;
  for (const std::size_t beam : mast.beams) height += model.beams[beam].length;
  const double wanted = *request.top_criterion * structure::euler_load(1, bending, height) / height;
  add_part_check(
      request.name, "top_stiffness", std::isfinite(mast.guy_stiffness) ? mast.guy_stiffness : 0, si::N_per_m.in("kN/m"),
      {.sense = Sense::at_least,
       .limit = wanted,
       .rule = fmt::format(
           "horizontal stiffness of the guys at its top in their weakest direction against {:.3g} N_cr/L of the "
           "mast hinged at both ends; {}",
           *request.top_criterion, mast.where_stiffness.empty() ? "no guy is fixed there" : mast.where_stiffness),
       .trust = "UNVERIFIED: 3 to 4 recalled practice"},
      r);
}

void add_plate_checks(const MastStates& mast, const CheckedDeck& deck, const machine::Model& model, Result& r) {
  const MastCheckRequest& request = *mast.request;
  if (!request.plate) return;
  const MastGuys guys = guys_of(mast, deck, model);
  if (request.plate->guys) {
    add_part_check(request.name, "guys_by_plate", guys.number, si::one,
                   {.sense = Sense::at_least,
                    .limit = *request.plate->guys,
                    .rule = "number of guylines against the plate of the spar (WAC 296-54-553)",
                    .trust = "verified"},
                   r);
  }
  if (!request.plate->guy_strength || guys.number == 0) return;
  if (!guys.unknown.empty()) {
    r.unmade.push_back(fmt::format("{}: {}: 'plate.guy_strength' is not checked", request.name, guys.unknown));
    r.warnings.push_back(r.unmade.back());
    return;
  }
  add_part_check(request.name, "guy_strength_by_plate", guys.weakest, si::N,
                 with_doubts({.sense = Sense::at_least,
                              .limit = *request.plate->guy_strength,
                              .rule = fmt::format("breaking force of the weakest guyline{} against the plate of the "
                                                  "spar (WAC 296-54-553)",
                                                  guys.heat),
                              .trust = "verified"},
                             {}, guys.doubts),
                 r);
}

}  // namespace taut::checks
