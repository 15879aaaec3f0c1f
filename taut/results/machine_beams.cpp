#include "taut/results/machine_beams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/calc/shown.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/catalogue/steel.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/checks/mast/machine_masts.hpp"
#include "taut/solve/quantities.hpp"

namespace taut::results {
namespace {

using solve::BeamPoint;
using solve::BeamResult;
using solve::EquilibriumResult;

Table beams(const machine::Model& m, const EquilibriumResult& e) {
  std::vector<solve::BeamPointRow> rows;
  for (const BeamResult& b : e.beams) {
    for (const BeamPoint& p : b.points) {
      if (p.listed) rows.push_back({m, b, p});
    }
  }
  return make_table("beams",
                    "Beams: forces, stress and deflection along their axes (N: tension positive; w: across the chord)",
                    as_details(solve::beam_point_quantities()), rows);
}

Table ends(const machine::Model& m, const EquilibriumResult& e) {
  std::vector<solve::BeamRow> rows;
  for (const BeamResult& b : e.beams) rows.push_back({m, e, b});
  return make_table("beam_ends",
                    "Beams: largest values, force and moment of what the base stands on, critical axial force",
                    solve::beam_quantities(), rows);
}

/// Yield and buckling can only fail: a beam that passes them has no limit yet.
void add_fact(const std::string& beam, const std::string& where, Check check, Result& r) {
  check.part = beam;
  check.kind = PartKind::beam;
  check.limits = false;
  check.where = where;
  r.checks.push_back(std::move(check));
}

/// A stress without its torsion says nothing of a limit that it keeps.
void tell_left_out(const machine::description::Beam& given, const checks::WorstOf& torsion, const Display& display,
                   Result& r) {
  if (std::isnan(torsion.value)) return;
  const std::string words =
      fmt::format("{}: the stress does not contain its torsion of {} ({}): give the section's 'W_t', or 'round: true'",
                  given.name, display.brief(torsion.value, si::N_m), torsion.when);
  if (given.steel) r.unmade.push_back(words);
  r.warnings.push_back(words);
}

/// A stress that is known only between that of a round section and that in the corner of a box: `yield` of its steel,
/// Pa; NaN: it has no limit here.
void tell_corner(const machine::description::Beam& given, const checks::BeamWorst& worst, double yield,
                 const Display& display, Result& r) {
  const checks::WorstOf& corner = worst.stress_in_corner;
  constexpr double told = 1 + 1e-6;  // of two numbers that are printed
  if (!(corner.value > worst.stress.value * told) || corner.value <= yield || worst.stress.value > yield) return;
  const auto [round, box] = brief_apart(worst.stress.value, corner.value, si::Pa, display);
  const std::string words = fmt::format(
      "{}: the stress of {} is that of a round section; in the corner of a box it is up to {} ({}): give 'round: "
      "true', or where its walls are by 'strong'",
      given.name, round, box, corner.when);
  if (given.steel) r.unmade.push_back(words);
  r.warnings.push_back(words);
}

void check_stress(const machine::description::Beam& given, const checks::BeamWorst& worst, const Display& display,
                  Result& r) {
  const checks::WorstOf& stress = worst.stress;
  if (std::isnan(stress.value)) return;
  if (!given.steel) return tell_corner(given, worst, std::nan(""), display, r);
  const auto steel = catalogue::find_steel(*given.steel);
  if (!steel) return;
  double yield = catalogue::yield(*steel);
  std::string where = "thinnest range";
  if (given.section) {
    const auto row = catalogue::find_section(*given.section);
    const auto own = row ? catalogue::yield(*steel, row->thickness) : catalogue::Found<double>(yield);
    if (row && own) {
      yield = *own;
      where = "t = " + display.brief(row->thickness, si::m.in("mm"));
    }
  }
  tell_corner(given, worst, yield, display, r);
  const std::string trust = catalogue::trust_words(*steel);
  add_fact(given.name, stress.when,
           make_check(given.name + ".stress_max", stress.value, si::Pa,
                      {.sense = Sense::at_most,
                       .limit = yield,
                       .rule = fmt::format("|N|/A + M/W with torsion and shear by von Mises <= f_y of {} ({}), EN "
                                           "1993-1-1, 6.2.1 (5), gamma_M0 = 1",
                                           full_name(*steel), where),
                       .trust = trust}),
           r);
}

void check_buckling(const machine::description::Beam& given, const checks::WorstOf& factor, Result& r) {
  if (std::isnan(factor.value)) return;
  if (given.order == machine::description::Order::first) {
    add_fact(
        given.name, factor.when,
        make_check(
            given.name + ".alpha_cr", factor.value, si::one,
            {.sense = Sense::at_least,
             .limit = checks::first_order_factor,
             .rule =
                 "critical over present axial force, alone or with all beams' growing alike, for an analysis of first "
                 "order: EN 1993-1-1, 5.2.1 (3)",
             .trust = "verified"}),
        r);
    return;
  }
  add_fact(given.name, factor.when,
           make_check(
               given.name + ".alpha_cr", factor.value, si::one,
               {.sense = Sense::at_least,
                .limit = 1,
                .rule = "critical over present axial force, alone or with all beams' growing alike, in the state found "
                        "(bending of second order is in the stress already)",
                .trust = "derived"}),
           r);
}

/// Of the whole machine: once for all of its beams. A mast whose check asks for more is unsafe, and says so itself.
void tell_swing(const checks::WorstOf& swings, Result& r) {
  if (std::isnan(swings.value)) return;
  const std::string words = fmt::format(
      "from {:.4g} times the forces on its beams the machine swings away if the tensions of its ropes stay as they are "
      "({}); alpha_cr is that of buckling, with these tensions growing alike",
      swings.value, swings.when);
  if (std::find(r.warnings.begin(), r.warnings.end(), words) == r.warnings.end()) r.warnings.push_back(words);
}

void add_worst(const machine::description::Beam& given, const checks::BeamWorst& worst, const Display& display,
               Result& r) {
  const auto add = [&](const char* key, const checks::WorstOf& w) {
    if (std::isnan(w.value)) return;
    const QuantityWords& about = named(solve::beam_quantities(), key).about;
    const std::string name = fmt::format("{}.{}", given.name, key);
    r.values.push_back(
        {name, w.value, about.unit, name, fmt::format("{} of {} ({})", about.words, given.name, w.when), {}});
  };
  add("M_max", worst.M);
  add("N_max", worst.N);
  add("stress_max", worst.stress);
  add("top_displacement", worst.top_displacement);
  add("N_cr", worst.N_cr);
  add("alpha_cr", worst.alpha_cr);
  const AboutPart about(r, {.kind = PartKind::beam, .name = given.name});
  check_stress(given, worst, display, r);
  tell_left_out(given, worst.torsion_left_out, display, r);
  check_buckling(given, worst.alpha_cr, r);
  tell_swing(worst.swings, r);
}

void add_base(const machine::description::Beam& given, const MachineRun& run, std::size_t i, Result& r) {
  const auto first = std::find_if(run.equilibria.begin(), run.equilibria.end(),
                                  [](const study::EquilibriumRun& one) { return one.result.outcome.ok(); });
  if (first == run.equilibria.end()) return;
  const solve::BeamRow row{first->model, first->result, first->result.beams[i]};
  for (const char* key : {"N_base", "Rx", "Mx", "Ry", "My", "Rz", "Mz"}) {
    r.values.push_back(make_value(named(as_details(solve::beam_quantities()), key), row, given.name, "", first->words));
  }
}

/// A bow or lean that the load takes back helps; the other sense is the one to look at.
void warn_of_sense(const machine::description::Beam& given, const MachineRun& run, std::size_t i, Result& r) {
  if (!given.imperfection) return;
  for (const study::EquilibriumRun& one : run.equilibria) {
    if (!one.result.outcome.ok()) continue;
    const solve::BeamResult& b = one.result.beams[i];
    const Vector3 sense = checks::imperfection_sense(given, run.model.beams[i]);
    const Vector3 bent =
        b.points[b.points.size() / 2].deflection - (b.points.front().deflection + b.points.back().deflection) / 2;
    const double leans = given.imperfection->sway.value_or(0) * b.points.back().deflection.dot(sense);
    const double bows = given.imperfection->bow.value_or(0) * bent.dot(sense);
    if (leans >= 0 && bows >= 0) continue;
    r.warnings.push_back(
        fmt::format("{}: the {} of '{}' is against its deflection and helps it: turn its sign or 'towards' round",
                    one.words, leans < 0 ? "sway" : "bow", given.name));
    return;
  }
}

}  // namespace

bool is_listed(const machine::Body& body) { return !body.beam || body.name.ends_with(".top"); }

void add_beam_tables(const MachineRun& run, Result& r) {
  for (const study::EquilibriumRun& one : run.equilibria) {
    if (!one.result.outcome.ok() || one.result.beams.empty()) continue;
    for (Table t : {beams(one.model, one.result), ends(one.model, one.result)}) {
      t.name += one.ending;
      if (run.equilibria.size() > 1) t.title += fmt::format(" ({})", one.words);
      t.heading = heading_of(run, one);
      r.tables.push_back(std::move(t));
    }
  }
}

void add_beam_values(const machine::Machine& machine, const MachineRun& run, Result& r) {
  for (std::size_t i = 0; i < run.model.beams.size(); ++i) {
    const auto given = std::find_if(machine.beams.begin(), machine.beams.end(),
                                    [&](const auto& one) { return one.name == run.model.beams[i].name; });
    if (given == machine.beams.end()) continue;
    add_worst(*given, run.checked->judge.beams()[i], run.display, r);
    add_base(*given, run, i, r);
    warn_of_sense(*given, run, i, r);
    if (!given->section) continue;
    const auto row = catalogue::find_section(*given->section);
    if (!row || row->trust != catalogue::Trust::unverified) continue;
    r.warnings.push_back(fmt::format("{} is an unverified row of the catalogue ({}): compare it with the maker's table",
                                     row->name, row->trust_text));
  }
}

std::vector<std::string> beam_assumptions(const machine::Machine& machine) {
  std::vector<std::string> all;
  for (const auto& beam : machine.beams) {
    const bool first = beam.order == machine::description::Order::first;
    std::string text = fmt::format("Beam {}: elastic, plane sections, no shear deformation, {}; ", beam.name,
                                   first ? "balance on the straight axis (first order)"
                                         : "balance on the bent axis (second order, exact rotations)");
    if (beam.imperfection) {
      const double bow = beam.imperfection->bow.value_or(0), sway = beam.imperfection->sway.value_or(0);
      text += fmt::format("as built bowed by {:.4g} of its length and leaning by {:.4g}, free of stress", bow, sway);
    } else {
      text += "as built straight: without 'imperfection' a pressed beam looks stronger than it is";
    }
    if (!beam.section && !beam.mass) text += "; its mass is A times 7850 kg/m3";
    all.push_back(text + ". No local buckling, no plasticity.");
  }
  return all;
}

}  // namespace taut::results
