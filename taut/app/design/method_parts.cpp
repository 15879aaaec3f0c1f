#include "taut/app/design/method_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "taut/app/exact/mast_section_exact.hpp"
#include "taut/base/gravity.hpp"
#include "taut/catalogue/modulus.hpp"
#include "taut/catalogue/rope_search.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/methods/mast_section/mast_section.hpp"

namespace taut::app {
namespace {

/// Whether a row is one of the built-in catalogue, so that its id says all.
bool is_built_in(const catalogue::RopeRow& row) {
  const auto known = catalogue::find_rope(row.id);
  return known && known->id == row.id && known->mass_per_length == row.mass_per_length &&
         known->breaking_force == row.breaking_force && known->area == row.area;
}

constexpr double inextensible = std::numeric_limits<double>::infinity();

/// Whether the loop takes the stiffness of a rope of the catalogue where the deck has none.
bool takes_stiffness(const closed_loop::Input& in) { return in.mode == closed_loop::Mode::loop_length; }

/// At a given sag ropes without a stiffness do not stretch.
double modulus_in_loop(const closed_loop::Input& in, const std::string& name, const catalogue::RopeRow& row) {
  if (takes_stiffness(in)) {
    const auto own = catalogue::stiffness_of(row);
    return own ? own->modulus : method_modulus;
  }
  return std::isfinite(name == "return" ? in.return_stiffness : in.traction_stiffness) ? method_modulus : inextensible;
}

void put_in_loop(closed_loop::Input& in, const std::string& name, const catalogue::RopeRow& row, double modulus) {
  const bool is_return = name == "return";
  auto& rope = is_return ? in.return_rope : in.traction_rope;
  auto& weight = is_return ? in.return_weight : in.traction_weight;
  double& stiffness = is_return ? in.return_stiffness : in.traction_stiffness;
  rope.reset();
  weight.reset();
  stiffness = modulus * row.area;
  if (is_built_in(row)) {
    rope = row.id;
    const auto own = catalogue::stiffness_of(row);
    // the method takes it itself, and says how far it may be trusted
    if (takes_stiffness(in) && own && own->modulus == modulus) stiffness = inextensible;
  } else {
    weight = row.mass_per_length * standard_gravity;
  }
}

/// The return rope runs to the tail and back, the traction rope to the tail.
double length_in_loop(const closed_loop::Input& in, const std::string& name) {
  const double height = in.height_difference.value_or(in.span * std::tan(in.slope));
  const double chord = std::hypot(in.span, height);
  return name == "return" ? 2 * chord : chord;
}

/// rope_mass is that of the rope with its cutters: what it has more than the deck's rope stays on the one that is
/// chosen.
void put_in_drive(friction_drive::Input& in, const std::string& /*name*/, const catalogue::RopeRow& row,
                  double modulus) {
  if (in.rope) {
    if (const auto before = catalogue::find_rope_in_words(*in.rope)) {
      in.rope_mass = row.mass_per_length + std::max(0.0, in.rope_mass - before->mass_per_length);
    }
  }
  in.rope.reset();
  if (is_built_in(row)) in.rope = row.id;
  in.rope_area = row.area;
  in.rope_stiffness = modulus * row.area;
}

double length_in_drive(const friction_drive::Input& in, const std::string& /*name*/) {
  if (!in.centre_distance) return 1;
  return 2 * *in.centre_distance + 2 * std::numbers::pi * in.sheave_radius.value_or(0);
}

double mass_of_take_up(const friction_drive::Input& in) {
  if (!in.take_up) return 0;
  return in.take_up->mass.value_or(in.take_up->weight.value_or(0) / standard_gravity);
}

/// C_1 of half of the extension rope, C_2 of the retraction rope, by their lengths.
void put_in_boom(boom_ropes::Input& in, const std::string& name, const catalogue::RopeRow& row, double modulus) {
  if (!in.sliding) return;
  const bool extension = name == "extension";
  const double length = extension ? in.sliding->extension_length : in.sliding->retraction_length;
  const double C = modulus * row.area / length;
  (extension ? in.extension_stiffness : in.retraction_stiffness) = C;
  (extension ? in.sliding->extension_stiffness : in.sliding->retraction_stiffness) = C;
}

double length_in_boom(const boom_ropes::Input& in, const std::string& name) {
  if (!in.sliding) return 1;
  return name == "extension" ? 2 * in.sliding->extension_length : in.sliding->retraction_length;
}

std::string refuse_in_loop(const closed_loop::Input& in) {
  return in.choose_ropes ? "'choose_ropes' of the input chooses them already: leave one of the two out" : "";
}

std::string refuse_in_boom(const boom_ropes::Input& in) {
  return in.sliding ? "" : "the stiffness of a rope follows from its length: give 'sliding' with the lengths";
}

/// Its forces are given: a rope is chosen by its checks alone.
void put_in_mast(mast_section::Input& /*in*/, const std::string& /*name*/, const catalogue::RopeRow& /*row*/,
                 double /*modulus*/) {}

void put_section_in_mast(mast_section::Input& in, const std::string& section) { in.section = section; }

double height_of_mast(const mast_section::Input& in) {
  return std::max(in.skyline_block_height, in.mainline_block_height.value_or(0));
}

std::string refuse_in_mast(const mast_section::Input& in) {
  return in.choose_section ? "'choose_section' of the input chooses it already: leave one of the two out" : "";
}

}  // namespace

MethodDesign design_of_loop() {
  return {.put_rope = on(put_in_loop),
          .modulus = on(modulus_in_loop),
          .rope_length = on(length_in_loop),
          .refuse = on(refuse_in_loop)};
}

MethodDesign design_of_drive() {
  return {.put_rope = on(put_in_drive), .rope_length = on(length_in_drive), .mass = on(mass_of_take_up)};
}

MethodDesign design_of_boom() {
  return {.put_rope = on(put_in_boom), .rope_length = on(length_in_boom), .refuse = on(refuse_in_boom)};
}

MethodDesign design_of_mast() {
  return {.put_rope = on(put_in_mast),
          .put_section = on(put_section_in_mast),
          .check_choice = check_chosen_mast,
          .height = on(height_of_mast),
          .refuse = on(refuse_in_mast)};
}

}  // namespace taut::app
