#include "taut/results/answers/machine_answers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "taut/calc/answers.hpp"
#include "taut/calc/none.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/solve/quantities.hpp"

namespace taut::results {
namespace {

using checks::RopeSeen;

constexpr double same_length = 1e-6;  ///< lengths that differ by less than this share are one length
constexpr std::size_t most_rope_lines = 3;

const machine::description::Rope* rope_named(const machine::Machine& machine, const std::string& name) {
  const auto at =
      std::find_if(machine.ropes.begin(), machine.ropes.end(), [&](const auto& r) { return r.name == name; });
  return at == machine.ropes.end() ? nullptr : &*at;
}

/// One rope of the machine as it is rove, by the name that its results have.
struct Rove {
  std::string name;
  std::string designation;  ///< may be empty
  bool guy = false;
  bool chosen = false;  ///< by a design
};

std::vector<Rove> all_rove(const checks::CheckedDeck& deck, const Display& display) {
  std::vector<Rove> all;
  const auto add = [&](const std::string& name, const std::string& rope, bool guy) {
    Rove one{.name = name, .designation = {}, .guy = guy, .chosen = false};
    if (const auto row = deck.chosen.find(rope); row != deck.chosen.end()) {
      one.designation = catalogue::words_of_rope(row->second);
      one.chosen = true;
    } else if (const auto* given = rope_named(deck.machine, rope)) {
      one.designation = designation_of(*given, display);
    }
    all.push_back(std::move(one));
  };
  for (const auto& one : deck.machine.reevings) add(name_of(one), one.rope, false);
  for (const auto& one : deck.machine.guys) add(one.name, one.rope, true);
  return all;
}

const RopeSeen* seen_of(const std::vector<RopeSeen>& seen, const std::string& name) {
  const auto at = std::find_if(seen.begin(), seen.end(), [&](const RopeSeen& s) { return s.name == name; });
  return at == seen.end() ? nullptr : &*at;
}

bool is_one(const checks::LengthRange& range) { return range.most - range.least <= same_length * range.most; }

/// "148 m", "102 m to 148 m".
std::string range_words(const checks::LengthRange& range, const Display& display) {
  const std::string from = display.brief(range.least, si::m), to = display.brief(range.most, si::m);
  return from == to ? to : fmt::format("{} to {}", from, to);
}

/// "cut 382 m", "cut 190 m (102 m to 148 m between its ends)", "102 m to 148 m between its ends"; empty where no state
/// tells.
std::string length_words(const checks::RopeLengthsSeen& lengths, const Display& display) {
  if (std::isnan(lengths.free.most)) return {};
  const std::string between = range_words(lengths.free, display) + " between its ends";
  if (std::isnan(lengths.whole.most)) return between + " and what is on the drum";
  if (!is_one(lengths.whole)) return between;
  const std::string cut = "cut " + display.brief(lengths.whole.most, si::m);
  const bool wound = lengths.whole.most - lengths.free.least > same_length * lengths.whole.most;
  return wound ? fmt::format("{} ({})", cut, between) : cut;
}

std::string rope_line(const Rove& one, const RopeSeen* seen, const Result& r, const Display& display) {
  std::vector<std::string> parts;
  if (!one.designation.empty()) parts.push_back(one.designation);
  const double cut = number_of(r, one.name + ".cut_length");
  const std::string length = !std::isnan(cut)  ? "cut " + display.brief(cut, si::m)
                             : seen == nullptr ? std::string()
                                               : length_words(seen->lengths, display);
  if (!length.empty()) parts.push_back(length);
  const double base = number_of(r, one.name + ".base_tension");
  if (!std::isnan(base)) parts.push_back("base tension " + display.brief(base, si::N));
  return parts.empty() ? std::string() : fmt::format("{} {}", one.name, fmt::join(parts, ", "));
}

/// Guys of one rope in one part: they differ by their lengths.
std::string guys_line(const std::vector<const Rove*>& guys, const std::vector<RopeSeen>& seen, const Display& display) {
  std::vector<std::string> names;
  checks::LengthRange lengths;
  for (const Rove* one : guys) {
    names.push_back(one->name);
    const RopeSeen* own = seen_of(seen, one->name);
    if (own == nullptr) continue;
    lengths.take(own->lengths.free.least);
    lengths.take(own->lengths.free.most);
  }
  std::string text = fmt::format("guys {}", fmt::join(names, ", "));
  if (!guys.front()->designation.empty()) text += ": " + guys.front()->designation;
  return std::isnan(lengths.most) ? text : text + fmt::format(", {} unstretched", range_words(lengths, display));
}

/// A line of the answer before it is known how many there are.
struct RopeLine {
  bool chosen = false;
  std::string text;
};

std::vector<RopeLine> rope_lines(const std::vector<Rove>& all, const std::vector<RopeSeen>& seen, const Result& r,
                                 const Display& display) {
  std::vector<RopeLine> lines;
  std::vector<std::vector<const Rove*>> guys;
  for (const Rove& one : all) {
    if (!one.guy) {
      std::string line = rope_line(one, seen_of(seen, one.name), r, display);
      if (!line.empty()) lines.push_back({.chosen = one.chosen, .text = std::move(line)});
      continue;
    }
    const auto same = std::find_if(guys.begin(), guys.end(),
                                   [&](const auto& g) { return g.front()->designation == one.designation; });
    if (same == guys.end()) {
      guys.push_back({&one});
    } else {
      same->push_back(&one);
    }
  }
  for (const auto& group : guys)
    lines.push_back({.chosen = group.front()->chosen, .text = guys_line(group, seen, display)});
  return lines;
}

/// A line for each rope, those that are chosen first; what is left shares the last one.
void add_ropes(std::vector<RopeLine> lines, Result& r) {
  std::stable_partition(lines.begin(), lines.end(), [](const RopeLine& one) { return one.chosen; });
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<std::string> parts = {lines[i].text};
    const bool last = i + 1 == most_rope_lines;
    for (std::size_t k = i + 1; last && k < lines.size(); ++k) parts.push_back(lines[k].text);
    add_answer_line(r, lines[i].chosen ? build_label : given_label, parts);
    if (last) return;
  }
}

/// Over all states that were found, for decks that judge none.
std::vector<RopeSeen> seen_in_all(const MachineRun& run) {
  std::vector<RopeSeen> all;
  for (const Answer& state : answers_of(run)) {
    for (std::size_t i = 0; i < state.model->reevings.size(); ++i) {
      const std::string& name = state.model->reevings[i].name;
      auto own = std::find_if(all.begin(), all.end(), [&](const RopeSeen& s) { return s.name == name; });
      if (own == all.end()) own = all.insert(all.end(), RopeSeen{.name = name, .T = -HUGE_VAL, .where = {}});
      const auto& rope = state.result->ropes[i];
      if (rope.T_max > own->T) {
        own->T = rope.T_max;
        own->where = state.words;
      }
      own->lengths.take(*state.model, *state.result, static_cast<int>(i));
    }
  }
  return all;
}

void add_tensions(const std::vector<RopeSeen>& seen, const Display& display, Result& r) {
  std::vector<RopeSeen> order = seen;
  std::stable_sort(order.begin(), order.end(), [](const RopeSeen& a, const RopeSeen& b) { return a.T > b.T; });
  std::vector<std::string> parts;
  parts.reserve(order.size());
  for (const RopeSeen& one : order) {
    parts.push_back(fmt::format("{} {} ({})", one.name, display.brief(one.T, si::N), one.where));
  }
  add_answer_line(r, "Tension", parts);
}

/// "mast CHS 323.9x10, steel S355, stress 140 MPa (inhaul, in), top moves 45 mm" of each beam.
void add_beams(const machine::Machine& machine, const MachineRun& run, Result& r) {
  const auto& worst = run.checked->judge.beams();
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < run.model.beams.size() && i < worst.size(); ++i) {
    const auto given = std::find_if(machine.beams.begin(), machine.beams.end(),
                                    [&](const auto& one) { return one.name == run.model.beams[i].name; });
    if (given == machine.beams.end()) continue;
    std::string text = given->name;
    if (given->section) text += " " + *given->section;
    if (given->steel) text += ", steel " + *given->steel;
    if (!std::isnan(worst[i].stress.value)) {
      text += fmt::format(", stress {} ({})", run.display.brief(worst[i].stress.value, si::Pa), worst[i].stress.when);
    }
    if (!std::isnan(worst[i].top_displacement.value)) {
      const Unit& unit = named(solve::beam_quantities(), "top_displacement").about.unit;
      text += fmt::format(", top moves {}", run.display.brief(worst[i].top_displacement.value, unit));
    }
    parts.push_back(std::move(text));
  }
  add_answer_line(r, "Beams", parts);
}

