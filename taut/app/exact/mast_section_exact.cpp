#include "taut/app/exact/mast_section_exact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <tuple>

#include "taut/app/exact/mast_machine.hpp"
#include "taut/app/exact/mast_section_figures.hpp"
#include "taut/app/exact/mast_wall.hpp"
#include "taut/app/exact/rope_doubts.hpp"
#include "taut/base/gravity.hpp"
#include "taut/calc/shown.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/methods/mast_section/run.hpp"

namespace taut::app {
namespace {

using namespace mast_section;

/// The mast of a deck under one pair of block forces, solved.
struct LoadedMast {
  machine::Model model;
  solve::EquilibriumResult found;

  const solve::BeamResult& mast() const { return found.beams[0]; }
};

/// The masts of one deck, each solved once: the lightest section of all, the lightest of its shape and the exact column
/// ask for the same ones. The deck outlives it.
class EngineMasts {
 public:
  explicit EngineMasts(const Input& in) : in_(in), guys_(put_up_guys(in)) {}

  /// `name`: what tells the section from the others.
  const LoadedMast& under(const ClampForces& forces, const std::string& name, const structure::BeamSection& section) {
    const Key key{
        name, forces.skyline.across, forces.skyline.down, forces.mainline.across, forces.mainline.down, forces.lateral};
    const auto [entry, is_new] = solved_.try_emplace(key);
    LoadedMast& one = entry->second;
    if (!is_new) return one;
    if (!guys_.outcome.ok()) {
      one.found.outcome = guys_.outcome;
      return one;
    }
    one.model = mast_machine(in_, guys_.all, forces, section);
    one.found = solve::equilibrium(one.model);
    return one;
  }

  /// The largest stress as it is held against [sigma], Pa: with the safety n that of n times the forces, over n, where
  /// it is larger. NaN where there is no equilibrium.
  double stress(const ClampForces& forces, const std::string& name, const structure::BeamSection& section) {
    const auto largest = [&](double factor) {
      const LoadedMast& one = under(factor * forces, name, section);
      return one.found.outcome.ok() ? one.mast().points[one.mast().most_stressed].stress / factor : not_computed;
    };
    const double n = in_.safety.value_or(1), as_it_is = largest(1);
    if (std::isnan(as_it_is) || n == 1) return as_it_is;
    const double factored = largest(n);
    return std::isnan(factored) ? factored : std::max(as_it_is, factored);
  }

  double buckling(const ClampForces& forces, const std::string& name, const structure::BeamSection& section) {
    const LoadedMast& one = under(forces, name, section);
    return one.found.outcome.ok() ? one.mast().critical_factor : not_computed;
  }

  const std::vector<MastGuy>& guys() const { return guys_.all; }

  static std::string name_of(const catalogue::SectionRow& section) {
    return fmt::format("{} {}", section.standard, section.name);
  }

