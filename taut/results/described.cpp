#include "taut/results/described.hpp"

#include <fmt/format.h>

#include "taut/results/analyses/analyses.hpp"
#include "taut/results/load_path_table.hpp"
#include "taut/results/machine_tables.hpp"
#include "taut/results/motion/transient_tables.hpp"
#include "taut/solve/quantities.hpp"
#include "taut/study/analyses.hpp"
#include "taut/study/put_up.hpp"

namespace taut::results {
namespace {

using Words = std::vector<QuantityWords>;

Words both(Words first, const Words& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// `payload`, `governing` and what limits the bend at supports stand behind the carriage's place.
Words payload_words() {
  constexpr std::ptrdiff_t behind_place = 3;
  Words all = load_path_words();
  const Words own = both(words_of(study::payload_quantities()), prefixed("ROPE.SUPPORT.", {held_angle_words()}));
  all.insert(all.begin() + behind_place, own.begin(), own.end());
  return all;
}

std::vector<TableWords> of_states() {
  return {
      {.name = "places",
       .rows = "every place given over the ground (`at: {chainage: ...}`)",
       .columns = words_of(over_ground_quantities())},
      {.name = "spans",
       .rows = "every branch of free rope",
       .columns = both(both(words_of(solve::branch_quantities()), words_of(solve::branch_band_quantities())),
                       words_of(branch_terrain_quantities()))},
      {.name = "sheaves",
       .rows = "every contact: sheaves, supports and carriages on their ropes",
       .columns = both(words_of(solve::contact_quantities()), words_of(solve::contact_band_quantities()))},
      {.name = "bodies", .rows = "every body", .columns = words_of(solve::body_quantities())},
      {.name = "anchors", .rows = "every end of a rope", .columns = words_of(solve::rope_end_quantities())},
      {.name = "ropes", .rows = "every rope", .columns = words_of(solve::rope_quantities())},
      {.name = "rope_loads", .rows = "every force along a rope", .columns = words_of(solve::rope_load_quantities())},
      {.name = "drives", .rows = "every driven sheave", .columns = words_of(solve::drive_quantities())},
      {.name = "drums", .rows = "every drum", .columns = words_of(solve::drum_quantities())},
      {.name = "closure",
       .rows = "the state as a whole: the worst of all",
       .columns = words_of(solve::closure_quantities())},
      {.name = "beams", .rows = "points along every beam", .columns = words_of(solve::beam_point_quantities())},
      {.name = "beam_ends", .rows = "every beam", .columns = words_of(solve::beam_quantities())},
      {.name = "put_up",
       .rows = "every line that is put up (`install:`)",
       .columns = words_of(study::put_up_quantities())}};
}

std::vector<TableWords> of_analyses() {
  return {
      {.name = "load_path", .rows = "every place with an equilibrium", .columns = load_path_words()},
      {.name = "payload", .rows = "every place", .columns = payload_words()},
      {.name = "installation", .rows = "every temperature", .columns = installation_words()},
      {.name = "lengths", .rows = "every rope at the first temperature", .columns = lengths_words()},
      {.name = "cycle", .rows = "every place of every phase", .columns = cycle_words()},
      {.name = "cycle_work", .rows = "every winch in every phase", .columns = words_of(study::winch_quantities())},
      {.name = "envelope",
       .rows = "forces; `envelope_lengths` and `envelope_angles` the same for lengths and angles",
       .columns = words_of(study::envelope_quantities(si::N))},
      {.name = "sweep", .rows = "every value of the parameter", .columns = sweep_words()},
      {.name = "modes", .rows = "every mode", .columns = words_of(study::mode_quantities())},
      {.name = "mode_shapes",
       .rows = "every free body in every mode",
       .columns = words_of(study::mode_shape_quantities())},
      {.name = "tensioning", .rows = "every pull; what the deck observes stands behind", .columns = tensioning_words()},
      {.name = "least_tension", .rows = "every rope whose length follows", .columns = least_tension_words()}};
}

std::vector<TableWords> of_motions() {
  return {{.name = "events", .rows = "every event of a motion", .columns = words_of(study::event_quantities())},
          {.name = "envelope (of a motion)",
           .rows = "everything that is observed",
           .columns = words_of(study::observed_quantities())},
          {.name = "dynamic", .rows = "every rope in a motion", .columns = words_of(study::dynamic_quantities())},
          {.name = "energy", .rows = "every form of energy in a motion", .columns = energy_words()},
          {.name = "time", .rows = "every step that is written down, in `time.csv`", .columns = time_words()}};
}

using Kinds = std::vector<ValueKind>;

Kinds kinds_of_states() {
  const auto& beams = solve::beam_quantities();
  const auto worst = picked(beams, {"M_max", "N_max", "stress_max", "top_displacement", "N_cr", "alpha_cr"});
  const auto base = picked(beams, {"N_base", "Rx", "Ry", "Rz", "Mx", "My", "Mz"});
  const auto driven = picked(solve::drive_quantities(), {"torque", "power"});
  Kinds all;
  const auto add = [&](const std::string& prefix, const Words& words, const char* of, const char* page) {
    const Kinds own = kinds_of(prefixed(prefix, words), of, page);
    all.insert(all.end(), own.begin(), own.end());
  };
  add("BODY.", words_of(picked(solve::body_quantities(), {"x", "y", "z"})), "the first equilibrium",
      "theory/equilibrium.md");
  add("ROPE.", words_of(picked(solve::rope_quantities(), {"unstretched"})), "the first equilibrium",
      "theory/length.md");
  add("ROPE.", words_of(solve::rope_end_tensions()), "every analysis `equilibrium`", "theory/equilibrium.md");
  add("SHEAVE.", words_of(driven), "every analysis `equilibrium`", "theory/drives.md");
  add("BEAM.", words_of(worst), "the worst of all judged states", "theory/beam.md");
  add("BEAM.", words_of(base), "the first equilibrium", "theory/beam.md");
  add("ROPE.", words_of(picked(study::dynamic_quantities(), {"dynamic_factor"})), "analysis `transient`",
      "theory/motion.md");
  return all;
}

/// Of ropes before any analysis.
Kinds kinds_of_ropes() {
  return {{.about = {.name = "ROPE.stiffness",
                     .symbol = "",
                     .unit = si::N.in("MN"),
                     .words = "EA by the area and construction of a rope of the catalogue"},
           .of = "a rope without `stiffness` of its own",
           .page = "guide/catalogues.md"},
          {.about = {.name = "ROPE.base_tension", .symbol = "", .unit = si::N, .words = "base tension"},
           .of = "a line with `install:`",
           .page = "theory/installation.md"},
          {.about = {.name = "ROPE.cut_length",
                     .symbol = "",
                     .unit = si::m,
                     .words = "length to cut: unstretched, with what is on drums, at the temperature at which the line "
                              "is put up"},
           .of = "a line with `install:`",
           .page = "theory/installation.md"}};
}

Kinds kinds_of_analyses() {
  Kinds all;
  const auto add = [&](const char* analysis, const char* page, const Words& words) {
    const Kinds own = kinds_of(words, fmt::format("analysis `{}`", analysis), page);
    all.insert(all.end(), own.begin(), own.end());
  };
  add("payload", "theory/payload.md",
      {{.name = "payload_min", .symbol = "m_min", .unit = si::kg.in("t"), .words = "least payload"},
       {.name = "payload_min_x", .symbol = "x", .unit = si::m, .words = "where the payload is least"}});
  add("installation", "theory/installation.md",
      {{.name = "ROPE.install_T_start", .symbol = "", .unit = si::N, .words = "tension at its start"},
       {.name = "ROPE.install_T_end", .symbol = "", .unit = si::N, .words = "tension at its end"},
       {.name = "ROPE.install_length", .symbol = "", .unit = si::m, .words = "length as cut"}});
  add("cycle", "theory/cycle.md",
      {{.name = "WINCH.pull_max", .symbol = "", .unit = si::N, .words = "largest pull over the cycle"},
       {.name = "WINCH.energy", .symbol = "", .unit = si::J, .words = "energy that the winch gives in the cycle"},
       {.name = "WINCH.power_max", .symbol = "", .unit = si::W, .words = "largest power"},
       {.name = "cycle_energy",
        .symbol = "",
        .unit = si::J,
        .words = "energy of all winches in the cycle, what brakes take off it taken off"},
       {.name = "cycle_time", .symbol = "", .unit = si::s, .words = "time of all phases at their speeds"}});
  add("envelope", "theory/cycle.md",
      {{.name = "ROPE.T_min_envelope", .symbol = "", .unit = si::N, .words = "least tension"},
       {.name = "ROPE.T_max_envelope", .symbol = "", .unit = si::N, .words = "largest tension"},
       {.name = "envelope_states",
        .symbol = "n",
        .unit = si::one,
        .words = "states of the envelope that were solved",
        .detail = true}});
  add("modes", "theory/modes.md",
      {{.name = "frequency_N", .symbol = "f_N", .unit = si::per_s.in("Hz"), .words = "undamped frequency of a mode"},
       {.name = "damping_N",
        .symbol = "zeta_N",
        .unit = si::one,
        .words = "damping of a mode as a share of the critical one"}});
  add("sweep", "theory/continuation.md",
      {{.name = "sweep_end",
        .symbol = "end",
        .unit = si::one,
        .words = "last value of the parameter, in its own unit, and why the sweep ends there"}});
  return all;
}

/// By pulls, or by the least tension of each rope.
Kinds kinds_of_pretension() {
  return kinds_of(
      {{.name = "ROPE.pretension_T_start", .symbol = "", .unit = si::N, .words = "tension at the start"},
       {.name = "ROPE.pretension_T_end", .symbol = "", .unit = si::N, .words = "tension at the end"},
       {.name = "ROPE.pretension_length", .symbol = "", .unit = si::m, .words = "unstretched length"},
       {.name = "ROPE.pretension_taken_out", .symbol = "", .unit = si::m, .words = "rope taken out"},
       {.name = "ROPE.pretension_T", .symbol = "", .unit = si::N, .words = "least tension as put up"},
       {.name = "ROPE.pretension_T_least", .symbol = "", .unit = si::N, .words = "least tension over all cases"}},
      "analysis `pretension`", "theory/installation.md");
}

Kinds kinds_of_motions() {
  Kinds all =
      kinds_of({{.name = "OBSERVED_min", .symbol = "", .unit = si::one, .words = "smallest value", .detail = true},
                {.name = "OBSERVED_max", .symbol = "", .unit = si::one, .words = "largest value", .detail = true},
                {.name = "OBSERVED_end", .symbol = "", .unit = si::one, .words = "value at the end", .detail = true},
                {.name = "MEASURE",
                 .symbol = "",
                 .unit = si::one,
                 .words = "a measure in one number, as its `take` says, in its own unit"},
                {.name = "SHEAVE.slip_share",
                 .symbol = "",
                 .unit = si::one,
                 .words = "way that the rope slips, as a share of the way of its rim"}},
               "analysis `transient`", "theory/motion.md");
  all.push_back(
      {.about = {.name = "energy_residual",
                 .symbol = "",
                 .unit = si::one,
                 .words =
                     "energy that the ledger can't account for, over the largest that was stored, supplied or lost",
                 .detail = true},
       .of = "analysis `transient`",
       .page = "theory/motion-energy.md"});
  return all;
}

}  // namespace

std::vector<TableWords> table_words() {
  std::vector<TableWords> all;
  for (const auto& part : {of_states(), of_analyses(), of_motions()}) all.insert(all.end(), part.begin(), part.end());
  return all;
}

const std::vector<ValueKind>& value_kinds() {
  static const std::vector<ValueKind> all = [] {
    std::vector<ValueKind> found;
    for (const auto& part :
         {kinds_of_states(), kinds_of_ropes(), kinds_of_analyses(), kinds_of_pretension(), kinds_of_motions()}) {
      found.insert(found.end(), part.begin(), part.end());
    }
    return found;
  }();
  return all;
}

}  // namespace taut::results
