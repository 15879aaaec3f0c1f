#include "taut/checks/yarder/yarder_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/suggest.hpp"
#include "taut/calc/none.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/math/index.hpp"
#include "taut/rope/drum.hpp"

namespace taut::checks {
namespace {

const machine::Reeving* reeving_of_yarder(const machine::Model& model, const std::string& name) {
  const auto found =
      std::find_if(model.reevings.begin(), model.reevings.end(), [&](const auto& one) { return one.name == name; });
  return found == model.reevings.end() ? nullptr : &*found;
}

const catalogue::YarderDrum& drum_of(const YarderLineStates& s) { return *s.request->row.drum_of(s.line.line); }

/// Tension at the end on the drum; without a drum in the machine the larger one of both ends.
double tension_at_yarder(const CheckState& state, int reeving) {
  const machine::Reeving& rope = state.model->reevings[reeving];
  const int last = static_cast<int>(rope.nodes.size()) - 1;
  const bool starts = rope.nodes.front().drum.has_value(), ends = rope.nodes.back().drum.has_value();
  double T = none;
  for (const CheckBranch& b : state.branches) {
    if (b.reeving != reeving) continue;
    if (b.from == 0 && (starts || !ends)) T = std::fmax(T, b.on_start.norm());
    if (b.to == last && (ends || !starts)) T = std::fmax(T, b.on_end.norm());
  }
  return rope.copies * T;
}

double length_in_use(const CheckState& state, int reeving) {
  const int copies = state.model->reevings[reeving].copies;
  if (state.rest != nullptr) return copies * state.rest->ropes[as_size(reeving)].unstretched;
  double sum = 0;
  for (const CheckBranch& b : state.branches) {
    if (b.reeving == reeving) sum += copies * b.unstretched;
  }
  return sum;
}

double needed_length(const YarderLineStates& s) {
  const double lateral = s.line.line == "mainline" ? s.request->lateral : 0;
  return s.in_use.value + s.copies * (s.request->spare + lateral);
}

double working_limit(const catalogue::YarderDrum& drum) { return drum.hold.value_or(drum.pull); }

const Quantities<YarderLineStates>& yarder_quantities() {
  using Row = YarderLineStates;
  static const Quantities<Row> all = {
      {"yarder", "", si::one, "the yarder by its name in the catalogue",
       [](const Row& s) { return s.request->row.name; }},
      {"drum", "", si::one, "its drum", [](const Row& s) { return s.line.line; }},
      {"rope", "", si::one, "the reeving on it", [](const Row& s) { return s.line.reeving; }},
      {"diameter", "d", si::m.in("mm"), "diameter of its rope", &Row::diameter},
      {"in_use", "", si::m, "largest unstretched length between its ends", [](const Row& s) { return s.in_use.value; }},
      {"needed", "", si::m, "the same with what is spare and what is pulled out to the side",
       [](const Row& s) { return needed_length(s); }},
      {"available", "", si::m, "rope of this diameter that the drum takes",
       [](const Row& s) { return available_length(drum_of(s), s.diameter); }},
      {"tension", "T", si::N, "largest tension at the yarder's end", [](const Row& s) { return s.tension.value; }},
      {"pull", "", si::N, "rated pull of the drum when it is full", [](const Row& s) { return drum_of(s).pull; }},
      {"hold", "", si::N, "what its brake holds", [](const Row& s) { return drum_of(s).hold.value_or(none); }},
      {"speed", "v", si::m_per_s, "rated speed of the rope",
       [](const Row& s) { return drum_of(s).speed.value_or(none); }}};
  return all;
}

std::string capacity_words(const YarderLineStates& s) {
  const catalogue::YarderDrum& drum = drum_of(s);
  const auto diameter = [&](double d) { return s.display.brief(d, si::m.in("mm")); };
  const std::string own = diameter(s.diameter);
  if (drum.core) return fmt::format("layers of {} within the flanges of '{}'", own, s.request->row.name);
  const std::string rated = diameter(*drum.at_diameter);
  return fmt::format("{0} of {1} on '{2}', times ({1}/{3})^2", s.display.brief(*drum.capacity, si::m), rated,
                     s.request->row.name, own);
}

void check_length(const YarderLineStates& s, Result& r) {
  const auto length = [&](double x) { return s.display.brief(x, si::m); };
  const bool lateral = s.line.line == "mainline" && s.request->lateral > 0;
  const std::string aside = lateral ? fmt::format(", {} to the side", length(s.request->lateral)) : "";
  add_part_check(
      s.request->name, s.line.line + "_length", needed_length(s), si::m,
      {.sense = Sense::at_most,
       .limit = available_length(drum_of(s), s.diameter),
       .rule = fmt::format("length of '{}' that is needed: {} in use ({}), {} spare{}; available: {}", s.line.reeving,
                           length(s.in_use.value), s.in_use.where, length(s.request->spare), aside, capacity_words(s)),
       .trust = catalogue::trust_words(drum_of(s))},
      r);
}

void check_pull(const YarderLineStates& s, Result& r) {
  const catalogue::YarderDrum& drum = drum_of(s);
  const std::string trust = catalogue::trust_words(drum);
  add_part_check(
      s.request->name, s.line.line + "_pull", s.tension.value, si::N,
      {.sense = Sense::at_most,
       .limit = working_limit(drum),
       .rule = fmt::format("tension of '{}' at the yarder ({}) against {} of '{}'", s.line.reeving, s.tension.where,
                           drum.hold ? "what the brake holds" : "the pull with a full drum", s.request->row.name),
       .trust = trust},
      r);
  if (!drum.hold || std::isnan(s.put_up.value)) return;
  add_part_check(s.request->name, s.line.line + "_base_tension", s.put_up.value, si::N,
                 {.sense = Sense::at_most,
                  .limit = drum.pull,
                  .rule = fmt::format("tension at which '{}' is put up ({}) against the pull with a full drum of '{}'",
                                      s.line.reeving, s.put_up.where, s.request->row.name),
                  .trust = trust},
                 r);
}

}  // namespace

TableWords yarder_words() {
  return {.name = "yarder_lines", .rows = "every line of `checks: yarders:`", .columns = words_of(yarder_quantities())};
}

double available_length(const catalogue::YarderDrum& drum, double diameter) {
  if (drum.core) {
    if (*drum.face < diameter) return 0;
    const rope::DrumLayers layers{
        .core_diameter = *drum.core, .rope_diameter = diameter, .width = *drum.face, .flange_diameter = *drum.flange};
    return rope::drum_capacity(layers, rope::layers_within_flanges(layers));
  }
  const double ratio = *drum.at_diameter / diameter;
  return *drum.capacity * ratio * ratio;
}

void complain_of_yarders(const std::vector<YarderCheckRequest>& yarders, const machine::Model& model,
                         std::vector<Complaint>& complaints) {
  std::vector<std::string> known;
  for (const machine::Reeving& one : model.reevings) known.push_back(one.name);
  for (const YarderCheckRequest& one : yarders) {
    const std::string path = fmt::format("checks.yarders.{}", one.name);
    const std::vector<YarderLineRequest> lines = lines_of(one);
    if (lines.empty()) complaints.push_back({path, "say which lines are on it: skyline, mainline, haulback"});
    for (const YarderLineRequest& line : lines) {
      const std::string at = path + "." + line.line;
      const machine::Reeving* rope = reeving_of_yarder(model, line.reeving);
      if (rope == nullptr) {
        complaints.push_back(
            {at, fmt::format("there is no reeving '{}'{}", line.reeving, did_you_mean(line.reeving, known))});
      } else if (rope->closed) {
        complaints.push_back({at, fmt::format("'{}' is endless: no drum takes it", line.reeving)});
      } else if (!(rope->diameter > 0)) {
        complaints.push_back(
            {at, fmt::format("the diameter of '{}' is not known: give its rope a 'diameter'", line.reeving)});
      }
      if (one.row.drum_of(line.line) == nullptr)
        complaints.push_back({at, fmt::format("'{}' has no {} drum in the catalogue", one.row.name, line.line)});
    }
  }
}

std::vector<YarderLineStates> yarder_states(const std::vector<YarderCheckRequest>& yarders,
                                            const machine::Model& model) {
  std::vector<YarderLineStates> all;
  for (const YarderCheckRequest& one : yarders) {
    for (YarderLineRequest& line : lines_of(one)) {
      YarderLineStates& s = all.emplace_back();
      const machine::Reeving* rope = reeving_of_yarder(model, line.reeving);
      s.request = &one;
      s.line = std::move(line);
      s.reeving = static_cast<int>(rope - model.reevings.data());
      s.diameter = rope->diameter;
      s.copies = rope->copies;
    }
  }
  return all;
}

void take(const CheckState& state, YarderLineStates& line) {
  line.in_use.largest(length_in_use(state, line.reeving), state.words);
  const double T = tension_at_yarder(state, line.reeving);
  if (!std::isnan(T)) line.tension.largest(T, state.words);
}

void take_empty_line(const CheckState& state, const std::string& reeving, bool put_up, YarderLineStates& line) {
  if (line.line.reeving != reeving) return;
  const machine::Reeving* rope = reeving_of_yarder(*state.model, reeving);
  if (rope == nullptr) return;
  const int index = static_cast<int>(rope - state.model->reevings.data());
  line.in_use.largest(length_in_use(state, index), state.words);
  const double T = tension_at_yarder(state, index);
  if (!std::isnan(T)) (put_up ? line.put_up : line.tension).largest(T, state.words);
}

void add_yarder_checks(const std::vector<YarderLineStates>& lines, Result& r) {
  for (const YarderLineStates& s : lines) {
    const Part part = {.kind = PartKind::yarder, .name = s.request->name};
    const AboutPart about(r, part);
    if (std::isnan(s.in_use.value) || std::isnan(s.tension.value)) {
      leave_unmade(r,
                   fmt::format("{}: its {} is not checked: no load case of the deck has '{}'", s.request->name,
                               s.line.line, s.line.reeving),
                   {.part = part});
      continue;
    }
    add_line(r, "yarder_lines", "Lines of the yarders: needed against available length, tension against rated pull",
             yarder_quantities(), s);
    check_length(s, r);
    check_pull(s, r);
  }
}

}  // namespace taut::checks
