#include "taut/app/exact/mast_section_exact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "taut/app/exact/mast_section_figures.hpp"
#include "taut/base/gravity.hpp"
#include "taut/calc/shown.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/methods/mast_section/run.hpp"

namespace taut::app {
namespace {

using namespace mast_section;

double mast_height(const Input& in) { return std::max(in.skyline_block_height, in.mainline_block_height.value_or(0)); }

bool asks_for_exact(const Input& in) {
  return !in.guys.empty() || in.lateral_force.has_value() || in.base == Base::hinged;
}

solve::Guy engine_guy(const Input& in, std::size_t i) {
  const Guy& g = in.guys[i];
  solve::Guy out;
  out.name = std::to_string(i + 1);
  out.height = g.attachment_height.value_or(mast_height(in));
  out.anchor = {g.anchor_distance * std::cos(g.plan_angle), g.anchor_distance * std::sin(g.plan_angle),
                g.anchor_height};
  out.breaking_force = g.breaking_force;
  if (g.rope) {
    const auto rope = catalogue::find_rope_in_words(*g.rope);
    out.stiffness = g.modulus * rope->area;
    out.weight = rope->mass_per_length * standard_gravity;
    if (!out.breaking_force) out.breaking_force = rope->breaking_force;
  }
  out.stiffness = g.stiffness.value_or(out.stiffness);
  out.weight = g.weight.value_or(out.weight);
  if (g.length) {
    out.install = solve::GuyLength{*g.length};
  } else {
    out.install = solve::GuyTension{.tension = g.install->tension,
                                    .at = g.install->at == GuyEnd::top ? solve::GuyEnd::top : solve::GuyEnd::anchor};
  }
  return out;
}

/// The mast of a deck under one pair of block forces, solved.
struct LoadedMast {
  solve::GuyedMast mast;
  solve::GuyedMastResult found;
  Outcome outcome;
};

/// The masts of one deck, each solved once: the lightest section of all, the lightest of its shape and the exact column
/// ask for the same ones. The deck outlives it.
class EngineMasts {
 public:
  explicit EngineMasts(const Input& in) : in_(in) {}

  /// `name`: what tells the section from the others.
  const LoadedMast& under(const ClampForces& forces, const std::string& name, const structure::BeamSection& section) {
    const Key key{name, forces.skyline.across, forces.skyline.down, forces.mainline.across, forces.mainline.down};
    const auto [entry, is_new] = solved_.try_emplace(key);
    LoadedMast& one = entry->second;
    if (!is_new) return one;
    one.mast = guyed_mast(in_, forces, section);
    one.outcome = solve::solve(one.mast, one.found);
    return one;
  }

  /// The largest stress, Pa; NaN where there is no equilibrium.
  double stress(const catalogue::SectionRow& section, const ClampForces& forces) {
    const LoadedMast& one = under(forces, name_of(section), structure::beam_section(section));
    return one.outcome.ok() ? one.found.points[one.found.worst].stress : not_computed;
  }

  static std::string name_of(const catalogue::SectionRow& section) {
    return fmt::format("{} {}", section.standard, section.name);
  }

