#include "taut/calc/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/stretches.hpp"
#include "taut/calc/shown.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/boom_ropes/drawing.hpp"
#include "taut/methods/boom_ropes/sliding.hpp"
#include "taut/methods/boom_ropes/slip.hpp"
#include "taut/methods/boom_ropes/tables.hpp"
#include "taut/units/display.hpp"

namespace taut::boom_ropes {
namespace {

constexpr std::size_t largest_grid = 200'000;

/// F_1, F_2, ... have no place of their own in the struct.
void add_case_values(const Input& in, const Output& out, Result& r) {
  std::vector<Value> forces;
  for (std::size_t i = 0; i < out.F.size(); ++i) {
    const Case& c = in.cases[i];
    const char* const from = c.operation == Operation::lift      ? "(4)"
                             : c.operation == Operation::retract ? "(5)"
                                                                 : "(4*)";
    forces.push_back({fmt::format("F_{}", i + 1), out.F[i], si::N, fmt::format("F_{}", i + 1),
                      fmt::format("force on section 3, {}", c.name.empty() ? name_of(c.operation) : c.name), from});
  }
  r.values.insert(r.values.begin(), forces.begin(), forces.end());
}

std::vector<Comparison> comparisons(const Output& out) {
  if (std::isnan(out.C1_corrected)) return {};
  const std::string why = "corrected: C1 that fits the published tensions";
  std::vector<Comparison> all = {{.quantity = "share of each extension branch",
                                  .symbol = "lambda_1",
                                  .unit = si::one,
                                  .printed = out.lambda_1,
                                  .corrected = out.lambda_1_corrected,
                                  .exact = unset,
                                  .build_by = why,
                                  .printed_unsafe = false},
                                 {.quantity = "share of the retraction rope",
                                  .symbol = "lambda_2",
                                  .unit = si::one,
                                  .printed = out.lambda_2,
                                  .corrected = out.lambda_2_corrected,
                                  .exact = unset,
                                  .build_by = why,
                                  .printed_unsafe = shown_below(out.lambda_2, out.lambda_2_corrected)}};
  if (std::isnan(out.S20_min)) return all;
  const auto add = [&](const char* quantity, const char* symbol, double printed, double corrected) {
    all.push_back({quantity, symbol, si::N, printed, corrected, unset, why, shown_below(printed, corrected)});
  };
  add("least pretension of the extension rope", "S_10min", out.S10_min, out.S10_min_corrected);
  add("least pretension of the retraction rope", "S_20min", out.S20_min, out.S20_min_corrected);
  add("pretension of the extension rope that balances it", "S_10b", out.S10_balance, out.S10_balance_corrected);
  return all;
}

void add_assumptions(const Input& in, const Output& out, const Display& display, Result& r) {
  r.assumptions.emplace_back("Statics: no inertia, no swinging load. F0 is taken with the boom horizontal.");
  if (!out.F.empty()) {
    r.assumptions.emplace_back(
        "Cases: pads do not jam, sheaves run free; tensions at section 3, of one branch for S1.");
    r.assumptions.emplace_back(
        "S10_min and S20_min are each taken with the F0 that makes them larger; never below zero.");
  }
  if (!in.sliding) return;
  const Sliding& q = *in.sliding;
  r.assumptions.push_back(fmt::format(
      "Sliding: section 3 moves {} relative to section 2 with f = {:.3g}; S1 (one branch) and S2 are tensions at "
      "section 3, means in steady motion, no peaks.",
      q.operation == Operation::extend ? "outward (d = +1)" : "inward (d = -1)", q.kinetic_friction));
  if (!q.falls) {
    r.assumptions.push_back(
        fmt::format("Sliding: falls not given, K = {} as in the paper for this operation.", falls_of(q)));
  }
  if (!q.S10 && !in.S10) {
    r.assumptions.push_back(
        fmt::format("Sliding: S10 not given, {} as calibrated.", display.brief(calibrated_S10, si::N)));
  }
  if (!q.S20 && !in.S20) {
    r.assumptions.push_back(
        fmt::format("Sliding: S20 not given, {} as calibrated.", display.brief(calibrated_S20, si::N)));
  }
  std::string left;
  for (const Given& g : r.given) {
    if (g.is_default && g.key.starts_with("sliding.") && g.key.find('[') == std::string::npos) {
      left += (left.empty() ? "" : ", ") + g.key.substr(8);
    }
  }
  if (!left.empty()) {
    r.assumptions.emplace_back("Sliding: left at the calibrated values of the KS-55713-5K-1: " + left + ".");
  }
}

/// Places of the sections at which sliding has no answer.
void add_missing(const Output& out, const Display& display, Result& r) {
  const auto lost = [](const SlidingPoint& p) { return !p.ok(); };
  const auto first = std::find_if(out.grid.begin(), out.grid.end(), lost);
  if (first == out.grid.end()) return;
  Stretches all;
  for (const SlidingPoint& one : out.grid) all.take(one.ok() ? "" : one.reason, place(one, display), {});
  r.missing.push_back({.analysis = "sliding",
                       .missing = static_cast<int>(std::count_if(out.grid.begin(), out.grid.end(), lost)),
                       .places = static_cast<int>(out.grid.size()),
                       .first = place(*first, display),
                       .reason = first->reason,
                       .all = all.few_places()});
}

void add_tables(const Input& in, const Output& out, const Display& display, Result& r) {
  if (!out.F.empty()) r.tables.push_back(cases_table(in, out, display));
  if (in.tensioning_steps > 0) {
    r.tables.push_back(tensioning_table("tensioning", "Tensioning the ropes in turn until section 3 slips",
                                        out.F0_retraction, in.tensioning_steps));
    // The paper rounds f0 G3 to 0.01 kN before it starts; its Table 1 shows that number's multiples.
    r.tables.push_back(tensioning_table("tensioning_printed",
                                        "The same with f0 G3 rounded to 0.01 kN, as Table 1 has it",
                                        std::round(out.F0_retraction / 10) * 10, in.tensioning_steps));
  }
  if (!out.grid.empty()) r.tables.push_back(extension_table(out));
  if (!in.sliding || in.sliding->slip_angles.empty()) return;
  std::vector<SlipAngle> slips;
  slips.reserve(in.sliding->slip_angles.size());
  for (const Slip& one : in.sliding->slip_angles) slips.push_back(slip_angle(in, *in.sliding, one));
  for (std::size_t i = 0; i < slips.size(); ++i) {
    if (slips[i].holds || !std::isnan(slips[i].angle)) continue;
    r.unmade.push_back(fmt::format("slip_angles[{}] has no answer: {}", i, slips[i].reason));
  }
  r.tables.push_back(slip_table(*in.sliding, slips));
}

/// The ropes of the cases are those of the sliding sections: they are put up once.
void complain_of_pretension(const std::optional<double>& of_input, const std::optional<double>& sliding,
                            const char* key, std::vector<Complaint>& all) {
  if (!of_input || !sliding || std::abs(*of_input - *sliding) <= 1e-9 * std::abs(*of_input)) return;
  all.push_back({fmt::format("sliding.{}", key),
                 fmt::format("the input has '{0}' = {1:.6g} kN, and it is the same rope: leave 'sliding.{0}' out, or "
                             "give the same in both",
                             key, *of_input / 1e3)});
}

void complain_of_sliding(const Sliding& q, std::vector<Complaint>& all) {
  const auto needs = [&](const std::vector<double>& list, const char* key) {
    if (list.empty())
      all.push_back({fmt::format("sliding.{}", key), fmt::format("'{}' needs at least one value", key)});
  };
  needs(q.boom_length, "boom_length");
  needs(q.luffing_angle, "luffing_angle");
  needs(q.suspended_weight, "suspended_weight");
  if (q.boom_length.size() * q.luffing_angle.size() * q.suspended_weight.size() > largest_grid) {
    all.push_back({"sliding.boom_length", fmt::format("the lists span more than {} positions", largest_grid)});
  }
  if (q.overlap_23 + equaliser_distance >= q.extension_length) {
    all.push_back({"sliding.extension_length",
                   fmt::format("half of the extension rope must be longer than {:.6g} m, its branch at section 3",
                               q.overlap_23 + equaliser_distance)});
  }
  if (q.retraction_length <= shortest_branch) {
    all.push_back({"sliding.retraction_length", fmt::format("must be longer than {} m", shortest_branch)});
  }
}

}  // namespace

std::vector<Complaint> complaints(const Input& in) {
  std::vector<Complaint> all;
  if (in.S10.has_value() != in.S20.has_value()) {
    all.push_back({in.S10 ? "S10" : "S20",
                   fmt::format("give 'S10' and 'S20' together: '{}' is missing", in.S10 ? "S20" : "S10")});
  }
  if (in.sliding) {
    complain_of_pretension(in.S10, in.sliding->S10, "S10", all);
    complain_of_pretension(in.S20, in.sliding->S20, "S20", all);
  }
  if (in.sliding) complain_of_sliding(*in.sliding, all);
  return all;
}

Result run(const Input& in) { return run(in, Display()); }

Result run(const Input& in, const Display& display) {
  const Method& m = about();
  Result r = result_of(m, Input::describe(), &in);
  Sheet<Num> s(m.short_source, Input::describe(), &in);
  s.show_in(display);
  Output out;
  const Outcome outcome = compute(in, s, out);
  r.status = outcome.status;
  r.message = outcome.message;
  r.values = values_of(Output::describe(), &out);
  add_case_values(in, out, r);
  add_tables(in, out, display, r);
  r.comparisons = comparisons(out);
  r.figures = figures(in, out, display);
  if (!outcome.ok()) r.figures.insert(r.figures.begin(), boom_without_answer(in, display));
  s.move_to(r);
  add_assumptions(in, out, display, r);
  if (outcome.ok()) add_missing(out, display, r);
  r.unjudged = {"extension", "retraction"};  // their strength: the input names no ropes, checks may
  return r;
}

}  // namespace taut::boom_ropes