void add_clearance(const Display& display, Result& r) {
  std::vector<std::string> parts;
  for (const auto& [name, what] : {std::pair{"clearance_min", "least height over the ground: carriage"},
                                   std::pair{"rope_clearance_min", "lowest rope"}}) {
    const Value* v = r.find_value(name);
    if (v != nullptr) parts.push_back(fmt::format("{} {}", what, display.brief(v->value, v->unit)));
  }
  add_answer_line(r, "Clearance", parts);
}

}  // namespace

std::string designation_of(const machine::description::Rope& rope, const Display& display) {
  if (rope.rope) {
    const auto row = catalogue::find_rope_in_words(*rope.rope);
    return row ? catalogue::words_of_rope(*row) : *rope.rope;
  }
  std::vector<std::string> parts;
  if (rope.diameter) parts.push_back(display.brief(*rope.diameter, si::m.in("mm")));
  if (rope.breaking_force) parts.push_back("breaking force " + display.brief(*rope.breaking_force, si::N));
  if (rope.mass.value_or(0) > 0) parts.push_back(display.brief(*rope.mass, si::kg_per_m));
  return fmt::format("{}", fmt::join(parts, ", "));
}

void add_answers(const checks::CheckedDeck& deck, const MachineRun& run, Result& r) {
  std::vector<RopeSeen> seen = run.checked->judge.ropes();
  if (seen.empty()) seen = seen_in_all(run);
  add_ropes(rope_lines(all_rove(deck, run.display), seen, r, run.display), r);
  add_tensions(seen, run.display, r);
  add_beams(deck.machine, run, r);
  add_clearance(run.display, r);
}

}  // namespace taut::results
