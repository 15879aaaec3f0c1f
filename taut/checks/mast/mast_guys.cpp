#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/checks/guy/guy_checks.hpp"
#include "taut/checks/mast/machine_masts.hpp"
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

/// Guys that are fixed to the mast's beams, and the least of their breaking forces (0: one is not known).
struct MastGuys {
  int number = 0;
  double weakest = HUGE_VAL;
};
MastGuys guys_of(const MastStates& mast, const CheckedDeck& deck, const machine::Model& model) {
  const auto on_mast = [&](int body) {
    if (body == machine::ground || !model.bodies[body].beam) return false;
    return std::find(mast.beams.begin(), mast.beams.end(), as_size(*model.bodies[body].beam)) != mast.beams.end();
  };
  MastGuys all;
  for (const machine::Reeving& rope : model.reevings) {
    if (!is_guy(deck, rope) || !ends_at(rope, on_mast)) continue;
    all.number += rope.copies;
    all.weakest = std::min(all.weakest, rope.breaking_force);
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
  if (guys.weakest == 0) {
    r.unmade.push_back(
        fmt::format("{}: the breaking force of a guy is not known: 'plate.guy_strength' is not checked", request.name));
    r.warnings.push_back(r.unmade.back());
    return;
  }
  add_part_check(request.name, "guy_strength_by_plate", guys.weakest, si::N,
                 {.sense = Sense::at_least,
                  .limit = *request.plate->guy_strength,
                  .rule = "breaking force of the weakest guyline against the plate of the spar (WAC 296-54-553)",
                  .trust = "verified"},
                 r);
}

}  // namespace taut::checks