 private:
  using Key = std::tuple<std::string, double, double, double, double>;
  const Input& in_;
  std::map<Key, LoadedMast> solved_;
};

/// What the mast is made of: the section given or chosen, or the method's ideal tube.
struct Section {
  std::string name;
  std::string full_name;  ///< with its standard
  structure::BeamSection beam;
  double allowable = 0;
  std::string trust;
};

const Output& governing_output(const Solved& method) { return method.positions[method.governing.of[0]].out; }

Section section_of(const Input& in, const Solved& method) {
  const std::string trust = trust_of(limit_of(in));
  if (const auto& a = method.section) {
    return {.name = a->section.name,
            .full_name = EngineMasts::name_of(a->section),
            .beam = structure::beam_section(a->section),
            .allowable = a->allowable,
            .trust = trust};
  }
  const Output& o = governing_output(method);
  const double wall = std::min(o.t_tube, o.D_tube / 2);
  const std::string name = fmt::format("ideal tube {:.1f} x {:.1f} mm", o.D_tube * 1e3, wall * 1e3);
  return {.name = name,
          .full_name = name,
          .beam = structure::tube_section(o.D_tube, wall),
          .allowable = o.sigma_allow,
          .trust = trust};
}

Vector3 block_force(const BlockForce& f) { return {f.across, 0, -f.down}; }

/// The forces of one position with the ropes hauled in.
const ClampForces& hauled_in_at(const Solved& method, std::size_t index) {
  return *std::find_if(method.forces.begin(), method.forces.end(),
                       [&](const ClampForces& f) { return f.index == index && !f.paid_out; });
}

double largest_tension(const solve::GuyState& g) { return std::max(g.tension_top, g.tension_anchor); }

void take_position(const solve::GuyedMastResult& m, MastSectionExact& out) {
  out.M_exact = std::hypot(m.base_moment.x(), m.base_moment.y());
  out.M_max_exact = solve::bending(m.points[m.most_bent]);
  out.M_max_height_exact = m.points[m.most_bent].height;
  out.N_exact = m.base_force.z();
  out.Q_exact = std::hypot(m.base_force.x(), m.base_force.y());
  out.top_displacement_exact = std::hypot(m.top.x(), m.top.y());
  out.top_x_exact = m.top.x();
  out.top_y_exact = m.top.y();
  out.top_drop_exact = -m.top.z();
  out.sigma_exact = m.points[m.worst].stress;
  out.sigma_height_exact = m.points[m.worst].height;
  if (m.guys.empty()) return;
  out.slack_guys_exact =
      static_cast<double>(std::count_if(m.guys.begin(), m.guys.end(), [](const auto& g) { return g.slack; }));
}

void take_worst(const solve::GuyedMastResult& m, MastSectionExact& out) {
  out.sigma_worst_exact = std::fmax(out.sigma_worst_exact, m.points[m.worst].stress);
  out.force_balance_exact = std::fmax(out.force_balance_exact, m.force_balance);
  out.moment_balance_exact = std::fmax(out.moment_balance_exact, m.moment_balance);
  for (const solve::GuyState& g : m.guys) {
    out.guy_closure_exact = std::fmax(out.guy_closure_exact, g.closure);
    out.guy_tension_max_exact = std::fmax(out.guy_tension_max_exact, largest_tension(g));
    out.guy_safety_min_exact = std::fmin(out.guy_safety_min_exact, g.safety);  // fmin passes over NaN
  }
}

/// A guy at the governing carriage position.
struct GuyRow {
  const std::string& name;
  const solve::GuyState& state;
};

const Quantities<GuyRow>& guy_quantities() {
  using Row = GuyRow;
  static const Quantities<Row> all = {
      {"guy", "", si::one, "number of the guy in the deck, from 1", [](const Row& g) { return g.name; }},
      {"unstretched", "L_0", si::m, "its unstretched length", [](const Row& g) { return g.state.length; }},
      {"T_installed", "T_0", si::N, "tension at its upper end while the mast is vertical and unloaded",
       [](const Row& g) { return g.state.tension_installed; }},
      {"T_top", "", si::N, "tension at its upper end", [](const Row& g) { return g.state.tension_top; }},
      {"T_anchor", "", si::N, "tension at its anchor", [](const Row& g) { return g.state.tension_anchor; }},
      {"Fx", "F_x", si::N, "force on the anchor, towards the span",
       [](const Row& g) { return g.state.force_on_anchor.x(); }},
      {"Fy", "F_y", si::N, "force on the anchor normal to the span, to its left",
       [](const Row& g) { return g.state.force_on_anchor.y(); }},
      {"Fz", "F_z", si::N, "force on the anchor, upwards", [](const Row& g) { return g.state.force_on_anchor.z(); }},
      {"safety_factor", "", si::one, "minimum breaking force over its largest tension",
       [](const Row& g) { return g.state.safety; }},
      {"state", "", si::one, "taut; or slack: it is not shorter than its chord",
       [](const Row& g) { return std::string(g.state.slack ? "slack" : "taut"); }}};
  return all;
}

Table guys_table(const solve::GuyedMast& mast, const solve::GuyedMastResult& m) {
  std::vector<GuyRow> rows;
  rows.reserve(m.guys.size());
  for (std::size_t i = 0; i < m.guys.size(); ++i) rows.push_back({.name = mast.guys[i].name, .state = m.guys[i]});
  return make_table("guys", "Guylines at the governing carriage position, force on the anchor", guy_quantities(), rows);
}

/// The engine's values at one carriage position; NaN where there is no equilibrium, with the reason.
struct ExactPosition {
  double x = not_computed;  ///< m
  MastSectionExact exact;
  std::string reason;
};

ExactPosition exact_position(double x, const solve::GuyedMastResult& m, const Outcome& outcome) {
  ExactPosition p{.x = x, .exact = {}, .reason = outcome.message};
  if (outcome.ok()) take_position(m, p.exact), take_worst(m, p.exact);
  return p;
}

const Quantities<ExactPosition>& exact_quantities() {
  using Row = ExactPosition;
  const auto of = [](double MastSectionExact::*part) { return [part](const Row& p) { return p.exact.*part; }; };
  static const Quantities<Row> all = {
      {"x", "x", si::m, "position of the carriage", &Row::x},
      {"N_exact", "N", si::N, "axial force at the foot with guys and second order", of(&MastSectionExact::N_exact)},
      {"Q_exact", "Q", si::N, "horizontal force at the foot", of(&MastSectionExact::Q_exact)},
      {"M_exact", "M", si::N_m, "bending moment at the foot", of(&MastSectionExact::M_exact)},
      {"M_max_exact", "M_max", si::N_m, "largest bending moment along the mast", of(&MastSectionExact::M_max_exact)},
      {"top_displacement_exact", "", si::m.in("mm"), "horizontal displacement of the top",
       of(&MastSectionExact::top_displacement_exact)},
      {"sigma_exact", "sigma", si::Pa, "largest stress along the mast", of(&MastSectionExact::sigma_exact)},
      {"guy_tension_max_exact", "", si::N, "largest tension of any guy", of(&MastSectionExact::guy_tension_max_exact)},
      {"reason", "", si::one, "why there is no equilibrium; empty: there is one", &Row::reason}};
  return all;
}

void add_comparisons(const Input& in, const Output& o, const Section& section, const MastSectionExact& e, Result& r) {
  const auto add = [&](const char* what, const char* symbol, const Unit& unit, double method, double exact) {
    const bool guyed = !in.guys.empty();
    r.comparisons.push_back({what, symbol, unit, method, method, exact,
                             guyed ? "exact: with guys and second order" : "exact: with second order",
                             shown_below(method, exact)});
  };
  add("axial force at the foot", "N", si::N, o.N, e.N_exact);
  add("shear at the foot", "Q", si::N, o.Q, e.Q_exact);
  add("moment at the foot", "M", si::N_m, o.M, e.M_exact);
  const double stress = structure::largest_stress(section.beam, o.N, o.M, 0);
  add(("largest stress in the " + section.name).c_str(), "sigma", si::Pa, stress, e.sigma_exact);
}

void add_checks(const Input& in, const Section& section, const MastSectionExact& e, Result& r) {
  if (!asks_for_exact(in)) return;  // the method has checked it by second order
  Check strength =
      make_check(fmt::format("strength of {}, exact", section.name), e.sigma_worst_exact, si::Pa,
                 {.sense = Sense::at_most,
                  .limit = section.allowable,
                  .rule = "N/A + M/W <= [sigma] at every height, second order, at every carriage position, both "
                          "directions of the ropes",
                  .trust = section.trust});
  strength.part = "mast";
  r.checks.push_back(std::move(strength));
  const auto rule = catalogue::find_rule("safety.guyline.ch_at");
  if (std::isnan(e.guy_safety_min_exact) || !rule || !rule->low) return;
  const bool unverified = rule->trust == catalogue::Trust::unverified;
  r.checks.push_back(
      make_check("guylines do not break", e.guy_safety_min_exact, si::one,
                 {.sense = Sense::at_least,
                  .limit = *rule->low,
                  .rule = fmt::format("{}: {}, {}", rule->field, rule->item, rule->source),
                  .trust = unverified ? "UNVERIFIED: " + rule->trust_text : std::string(to_text(rule->trust))}));
}

void add_words(const Input& in, const Section& section, const MastSectionExact& e, Result& r) {
  r.assumptions.push_back(fmt::format(
      "Exact column: {}, E 210 GPa, {} at its foot; geometrically exact beam, guys as elastic catenaries set while the "
      "mast stands plumb and unloaded; block forces keep their direction.",
      section.name, in.base == Base::clamped ? "clamped" : "hinged"));
  if (!in.guys.empty() && e.slack_guys_exact > 0) {
    r.warnings.push_back(
        fmt::format("{:.0f} of {} guys are slack at the governing carriage position: see the table of guys",
                    e.slack_guys_exact, in.guys.size()));
  }
  Step heading, note;
  heading.kind = Step::Kind::heading;
  heading.words = "Exact solution of the mast";
  note.kind = Step::Kind::note;
  note.words =
      "r' = (1 + F d3/EA) d3, M' = -r' x F, F constant between the blocks and guys; solved so that force and moment "
      "vanish above the top (docs/theory/guyed-mast.md)";
  r.steps.push_back(heading);
  r.steps.push_back(note);
}

/// No equilibrium at one position.
void refuse(const Input& in, const Position& p, const Outcome& outcome, Result& r) {
  const std::string at = in.span ? fmt::format("carriage at {:.4g} m: ", p.out.x) : std::string();
  if (!asks_for_exact(in)) {
    r.warnings.push_back("second order: " + at + outcome.message);
  } else if (r.status == Status::ok) {
    r.status = outcome.status;
    r.message = at + outcome.message;
  }
}

}  // namespace

solve::GuyedMast guyed_mast(const Input& in, const ClampForces& forces, const structure::BeamSection& section) {
  solve::GuyedMast m;
  m.height = mast_height(in);
  m.section = section;
  m.base = in.base == Base::clamped ? solve::MastBase::clamped : solve::MastBase::hinged;
  for (std::size_t i = 0; i < in.guys.size(); ++i) m.guys.push_back(engine_guy(in, i));
  const double lower = in.mainline_block_height.value_or(in.skyline_block_height);
  m.loads = {{.height = in.skyline_block_height, .force = block_force(forces.skyline)},
             {.height = lower, .force = block_force(forces.mainline)}};
  if (in.lateral_force) m.loads.push_back({in.skyline_block_height, {0, *in.lateral_force, 0}});
  return m;
}

namespace {

SecondOrder second_order_of(const std::shared_ptr<EngineMasts>& masts) {
  return [masts](const catalogue::SectionRow& section, const ClampForces& forces) {
    return masts->stress(section, forces);
  };
}

/// The other load cases, with the ropes paid out or wrapped as they really are: their stresses and guys count as well.
void take_other_cases(const Input& in, const Solved& method, const Section& section, EngineMasts& masts,
                      MastSectionExact& e, Result& r) {
  for (const ClampForces& forces : method.forces) {
    const LoadedMast& at = masts.under(forces, section.full_name, section.beam);
    if (at.outcome.ok()) {
      take_worst(at.found, e);
    } else if (asks_for_exact(in) && r.status == Status::ok) {
      r.status = at.outcome.status;
      r.message = (forces.paid_out ? "ropes paid out: " : "ropes hauled in: ") + at.outcome.message;
    }
  }
}

/// Adds the exact column to the method's result.
void complete_mast_section(const Input& in, const Solved& method, EngineMasts& masts, Result& r) {
  if (asks_for_exact(in)) {
    // The method's checks are those of another mast: a clamped one without guys.
    std::erase_if(r.checks, [](const Check& c) { return c.name.starts_with("strength of"); });
  }
  const Section section = section_of(in, method);
  MastSectionExact e;
  std::vector<ExactPosition> positions;
  for (const Position& p : method.positions) {
    if (!p.outcome.ok()) continue;
    const LoadedMast& at = masts.under(hauled_in_at(method, p.index), section.full_name, section.beam);
    positions.push_back(exact_position(p.out.x, at.found, at.outcome));
    if (!at.outcome.ok()) {
      refuse(in, p, at.outcome, r);
      continue;
    }
    take_worst(at.found, e);
    if (p.index != method.governing.of[0]) continue;
    take_position(at.found, e);
    if (!in.guys.empty()) r.tables.push_back(guys_table(at.mast, at.found));
    add_mast_figures(at.mast, at.found, section.allowable, r);
  }
  take_other_cases(in, method, section, masts, e, r);
  if (positions.size() > 1) {
    r.tables.push_back(make_table("positions_exact", "Carriage positions, exact", exact_quantities(), positions));
  }
  add_words(in, section, e, r);
  if (!std::isnan(e.N_exact)) add_comparisons(in, governing_output(method), section, e, r);
  if (r.status == Status::ok && !std::isnan(e.sigma_worst_exact)) add_checks(in, section, e, r);
  const auto values = values_of(MastSectionExact::describe(), &e);
  r.values.insert(r.values.end(), values.begin(), values.end());
}

}  // namespace

std::vector<TableWords> mast_section_exact_words() {
  return {
      {.name = "guys", .rows = "every guy, at the governing carriage position", .columns = words_of(guy_quantities())},
      {.name = "positions_exact",
       .rows = "every carriage position, solved by the engine",
       .columns = words_of(exact_quantities())}};
}

SecondOrder second_order_of(const Input& in) { return second_order_of(std::make_shared<EngineMasts>(in)); }

Result run_mast_section(const Input& in) {
  const auto masts = std::make_shared<EngineMasts>(in);
  Solved method;
  Result r = run(in, second_order_of(masts), method);
  if (r.status == Status::ok) complete_mast_section(in, method, *masts, r);
  return r;
}

}  // namespace taut::app
