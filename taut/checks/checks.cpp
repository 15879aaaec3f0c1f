#include "taut/checks/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "taut/base/suggest.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/checks/heat_and_cold.hpp"
#include "taut/checks/parts.hpp"

namespace taut::checks {
namespace {

/// Of several checks of one name and part, as of states at rest and of a motion, the worst.
std::vector<Check> worst_of_each(std::vector<Check> all) {
  std::vector<Check> worst;
  std::map<std::pair<std::string, PartKind>, std::size_t> known;
  for (Check& c : all) {
    const auto [at, is_new] = known.try_emplace(std::pair(c.name, c.kind), worst.size());
    if (is_new) {
      worst.push_back(std::move(c));
    } else if (worse_state(c, worst[at->second])) {
      worst[at->second] = std::move(c);
    }
  }
  return worst;
}

bool has(const std::string& words, const std::string& text) { return words.find(text) != std::string::npos; }

/// Whether a text is the name of a check, or its last part, that of the checks of all parts: "elastic_limit".
bool is_name(const std::string& text, const std::string& name) { return name == text || name.ends_with("." + text); }

/// Takes away the doubts that the text names: all of a check by its name, else those with such a source. The first one
/// that is left has the trust.
void confirm(const std::string& text, Check& c) {
  if (!is_unverified(c.trust)) return;
  if (c.doubts.empty()) c.doubts.push_back({.trust = c.trust, .source = c.rule});
  const bool whole = is_name(text, c.name);
  std::erase_if(c.doubts, [&](const Doubt& one) { return whole || has(one.source, text); });
  c.trust = c.doubts.empty() ? fmt::format("user: confirmed in the deck ('{}')", text) : c.doubts.front().trust;
}

/// Checks that the user answers for.
void confirm(const std::vector<std::string>& confirmed, Result& r) {
  for (const std::string& text : confirmed) {
    bool met = false;
    for (Check& c : r.checks) {
      met |= has(c.rule, text) || is_name(text, c.name) ||
             std::any_of(c.doubts.begin(), c.doubts.end(), [&](const Doubt& one) { return has(one.source, text); });
      confirm(text, c);
    }
    if (!met) r.warnings.push_back(fmt::format("'confirmed': no check has '{}' in its name or rule", text));
  }
}

/// A check on an unverified number has no limit that this deck accepts.
void refuse_unverified(Result& r) {
  for (Check& c : r.checks) {
    if (!is_unverified(c.trust) || c.refused) continue;
    // a number beside the limit is named, where the rule does not
    const bool beside = !c.doubts.empty() && !has(c.rule, c.doubts.front().source);
    c.rule = fmt::format(
        "refused ('refuse_unverified'), as it rests on an unverified number ({}): compare it with the source "
        "named, then give it in the deck as your own or name the source under 'confirmed', or choose a rule that is "
        "verified; {}",
        beside ? c.doubts.front().source : fmt::format("{:.6g} {}", c.limit, c.unit.symbol), c.rule);
    c.limit = c.utilisation = std::numeric_limits<double>::quiet_NaN();
    c.passes = false;
    c.refused = true;
  }
}

}  // namespace

void finish_checks(const ChecksRequest& request, Result& r) {
  confirm(request.confirmed, r);
  if (request.refuse_unverified) refuse_unverified(r);
  r.checks = grouped(worst_of_each(std::move(r.checks)));
}

void complain_of_confirmed(const ChecksRequest& request, std::vector<Complaint>& complaints) {
  constexpr std::ptrdiff_t least = 3;  // letters and digits: "EN" is in the words of most rules
  for (std::size_t i = 0; i < request.confirmed.size(); ++i) {
    const std::string& text = request.confirmed[i];
    const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0; };
    if (std::count_if(text.begin(), text.end(), is_letter) >= least) continue;
    complaints.push_back({fmt::format("checks.confirmed[{}]", i),
                          fmt::format("'{}' names no source: give one as in 'EN 1993-1-1' or 'ISO 4309'", text)});
  }
}

AskedChecks resolve(const CheckedDeck& deck, const machine::Model& model, std::vector<Complaint>& complaints) {
  AskedChecks asked;
  if (!deck.checks) return asked;
  complain_of_confirmed(*deck.checks, complaints);
  complain_of_exempt(*deck.checks, deck.machine, complaints);
  asked.ropes = resolve_ropes(*deck.checks, deck, model, complaints);
  complain_of_masts(deck.checks->masts, deck, model, complaints);
  complain_of_guys(deck.checks->guys, deck, model, complaints);
  complain_of_anchors(deck.checks->anchors, deck.machine, model, complaints);
  complain_of_lines(deck.checks->lines, model, complaints);
  complain_of_supports(deck.checks->supports, model, complaints);
  complain_of_yarders(deck.checks->yarders, model, complaints);
  return asked;
}

void add_checks(const CheckedDeck& deck, const machine::Model& model, const CheckedParts& seen, Result& r) {
  const bool elsewhere = seen.seen_apart && !seen.seen;  // all states were checked on machines of their own
  if (deck.checks && !elsewhere) {
    add_rope_checks(*deck.checks, deck, model, seen.ropes.all(), r);
    add_machine_masts(seen.masts, deck, model, r);
    add_guy_checks(seen.guys, deck, model, r);
    add_anchor_checks(seen.anchors, deck, r);
    add_line_checks(seen.lines, deck, model, r);
    add_support_checks(seen.supports, r);
    add_yarder_checks(seen.yarders, r);
  }
  if (!elsewhere) {
    add_carriage_checks(seen.carriages, r);
    add_unjudged_heat(deck, model, r);
    warn_of_cold(deck, r);
  }
  if (seen.put_up && !seen.seen && !seen.seen_apart) {
    r.unmade.emplace_back("no state of the machine in use is judged, but those alone in which it is put up");
    r.warnings.push_back(r.unmade.back());
  }
  for (const auto& [rope, words] : seen.ropes.growing()) {
    const AboutPart about(r, {.kind = PartKind::rope, .name = rope});
    warn_unsafe(r, words);
  }
  if (seen.unheld.any()) {
    r.unmade.push_back(seen.unheld.words_of_first());
    r.warnings.push_back(seen.unheld.words());
  }
  if (seen.unbounded.any()) warn_unsafe(r, seen.unbounded.words());
  r.warnings.insert(r.warnings.end(), seen.unseen.begin(), seen.unseen.end());
  r.unmade.insert(r.unmade.end(), seen.unseen.begin(), seen.unseen.end());
  finish_checks(deck.checks.value_or(ChecksRequest{}), r);
  drop_loaded(r);
  seen.judge.add_scope(r);
}

}  // namespace taut::checks