 private:
  using Key = std::tuple<std::string, double, double, double, double, double>;
  const Input& in_;
  MastGuys guys_;
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

/// The forces of one position with the ropes hauled in.
const ClampForces& hauled_in_at(const Solved& method, std::size_t index) {
  return *std::find_if(method.forces.begin(), method.forces.end(), [&](const ClampForces& f) {
    return f.index == index && are(f, RopeState::hauled_in) && !f.put_up;
  });
}

/// Breaking force over the largest tension; NaN where one of them is not known.
double safety(double breaking, double largest) {
  return breaking > 0 && largest > 0 ? breaking / largest : not_computed;
}
double safety(const LoadedMast& at, std::size_t guy) {
  return safety(at.model.reevings[guy].breaking_force, rope::largest_tension(at.found.branches[guy].shape));
}
double safety_as_put_up(const MastGuy& guy) { return safety(guy.breaking_force, guy.installed_most); }

double foot_moment(const solve::BeamResult& mast) { return std::hypot(mast.base_moment.x(), mast.base_moment.y()); }
double foot_shear(const solve::BeamResult& mast) { return std::hypot(mast.base_force.x(), mast.base_force.y()); }

void take_position(const LoadedMast& at, MastSectionExact& out) {
  const solve::BeamResult& mast = at.mast();
  const solve::BeamPoint &bent = mast.points[mast.most_bent], &stressed = mast.points[mast.most_stressed];
  const Vector3& top = mast.points.back().deflection;
  out.M_exact = foot_moment(mast);
  out.M_max_exact = bent.M;
  out.M_max_height_exact = bent.s;
  out.N_exact = mast.base_force.z();
  out.Q_exact = foot_shear(mast);
  out.top_displacement_exact = std::hypot(top.x(), top.y());
  out.top_x_exact = top.x();
  out.top_y_exact = top.y();
  out.top_drop_exact = -top.z();
  out.sigma_exact = stressed.stress;
  out.sigma_height_exact = stressed.s;
  const auto& guys = at.found.branches;
  if (guys.empty()) return;
  out.slack_guys_exact = static_cast<double>(std::count_if(guys.begin(), guys.end(), hangs));
}

void take_worst(const LoadedMast& at, MastSectionExact& out) {
  const solve::BeamResult& mast = at.mast();
  out.M_worst_exact = std::fmax(out.M_worst_exact, foot_moment(mast));
  out.N_worst_exact = std::fmax(out.N_worst_exact, mast.base_force.z());
  out.N_least_exact = std::fmin(out.N_least_exact, mast.base_force.z());
  out.Q_worst_exact = std::fmax(out.Q_worst_exact, foot_shear(mast));
  out.sigma_worst_exact = std::fmax(out.sigma_worst_exact, mast.points[mast.most_stressed].stress);
  if (std::isfinite(mast.critical_factor))
    out.buckling_factor_exact = std::fmin(out.buckling_factor_exact, mast.critical_factor);
  out.force_balance_exact = std::fmax(out.force_balance_exact, at.found.closure.balance);
  out.moment_balance_exact = std::fmax(out.moment_balance_exact, moment_balance(at.model, at.found));
  for (std::size_t i = 0; i < at.found.branches.size(); ++i) {
    const solve::BranchResult& guy = at.found.branches[i];
    out.guy_closure_exact = std::fmax(out.guy_closure_exact, guy.shape.closure);
    out.guy_tension_max_exact = std::fmax(out.guy_tension_max_exact, rope::largest_tension(guy.shape));
    out.guy_safety_min_exact = std::fmin(out.guy_safety_min_exact, safety(at, i));  // fmin passes over NaN
  }
}

/// The tension of the deck is that on the plumb mast. The mast leans towards its guys as it is let go, and so they may
/// never have as much again.
void take_put_up(const std::vector<MastGuy>& guys, MastSectionExact& out) {
  for (const MastGuy& guy : guys) {
    out.guy_tension_max_exact = std::fmax(out.guy_tension_max_exact, guy.installed_most);
    out.guy_safety_min_exact = std::fmin(out.guy_safety_min_exact, safety_as_put_up(guy));
  }
}

/// A guy at the governing carriage position.
struct GuyRow {
  const MastGuy& guy;
  const solve::BranchResult& rope;
  double safety = not_computed;
};

const Quantities<GuyRow>& guy_quantities() {
  using Row = GuyRow;
  static const Quantities<Row> all = {
      {"guy", "", si::one, "number of the guy in the deck, from 1", [](const Row& g) { return g.guy.name; }},
      {"unstretched", "L_0", si::m, "its unstretched length", [](const Row& g) { return g.guy.length; }},
      {"T_installed", "T_0", si::N, "tension at its upper end while the mast is vertical and unloaded",
       [](const Row& g) { return g.guy.installed; }},
      {"T_top", "", si::N, "tension at its upper end", [](const Row& g) { return g.rope.T_to; }},
      {"T_anchor", "", si::N, "tension at its anchor", [](const Row& g) { return g.rope.T_from; }},
      {"Fx", "F_x", si::N, "force on the anchor, towards the span",
       [](const Row& g) { return rope::force_on_start(g.rope.shape).x(); }},
      {"Fy", "F_y", si::N, "force on the anchor normal to the span, to its left",
       [](const Row& g) { return rope::force_on_start(g.rope.shape).y(); }},
      {"Fz", "F_z", si::N, "force on the anchor, upwards",
       [](const Row& g) { return rope::force_on_start(g.rope.shape).z(); }},
      {"safety_factor", "", si::one, "minimum breaking force over its largest tension", &Row::safety},
      {"state", "", si::one, "taut; or slack: it is not shorter than its chord",
       [](const Row& g) { return std::string(hangs(g.rope) ? "slack" : "taut"); }}};
  return all;
}

Table guys_table(const std::vector<MastGuy>& guys, const LoadedMast& at) {
  std::vector<GuyRow> rows;
  rows.reserve(guys.size());
  for (std::size_t i = 0; i < guys.size(); ++i) {
    rows.push_back({.guy = guys[i], .rope = at.found.branches[i], .safety = safety(at, i)});
  }
  return make_table("guys", "Guylines at the governing carriage position, force on the anchor", guy_quantities(), rows);
}

/// The engine's values at one carriage position; NaN where there is no equilibrium, with the reason.
struct ExactPosition {
  double x = not_computed;  ///< m
  MastSectionExact exact;
  std::string reason;
};

ExactPosition exact_position(double x, const LoadedMast& at, const Outcome& outcome) {
  ExactPosition p{.x = x, .exact = {}, .reason = outcome.message};
  if (outcome.ok()) take_position(at, p.exact), take_worst(at, p.exact);
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
  const double stress = structure::largest_stress(section.beam, {.axial = o.N, .bends_to_x = o.M});
  add(("largest stress in the " + section.name).c_str(), "sigma", si::Pa, stress, e.sigma_exact);
}

/// The engine's mast is straight: what a real one, which is not, bends by is far from it only well below its critical
/// load.
void check_buckling(const Input& in, const Section& section, const MastSectionExact& e, Result& r) {
  const double alpha = e.buckling_factor_exact;
  if (std::isnan(alpha)) return;
  if (in.safety) {
    Check buckling = make_check(fmt::format("buckling of {}, exact", section.name), alpha, si::one,
                                {.sense = Sense::at_least,
                                 .limit = *in.safety,
                                 .rule = fmt::format("factor of the axial force at which the straight mast buckles{}, "
                                                     "at least the safety of the deck",
                                                     in.guys.empty() ? "" : ", held by its guys"),
                                 .trust = "user"});
    buckling.part = "mast";
    buckling.limits = false;
    r.checks.push_back(std::move(buckling));
  }
  if (alpha >= least_without_imperfections) return;
  warn_unsafe(r,
              fmt::format("the mast buckles at {:.3g} times its axial force if it is straight, and a real one is not: "
                          "below {:g} its bow and sway decide (EN 1993-1-1, 5.2.2); check it as a beam with an "
                          "'imperfection', or by 'checks: masts'",
                          alpha, least_without_imperfections));
}

/// The guy nearest to breaking, and in which case.
struct WeakestGuy {
  std::string name, where;
  double safety = not_computed;
};

WeakestGuy weakest_guy(const Input& in, const Solved& method, const Section& section, EngineMasts& masts) {
  WeakestGuy weakest;
  const auto take = [&](const MastGuy& guy, double factor, const std::string& where) {
    if (std::isnan(factor) || factor >= weakest.safety) return;
    weakest = {.name = guy.name, .where = where, .safety = factor};
  };
  for (const MastGuy& guy : masts.guys()) take(guy, safety_as_put_up(guy), "as it is put up");
  for (const ClampForces& f : method.forces) {
    const LoadedMast& at = masts.under(f, section.full_name, section.beam);
    if (!at.found.outcome.ok()) continue;
    for (std::size_t i = 0; i < masts.guys().size(); ++i) take(masts.guys()[i], safety(at, i), case_words(in, f));
  }
  return weakest;
}

/// Guys that hang, and where the first of them does.
struct SlackGuys {
  std::vector<std::string> names;
  std::string where;
};

/// Those that hang in a load case, or with the guys alone (`put_up`). `may_slack`: of the guys of which the deck says
/// so, or does not; none: of all.
SlackGuys slack_guys(const Input& in, const Solved& method, const Section& section, EngineMasts& masts, bool put_up,
                     std::optional<bool> may_slack) {
  SlackGuys slack;
  for (std::size_t i = 0; i < masts.guys().size(); ++i) {
    if (may_slack && in.guys[i].may_slack != *may_slack) continue;
    for (const ClampForces& f : method.forces) {
      if (f.put_up != put_up) continue;
      const LoadedMast& at = masts.under(f, section.full_name, section.beam);
      if (!at.found.outcome.ok() || !hangs(at.found.branches[i])) continue;
      if (slack.names.empty()) slack.where = case_words(in, f);
      slack.names.push_back(masts.guys()[i].name);
      break;
    }
  }
  return slack;
}

/// The largest tension of a guy, as it is put up and in all load cases, N.
double largest_tension(const Solved& method, const Section& section, EngineMasts& masts, std::size_t guy) {
  double most = masts.guys()[guy].installed_most;
  for (const ClampForces& f : method.forces) {
    const LoadedMast& at = masts.under(f, section.full_name, section.beam);
    if (at.found.outcome.ok()) most = std::max(most, rope::largest_tension(at.found.branches[guy].shape));
  }
  return most;
}

void warn_of_values(const Input& in, const Solved& method, const Section& section, EngineMasts& masts,
                    const Display& display, Result& r) {
  for (std::size_t i = 0; i < masts.guys().size(); ++i) {
    const Guy& given = in.guys[i];
    warn_of_rope({.name = fmt::format("guy {}", masts.guys()[i].name),
                  .rope = given.rope,
                  .own = {.mass = given.weight.value_or(0) / standard_gravity,
                          .diameter = 0,
                          .breaking_force = given.breaking_force.value_or(0),
                          .stiffness = masts.guys()[i].stiffness},
                  .tension = largest_tension(method, section, masts, i)},
                 display, r);
  }
}

void warn_of_guys(const Input& in, const Solved& method, const Section& section, EngineMasts& masts,
                  const Display& display, Result& r) {
  if (r.status != Status::ok) return;
  warn_of_values(in, method, section, masts, display, r);
  const SlackGuys open = slack_guys(in, method, section, masts, false, false),
                  declared = slack_guys(in, method, section, masts, false, true),
                  alone = slack_guys(in, method, section, masts, true, std::nullopt);
  if (!open.names.empty()) {
    warn_unsafe(r, fmt::format("slack guys: {} (first: {}); a slack guy does not hold the mast: tighten it, or declare "
                               "it by 'may_slack: true'",
                               fmt::join(open.names, ", "), open.where));
  }
  if (!declared.names.empty()) {
    r.warnings.push_back(fmt::format("slack guys, as the deck declares: {}", fmt::join(declared.names, ", ")));
  }
  if (!alone.names.empty()) {
    r.warnings.push_back(fmt::format("without a load the mast leans towards its guys until they are slack: {}",
                                     fmt::join(alone.names, ", ")));
  }
}

void check_guys(const Input& in, const Solved& method, const Section& section, EngineMasts& masts, Result& r) {
  for (const MastGuy& guy : masts.guys()) {
    if (!(guy.breaking_force > 0)) {
      r.unjudged.push_back(fmt::format("guy {}: its breaking_force is not given", guy.name));
    }
  }
  const WeakestGuy weakest = weakest_guy(in, method, section, masts);
  const auto rule = catalogue::find_rule("safety.guyline.ch_at");
  if (std::isnan(weakest.safety) || !rule || !rule->low) return;
  Check c = make_check("guylines do not break", weakest.safety, si::one,
                       {.sense = Sense::at_least,
                        .limit = *rule->low,
                        .rule = fmt::format("{}: {}, {}", rule->field, rule->item, rule->source),
                        .trust = catalogue::trust_words(*rule)});
  c.where = fmt::format("guy {}, {}", weakest.name, weakest.where);
  r.checks.push_back(std::move(c));
}

/// The largest stress as it is held against [sigma], of all load cases; NaN where one has no equilibrium.
double stress_of_all(const Solved& method, const Section& section, EngineMasts& masts) {
  double largest = 0;
  for (const ClampForces& f : method.forces) {
    const double one = masts.stress(f, section.full_name, section.beam);
    if (std::isnan(one)) return one;
    largest = std::max(largest, one);
  }
  return largest;
}

void check_strength(const Input& in, const Solved& method, const Section& section, EngineMasts& masts, Result& r) {
  std::string rule =
      "N/A + M/W <= [sigma] at every height, second order, at every carriage position, each rope hauled in, paid out "
      "and "
      "at rest, with guys each rope alone too, and with the guys alone";
  if (in.safety) rule += "; the larger of the stress and of that under the safety times the forces, over the safety";
  const double stress = stress_of_all(method, section, masts);
  if (std::isnan(stress))
    rule = "the mast finds no equilibrium under the safety times the ropes' forces: it buckles, or guys go slack";
  Check strength = make_check(
      fmt::format("strength of {}, exact", section.name), stress, si::Pa,
      {.sense = Sense::at_most, .limit = section.allowable, .rule = std::move(rule), .trust = section.trust});
  strength.part = "mast";
  strength.covers = {strength.part};
  r.checks.push_back(std::move(strength));
}

/// The method has checked the stress of its own mast by second order: that bends it in its plane alone, and does not
/// see that it buckles about its other axis.
void add_checks(const Input& in, const Solved& method, const Section& section, EngineMasts& masts,
                const MastSectionExact& e, Result& r) {
  const bool beyond = is_beyond_method(in);
  if (beyond) check_strength(in, method, section, masts, r);
  if (beyond || method.section) check_buckling(in, section, e, r);
  if (beyond) check_guys(in, method, section, masts, r);
}

void add_words(const Input& in, const Section& section, Result& r) {
  r.assumptions.push_back(fmt::format(
      "Exact column: {}, E 210 GPa, {} at its foot; geometrically exact beam, guys as elastic catenaries set while the "
      "mast stands plumb and unloaded; block forces keep their direction.",
      section.name, in.base == Base::clamped ? "clamped" : "hinged"));
  Step heading, note;
  heading.kind = Step::Kind::heading;
  heading.words = "Exact solution of the mast";
  note.kind = Step::Kind::note;
  note.words =
      "r' = (1 + F d3/EA) d3, M' = -r' x F, F constant between the blocks and guys; the mast is a beam of a machine "
      "(docs/theory/guyed-mast.md)";
  r.steps.push_back(heading);
  r.steps.push_back(note);
}

/// No equilibrium at one position.
void refuse(const Input& in, const Position& p, const Outcome& outcome, const Display& display, Result& r) {
  const std::string at = in.span ? fmt::format("carriage at {}: ", display.brief(p.out.x, si::m)) : std::string();
  if (!is_beyond_method(in)) {
    r.warnings.push_back("second order: " + at + outcome.message);
  } else if (r.status == Status::ok) {
    r.status = outcome.status;
    r.message = at + outcome.message;
  }
}

/// Whether the mast may stand at `factor` times its axial force. Held straight and without turning at both ends of its
/// lowest part, which is more than blocks and guys do, that part buckles at 4 pi^2 EI/L^2 (Rayleigh: its own shape is
/// one of the mast's); the ropes press it with no less than they pull down, as guys from below only add to that.
bool may_stand(const Input& in, const catalogue::SectionRow& section, double factor, const ClampForces& forces) {
  double part = std::min(in.skyline_block_height, in.mainline_block_height.value_or(in.skyline_block_height));
  for (const Guy& g : in.guys) {
    const double height = g.attachment_height.value_or(
        std::max(in.skyline_block_height, in.mainline_block_height.value_or(in.skyline_block_height)));
    if (g.anchor_height > height) return true;
    part = std::min(part, height);
  }
  const structure::BeamSection beam = structure::beam_section(section);
  const double held = 4 * square(std::numbers::pi) * std::min(beam.EI_x, beam.EI_y) / square(part);
  return factor * (forces.skyline.down + forces.mainline.down) <= held;
}

SecondOrder second_order_of(const Input& in, const std::shared_ptr<EngineMasts>& masts) {
  using catalogue::SectionRow;
  SecondOrder second;
  second.decides_alone = is_beyond_method(in);
  second.stress = [masts](const SectionRow& section, const ClampForces& forces) {
    return masts->stress(forces, EngineMasts::name_of(section), structure::beam_section(section));
  };
  second.wall_yields = [&in](const SectionRow& section, double yield, const ClampForces& forces) {
    return wall_of(in, section, yield, forces).value <= 3;
  };
  second.least_buckling = std::max(in.safety.value_or(0), least_without_imperfections);
  second.may_stand = [&in, least = second.least_buckling](const SectionRow& section, const ClampForces& forces) {
    return may_stand(in, section, least, forces);
  };
  second.buckling = [masts](const SectionRow& section, const ClampForces& forces) {
    return masts->buckling(forces, EngineMasts::name_of(section), structure::beam_section(section));
  };
  return second;
}

/// The other load cases, with the ropes paid out or wrapped as they really are: their stresses and guys count as well.
void take_other_cases(const Input& in, const Solved& method, const Section& section, EngineMasts& masts,
                      MastSectionExact& e, Result& r) {
  bool all_stand = true;
  for (const ClampForces& forces : method.forces) {
    const LoadedMast& at = masts.under(forces, section.full_name, section.beam);
    if (at.found.outcome.ok()) {
      take_worst(at, e);
      continue;
    }
    all_stand = false;
    if (!is_beyond_method(in) || r.status != Status::ok) continue;
    const Outcome outcome = with_share_held(at.model, at.found.outcome);
    r.status = outcome.status;
    r.message = fmt::format("{}: {}", direction_words(forces), outcome.message);
  }
  if (!all_stand) e.buckling_factor_exact = not_computed;  // the least one is of a case that has none
}

/// Adds the exact column to the method's result.
void complete_mast_section(const Input& in, const Solved& method, EngineMasts& masts, const Display& display,
                           Result& r) {
  if (method.section) check_wall(in, method, r);
  const Section section = section_of(in, method);
  MastSectionExact e;
  std::vector<ExactPosition> positions;
  for (const Position& p : method.positions) {
    if (!p.outcome.ok()) continue;
    const LoadedMast& at = masts.under(hauled_in_at(method, p.index), section.full_name, section.beam);
    const Outcome outcome = with_share_held(at.model, at.found.outcome);
    positions.push_back(exact_position(p.out.x, at, outcome));
    if (!outcome.ok()) {
      refuse(in, p, outcome, display, r);
      continue;
    }
    take_worst(at, e);
    if (p.index != method.governing.of[0]) continue;
    take_position(at, e);
    if (!in.guys.empty()) r.tables.push_back(guys_table(masts.guys(), at));
    add_mast_figures(at.model, at.found, section.allowable, r);
  }
  take_other_cases(in, method, section, masts, e, r);
  take_put_up(masts.guys(), e);
  if (r.status == Status::ok && e.N_least_exact < 0) {
    warn_unsafe(r, fmt::format("the foot of the mast is pulled up with up to {}: it must be anchored to hold it",
                               display.brief(-e.N_least_exact, si::N)));
  }
  if (positions.size() > 1) {
    r.tables.push_back(make_table("positions_exact", "Carriage positions, exact", exact_quantities(), positions));
  }
  warn_of_guys(in, method, section, masts, display, r);
  add_words(in, section, r);
  if (!std::isnan(e.N_exact)) add_comparisons(in, governing_output(method), section, e, r);
  if (r.status == Status::ok && !std::isnan(e.sigma_worst_exact)) add_checks(in, method, section, masts, e, r);
  const auto values = values_of(MastSectionExact::describe(), &e);
  r.values.insert(r.values.end(), values.begin(), values.end());
  if (r.status == Status::ok && method.section && !in.section) check_chosen_mast(r);
}

}  // namespace

void check_chosen_mast(Result& r) {
  const Value* alpha = r.find_value("buckling_factor_exact");
  if (alpha == nullptr || !(alpha->value < least_without_imperfections)) return;
  Check c = make_check("buckling of the mast as chosen", alpha->value, si::one,
                       {.sense = Sense::at_least,
                        .limit = least_without_imperfections,
                        .rule = "factor of the axial force at which the straight mast buckles; below it the bow and "
                                "sway of a real one decide: EN 1993-1-1, 5.2.2",
                        .trust = "UNVERIFIED: EN 1993-1-1, 5.2.2, recalled"});
  c.part = "mast";
  c.limits = false;
  r.checks.push_back(std::move(c));
}

std::vector<TableWords> mast_section_exact_words() {
  return {
      {.name = "guys", .rows = "every guy, at the governing carriage position", .columns = words_of(guy_quantities())},
      {.name = "positions_exact",
       .rows = "every carriage position, solved by the engine",
       .columns = words_of(exact_quantities())}};
}

SecondOrder second_order_of(const Input& in) { return second_order_of(in, std::make_shared<EngineMasts>(in)); }

Result run_mast_section(const Input& in, const Display& display) {
  const auto masts = std::make_shared<EngineMasts>(in);
  Solved method;
  Result r = run(in, second_order_of(in, masts), method, display);
  if (r.status == Status::ok) complete_mast_section(in, method, *masts, display, r);
  return r;
}

}  // namespace taut::app
