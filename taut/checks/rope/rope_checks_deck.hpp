#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/checks/rope/rope_life_deck.hpp"

namespace taut::checks {

enum class HoistClass { HC1, HC2, HC3, HC4 };

/// Dynamic factor phi2 of hoisting, EN 13001-2.
struct HoistRequest {
  HoistClass hoisting_class = HoistClass::HC2;
  double speed = 0;  ///< m/s
  static const Description& describe();
};

/// What a limit depends on where the field of use does not say it.
enum class Choose { by_field, yes, no };
enum class Groove { none, wood, cast_iron, cast_steel, chilled_iron, manganese_steel };
enum class DrumFace { unsaid, smooth, grooved };

/// Proofs of EN 13001-3-2.
struct En13001Request {
  std::optional<double> bends;     ///< w_tot in the design life; without it the static proof alone
  std::optional<double> spectrum;  ///< k_r; 1
  std::optional<double> factor;    ///< f_f; 1
  static const Description& describe();
};

/// What is checked of one rope. Empty: not checked.
struct RopeCheckRequest {
  std::string name;                     ///< a reeving, a guy, or a rope of the machine with all its reevings
  std::vector<std::string> field;       ///< rules below "safety."
  std::optional<std::string> group;     ///< class: "M5"
  std::optional<double> safety_factor;  ///< the deck's own
  std::optional<double> dynamic_factor;
  std::optional<HoistRequest> hoist;
  std::optional<double> dynamic_safety_factor;
  std::optional<double> elastic_limit;  ///< share
  std::optional<std::string> termination;
  std::optional<double> termination_efficiency;
  std::optional<double> temperature;  ///< K
  Choose sheave_weakening = Choose::by_field;
  Choose running = Choose::by_field;
  std::vector<double> diameter_ratio;  ///< least D/d, the deck's own: one for all, or of sheaves and drums
  std::vector<std::string> compensating;
  std::optional<std::string> rope;       ///< of the catalogue, where the deck has figures only
  std::optional<double> breaking_force;  ///< N, where the deck does not say it
  std::optional<double> diameter;        ///< m
  std::optional<std::string> construction;
  std::optional<std::string> core;
  std::optional<double> grade;  ///< Pa
  std::optional<double> area;   ///< m2
  Groove groove = Groove::none;
  std::optional<double> groove_pressure;  ///< Pa, the deck's own limit
  std::optional<double> wire_diameter;    ///< m
  double bending_modulus = 82.7e9;        ///< Pa
  DrumFace drum = DrumFace::unsaid;
  std::optional<double> fleet_angle;  ///< rad, the deck's own limit
  std::optional<double> rated_pull;   ///< N
  std::optional<En13001Request> en13001;
  std::vector<DutyRequest> duty;
  std::optional<LifeRequest> life;
  bool discard = false;
  static const Description& describe();
};

}  // namespace taut::checks
