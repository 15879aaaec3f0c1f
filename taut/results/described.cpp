#include "taut/results/described.hpp"

#include "taut/results/analyses/analyses.hpp"
#include "taut/results/load_path_table.hpp"
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

QuantityWords one(const char* name, const char* symbol, const Unit& unit, const char* words) {
  return {name, symbol, unit, words};
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
  return {{"spans", "every branch of free rope",
           both(both(words_of(solve::branch_quantities()), words_of(solve::branch_band_quantities())),
                {one("clearance", "", si::m, "least height of the branch over the ground, where there is terrain")})},
          {"sheaves", "every contact: sheaves, supports and carriages on their ropes",
           both(words_of(solve::contact_quantities()), words_of(solve::contact_band_quantities()))},
          {"bodies", "every body", words_of(solve::body_quantities())},
          {"anchors", "every end of a rope", words_of(solve::rope_end_quantities())},
          {"ropes", "every rope", words_of(solve::rope_quantities())},
          {"rope_loads", "every force along a rope", words_of(solve::rope_load_quantities())},
          {"drives", "every driven sheave", words_of(solve::drive_quantities())},
          {"drums", "every drum", words_of(solve::drum_quantities())},
          {"closure", "the state as a whole: the worst of all", words_of(solve::closure_quantities())},
          {"beams", "points along every beam", words_of(solve::beam_point_quantities())},
          {"beam_ends", "every beam", words_of(solve::beam_quantities())},
          {"put_up", "every line that is put up (`install:`)", words_of(study::put_up_quantities())}};
}

std::vector<TableWords> of_analyses() {
  const Words tensions = prefixed("ROPE.", words_of(solve::rope_end_tensions()));
  return {{"load_path", "every place with an equilibrium", load_path_words()},
          {"payload", "every place", payload_words()},
          {"installation", "every temperature",
           both(words_of(study::installation_quantities()), {one("sag_N", "f", si::m, "sag of span N at its half")})},
          {"lengths", "every rope at the first temperature", lengths_words()},
          {"cycle", "every place of every phase",
           both(words_of(study::cycle_quantities()), {one("WINCH.pull", "F", si::N, "pull of that winch")})},
          {"cycle_work", "every winch in every phase", words_of(study::winch_quantities())},
          {"envelope", "forces; `envelope_lengths` and `envelope_angles` the same for lengths and angles",
           words_of(study::envelope_quantities(si::N))},
          {"sweep", "every value of the parameter", sweep_words()},
          {"modes", "every mode", words_of(study::mode_quantities())},
          {"mode_shapes", "every free body in every mode", words_of(study::mode_shape_quantities())},
          {"tensioning", "every pull; what the deck observes stands behind",
           both(words_of(study::pull_quantities()), tensions)},
          {"least_tension", "every rope whose length follows",
           both(words_of(study::least_tension_quantities()),
                {one("T_min, CASE", "", si::N, "its least tension in that case")})}};
}

std::vector<TableWords> of_motions() {
  return {{"events", "every event of a motion", words_of(study::event_quantities())},
          {"envelope (of a motion)", "everything that is observed", words_of(study::observed_quantities())},
          {"dynamic", "every rope in a motion", words_of(study::dynamic_quantities())},
          {"energy",
           "every form of energy in a motion",
           {one("form", "", si::one, "the form"), one("at_start", "", si::J, "at the start of the motion"),
            one("at_end", "", si::J, "at its end")}}};
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
