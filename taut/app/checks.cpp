#include "taut/app/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "taut/app/guy_checks.hpp"
#include "taut/app/machine_masts.hpp"
#include "taut/report/verdict.hpp"

namespace taut::app {
namespace {

/// The part that a check belongs to by its name, "skyline" of "skyline.T_max", where that is a part of the machine.
std::string part_of(const std::string& name, const std::vector<std::string>& parts) {
  std::string longest;
  for (const std::string& part : parts) {
    if (name.starts_with(part + ".") && part.size() > longest.size()) longest = part;
  }
  return longest;
}

std::vector<std::string> parts_of(const model::Model& model) {
  std::vector<std::string> parts;
  parts.reserve(model.reevings.size() + model.beams.size() + model.drums.size() + model.motors.size());
  for (const model::Reeving& one : model.reevings) parts.push_back(one.name);
  for (const model::Beam& one : model.beams) parts.push_back(one.name);
  for (const model::Drum& one : model.drums) parts.push_back(one.name);
  for (const model::Motor& one : model.motors) parts.push_back(one.name);
  return parts;
}

/// A check on an unverified number has no limit that this deck accepts.
int refuse_unverified(Result& r) {
  int refused = 0;
  for (Check& c : r.checks) {
    if (!report::is_unverified(c.trust)) continue;
    ++refused;
    c.rule =
        fmt::format("refused, as it rests on an unverified number ({:.6g} {}): {}", c.limit, c.unit.symbol, c.rule);
    c.limit = c.utilisation = std::numeric_limits<double>::quiet_NaN();
    c.passes = false;
  }
  return refused;
}

}  // namespace

void finish_checks(const ChecksRequest& request, Result& r) {
  if (request.refuse_unverified) {
    if (const int refused = refuse_unverified(r); refused > 0) {
      const std::string words = fmt::format(
          "{} check{} refused ('refuse_unverified'): confirm the number{} in the source named and give it in the deck "
          "as your own, or choose a rule that is verified",
          refused, refused == 1 ? " is" : "s are", refused == 1 ? "" : "s");
      r.message += r.message.empty() ? words : "; " + words;
    }
  }
  r.checks = grouped(std::move(r.checks));
}

std::vector<Complaint> check_complaints(const MachineDeck& deck, const model::Model& model) {
  std::vector<Complaint> complaints;
  if (!deck.checks) return complaints;
  complain_of_ropes(*deck.checks, deck, model, complaints);
  complain_of_masts(deck.checks->masts, deck, model, complaints);
  complain_of_guys(deck.checks->guys, deck, model, complaints);
  complain_of_anchors(deck.checks->anchors, model, complaints);
  complain_of_lines(deck.checks->lines, model, complaints);
  return complaints;
}

void add_checks(const MachineDeck& deck, const MachineRun& run, Result& r) {
  if (!deck.checks || r.status != Status::ok) return;
  add_rope_checks(*deck.checks, deck, run, r);
  add_machine_masts(deck.checks->masts, deck, run, r);
  add_guy_checks(deck.checks->guys, deck, run, r);
  add_anchor_checks(deck.checks->anchors, run, r);
  add_line_checks(deck.checks->lines, run, r);
  const std::vector<std::string> parts = parts_of(run.model);
  for (Check& c : r.checks) {
    if (c.part.empty()) c.part = part_of(c.name, parts);
  }
  finish_checks(*deck.checks, r);
}

}  // namespace taut::app
