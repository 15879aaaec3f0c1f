#include "taut/methods/closed_loop/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/gravity.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/units/display.hpp"

namespace taut::closed_loop {
namespace {

using Number = double Output::*;

auto of(Number part) {
  return [part](const Row& row) { return row.out.*part; };
}

const Quantities<Row>& closed_form_quantities() {
  static const Quantities<Row> all = {
      {"x", "x", si::m, "position of the carriage, from A", of(&Output::x)},
      {"f", "f", si::m, "sag at the carriage", of(&Output::f)},
      {"P_b", "P_b", si::N, "load on the upper branch, oblique, by the paper's equations", of(&Output::P_b)},
      {"P_v", "P_v", si::N, "vertical part of the roller force on the upper branch", of(&Output::P_v)},
      {"T_uA", "T_uA", si::N, "tension of the upper branch at A", of(&Output::T_uA)},
      {"T_uB", "T_uB", si::N, "tension of the upper branch at B", of(&Output::T_uB)},
      {"T_lA", "T_lA", si::N, "tension of the lower branch (traction rope) at A", of(&Output::T_lA)},
      {"T_lB", "T_lB", si::N, "tension of the lower branch (return rope) at B", of(&Output::T_lB)},
      {"T_end_max", "T_end_max", si::N, "largest of the four end tensions", of(&Output::T_end_max)}};
  return all;
}

/// With catenaries, where the engine is at hand.
const Quantities<Row>& exact_quantities() {
  static const Quantities<Row> all = {
      {"P_b_exact", "P_b", si::N, "load on the upper branch, oblique, with catenaries", of(&Output::P_b_exact)},
      {"T_uA_exact", "T_uA", si::N, "tension of the upper branch at A, with catenaries", of(&Output::T_uA_exact)},
      {"T_uB_exact", "T_uB", si::N, "tension of the upper branch at B, with catenaries", of(&Output::T_uB_exact)},
      {"T_lA_exact", "T_lA", si::N, "tension of the lower branch (traction rope) at A, with catenaries",
       of(&Output::T_lA_exact)},
      {"T_lB_exact", "T_lB", si::N, "tension of the lower branch (return rope) at B, with catenaries",
       of(&Output::T_lB_exact)},
      {"loop_length_exact", "L", si::m, "unstretched length of the whole loop, with catenaries",
       of(&Output::loop_length_exact)}};
  return all;
}

const Quantities<Row>& reason_quantities() {
  static const Quantities<Row> all = {{"reason", "", si::one, "why the position has no answer; empty: it has one",
                                       [](const Row& row) { return std::string(row.outcome.message); }}};
  return all;
}

Quantities<Row> position_quantities(bool exact) {
  Quantities<Row> all = closed_form_quantities();
  if (exact) all = joined(all, exact_quantities());
  return joined(all, reason_quantities());
}

/// One of the two ropes, and where its tension is largest.
struct RopeRow {
  const char* role;
  const catalogue::RopeRow& rope;
  const Peak& peak;
  std::string where;
  bool named = false;  ///< else the deck has its weight alone
};

/// 0: not known.
double known(double value) { return value > 0 ? value : Output::none; }

const Quantities<RopeRow>& rope_quantities() {
  using R = RopeRow;
  static const Quantities<R> all = {
      {"role", "", si::one, "return or traction", [](const R& r) { return std::string(r.role); }},
      {"designation", "", si::one, "the rope of the catalogue, by its id; else that the deck has its weight",
       [](const R& r) { return r.rope.id; }},
      {"diameter", "d", si::m.in("mm"), "its nominal diameter", [](const R& r) { return known(r.rope.diameter); }},
      {"area", "A", si::m2, "its metallic cross-sectional area", [](const R& r) { return known(r.rope.area); }},
      {"mass_per_metre", "m", si::kg_per_m, "its mass per metre", [](const R& r) { return r.rope.mass_per_length; }},
      {"breaking_force", "F_min", si::N, "its minimum breaking force",
       [](const R& r) { return known(r.rope.breaking_force); }},
      {"largest_tension", "T_max", si::N, "largest tension of the rope over all positions and both hauls",
       [](const R& r) { return r.peak.tension; }},
      {"where", "", si::one, "branch, support and carriage position of that tension", &R::where},
      {"safety_factor", "n", si::one, "minimum breaking force over that tension",
       [](const R& r) { return known(r.rope.breaking_force) / r.peak.tension; }},
      {"trust", "", si::one, "trust in its row of the catalogue",
       [](const R& r) { return std::string(r.named ? catalogue::to_text(r.rope.trust) : "user"); }}};
  return all;
}

}  // namespace

bool has_exact(const std::vector<Row>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const Row& row) { return std::isfinite(row.out.T_lA_exact); });
}

Table positions_table(const std::vector<Row>& rows) {
  const bool exact = has_exact(rows);
  return make_table(
      "positions",
      fmt::format("Tensions over the carriage positions (closed-form tier{})", exact ? "; _exact: catenaries" : ""),
      position_quantities(exact), rows);
}

Table ropes_table(const Ropes& ropes, const Peaks& peaks, const Display& display) {
  const auto row_of = [](const std::optional<catalogue::RopeRow>& rope, double weight) {
    if (rope) return *rope;
    catalogue::RopeRow row;
    row.id = "by its weight";
    row.mass_per_length = weight / standard_gravity;
    return row;
  };
  const catalogue::RopeRow back = row_of(ropes.return_rope, ropes.q_b), pull = row_of(ropes.traction_rope, ropes.q_T);
  const std::vector<RopeRow> rows = {{.role = "return",
                                      .rope = back,
                                      .peak = peaks.return_rope,
                                      .where = place_of(peaks.return_rope, display),
                                      .named = ropes.return_rope.has_value()},
                                     {.role = "traction",
                                      .rope = pull,
                                      .peak = peaks.traction_rope,
                                      .where = place_of(peaks.traction_rope, display),
                                      .named = ropes.traction_rope.has_value()}};
  return make_table("ropes", "Ropes with their own weight, and their largest tensions", rope_quantities(), rows);
}

std::vector<TableWords> table_words() {
  return {{.name = "positions",
           .rows = "every carriage position, where there are several",
           .columns = words_of(position_quantities(true))},
          {.name = "ropes", .rows = "both ropes", .columns = words_of(rope_quantities())}};
}

}  // namespace taut::closed_loop
