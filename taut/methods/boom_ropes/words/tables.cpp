#include "taut/methods/boom_ropes/tables.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/methods/boom_ropes/slip.hpp"

namespace taut::boom_ropes {
namespace {

/// One case under the pretension.
struct CaseRow {
  const Case& one;
  double F;  ///< N
  RopeTensions tensions;
  std::optional<RopeTensions> corrected;
  std::string governs;
};

std::string slack_of(const CaseRow& r) {
  return r.tensions.extension_slack ? "extension" : r.tensions.retraction_slack ? "retraction" : "";
}

const Quantities<CaseRow>& case_quantities() {
  using Row = CaseRow;
  static const Quantities<Row> all = {
      {"name", "", si::one, "name of the case", [](const Row& r) { return r.one.name; }},
      {"operation", "", si::one, "lift, retract or extend", [](const Row& r) { return name_of(r.one.operation); }},
      {"luffing_angle", "beta", si::rad, "luffing angle of the boom", [](const Row& r) { return r.one.luffing_angle; }},
      {"suspended_weight", "G_n", si::N, "weight of hook block and load",
       [](const Row& r) { return r.one.suspended_weight; }},
      {"F", "F", si::N, "longitudinal force on section 3 without that of its ropes, outward positive, (4), (5)",
       &Row::F},
      {"S1", "S_1", si::N, "tension of one branch of the extension rope, (2)",
       [](const Row& r) { return r.tensions.S1; }},
      {"S2", "S_2", si::N, "tension of the retraction rope, (2)", [](const Row& r) { return r.tensions.S2; }},
      {"slack", "", si::one, "the rope that is slack; empty: none", slack_of},
      {"governs", "", si::one, "the least pretension that the case governs by (3): S10, S20", &Row::governs},
      {"S1_corrected", "S_1c", si::N, "the same with the shares of the corrected stiffness, (2*), extension rope",
       [](const Row& r) { return r.corrected ? r.corrected->S1 : unset; }},
      {"S2_corrected", "S_2c", si::N, "the same for the retraction rope",
       [](const Row& r) { return r.corrected ? r.corrected->S2 : unset; }}};
  return all;
}

std::string governs(const Output& out, std::size_t i) {
  const bool high = i == out.highest_case;
  const bool low = i == out.lowest_case;
  if (high && low) return "S10 and S20";
  if (high) return "S10";
  return low ? "S20" : "";
}

/// One step of the alternate tensioning.
struct StepRow {
  double step;  ///< from 1
  TensioningStep tensions;
};

const Quantities<StepRow>& step_quantities() {
  using Row = StepRow;
  const auto of = [](double TensioningStep::*part) { return [part](const Row& r) { return r.tensions.*part; }; };
  static const Quantities<Row> all = {
      {"step", "", si::one, "number of the step, from 1", &Row::step},
      {"S10_extension_first", "S_10", si::N, "extension rope, where it is pulled before the retraction rope",
       of(&TensioningStep::S10_extension_first)},
      {"S20_extension_first", "S_20", si::N, "retraction rope, in the same order",
       of(&TensioningStep::S20_extension_first)},
      {"S10_retraction_first", "S_10", si::N, "extension rope, where the retraction rope is pulled before it",
       of(&TensioningStep::S10_retraction_first)},
      {"S20_retraction_first", "S_20", si::N, "retraction rope, in the same order",
       of(&TensioningStep::S20_retraction_first)}};
  return all;
}

const Quantities<SlidingPoint>& sliding_quantities() {
  using Row = SlidingPoint;
  static const Quantities<Row> all = {
      {"luffing_angle", "beta", si::rad, "luffing angle of the boom", &Row::luffing_angle},
      {"boom_length", "L_b", si::m, "length of the boom", &Row::boom_length},
      {"suspended_weight", "G_n", si::N, "weight of hook block and load", &Row::suspended_weight},
      {"Fh", "F_h", si::N, "cylinder force, positive where it pushes section 2 out; empty: the boom jams", &Row::Fh},
      {"S1", "S_1", si::N, "tension of one branch of the extension rope at section 3", &Row::S1},
      {"S2", "S_2", si::N, "tension of the retraction rope at section 3", &Row::S2},
      {"Nf", "N_f", si::N, "force of the front pads of section 3, positive where the lower ones carry", &Row::Nf},
      {"Nr", "N_r", si::N, "force of its rear pads, positive where the lower ones carry", &Row::Nr},
      {"Mf", "M_f", si::N, "force of the front pads of section 2, positive where the lower ones carry", &Row::Mf},
      {"Mr", "M_r", si::N, "force of its rear pads, positive where the lower ones carry", &Row::Mr},
      {"jamming", "", si::one, "1: front and rear pads of section 3 carry on opposite sides; else 0", [](const Row& p) {
         return std::isnan(p.Nf) ? unset : p.jamming() ? 1.0 : 0.0;
       }}};
  return all;
}

/// One slip angle that the deck asks for.
struct SlipRow {
  const Slip& asked;
  SlipAngle found;
};

const Quantities<SlipRow>& slip_quantities() {
  using Row = SlipRow;
  static const Quantities<Row> all = {
      {"boom_length", "L_b", si::m, "length of the boom", [](const Row& r) { return r.asked.boom_length; }},
      {"suspended_weight", "G_n", si::N, "weight of hook block and load",
       [](const Row& r) { return r.asked.suspended_weight; }},
      {"overlap_change", "", si::m, "change of the overlap by the jerk after the break; pulled in: positive",
       [](const Row& r) { return r.asked.overlap_change; }},
      {"slip_angle", "beta_1", si::rad, "lowest luffing angle at which section 3 slides in without its rope",
       [](const Row& r) { return r.found.angle; }},
      {"slip_angle_free", "beta_1", si::rad, "the same without jamming of the pads, (5) with F = 0",
       [](const Row& r) { return r.found.free_angle; }},
      {"jamming", "", si::one, "1: the pads carry on opposite sides at that angle; else 0",
       [](const Row& r) { return std::isnan(r.found.angle) ? unset
                                 : r.found.jamming         ? 1.0
                                                           : 0.0; }},
      {"reason", "", si::one, "why there is no such angle", [](const Row& r) { return r.found.reason; }}};
  return all;
}

}  // namespace

std::string name_of(Operation operation) {
  switch (operation) {
    case Operation::lift:
      return "lift";
    case Operation::retract:
      return "retract";
    case Operation::extend:
      return "extend";
  }
  return {};
}

Table cases_table(const Input& in, const Output& out, const Display& display) {
  std::vector<CaseRow> rows;
  rows.reserve(in.cases.size());
  for (std::size_t i = 0; i < in.cases.size(); ++i) {
    rows.push_back({.one = in.cases[i],
                    .F = out.F[i],
                    .tensions = tensions(out, out.F[i]),
                    .corrected = corrected_tensions(out, out.F[i]),
                    .governs = governs(out, i)});
  }
  const auto force = [&](double x) { return display.brief(x, si::N); };
  std::string title = fmt::format("Cases under a pretension of {} and {}", force(out.S10_set), force(out.S20_set));
  if (!std::isnan(out.S10_set_corrected)) {
    title += fmt::format(", by the corrected stiffness {} and {}", force(out.S10_set_corrected),
                         force(out.S20_set_corrected));
  }
  return make_table("cases", std::move(title), case_quantities(), rows);
}

Table tensioning_table(std::string name, std::string title, double friction, int steps) {
  std::vector<StepRow> rows;
  double step = 0;
  for (const TensioningStep& s : tensioning(friction, steps)) rows.push_back({.step = step += 1, .tensions = s});
  return make_table(std::move(name), std::move(title), step_quantities(), rows);
}

Table extension_table(const Output& out) {
  return make_table("extension", "Sections sliding, by weight, luffing angle and boom length", sliding_quantities(),
                    out.grid);
}

Table slip_table(const Sliding& sliding, const std::vector<SlipAngle>& found) {
  std::vector<SlipRow> rows;
  rows.reserve(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) rows.push_back({.asked = sliding.slip_angles[i], .found = found[i]});
  return make_table("slip_angles", "Luffing angle above which section 3 slides without its rope", slip_quantities(),
                    rows);
}

std::vector<TableWords> table_words() {
  return {{.name = "cases", .rows = "every case, under the pretension", .columns = words_of(case_quantities())},
          {.name = "tensioning",
           .rows = "every step of the alternate tensioning; `tensioning_printed` the same with the printed friction",
           .columns = words_of(step_quantities())},
          {.name = "extension",
           .rows = "every weight, luffing angle and boom length of the sliding sections",
           .columns = words_of(sliding_quantities())},
          {.name = "slip_angles", .rows = "every slip angle asked for", .columns = words_of(slip_quantities())}};
}

}  // namespace taut::boom_ropes
