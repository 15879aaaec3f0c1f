#include "taut/results/described.hpp"

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

/// `payload` and `governing` stand behind the carriage's place.
Words payload_words() {
  constexpr std::ptrdiff_t behind_place = 3;
  Words all = load_path_words();
  const Words own = words_of(study::payload_quantities());
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

}  // namespace

std::vector<TableWords> table_words() {
  std::vector<TableWords> all;
  for (const auto& part : {of_states(), of_analyses(), of_motions()}) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<QuantityWords> value_words() {
  Words all = prefixed("BODY.", words_of(picked(solve::body_quantities(), {"x", "y", "z"})));
  all = both(all, prefixed("ROPE.", words_of(picked(solve::rope_quantities(), {"unstretched"}))));
  all = both(all, prefixed("ROPE.", words_of(solve::rope_end_tensions())));
  all = both(all, prefixed("SHEAVE.", words_of(picked(solve::drive_quantities(), {"torque", "power"}))));
  const auto beam = picked(solve::beam_quantities(), {"M_max", "N_max", "stress_max", "top_displacement", "N_cr",
                                                      "alpha_cr", "N_base", "Rx", "Ry", "Rz", "Mx", "My", "Mz"});
  all = both(all, prefixed("BEAM.", words_of(beam)));
  return both(all, prefixed("ROPE.", words_of(picked(study::dynamic_quantities(), {"dynamic_factor"}))));
}

}  // namespace taut::results
