#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/checks/section_choice.hpp"

namespace taut::checks {

enum class MastCurve { by_section, a0, a, b, c, d };
enum class MastBase { clamped, hinge };

/// A piece of a mast that is described here and not in a machine, from the base upwards.
struct MastPieceRequest {
  double length = 0;  ///< m
  std::string section;
  std::optional<std::string> top;  ///< of its upper end, where it tapers
  static const Description& describe();
};

/// Forces on such a mast at one height.
struct MastLoadRequest {
  std::string load_case = "work";
  std::optional<double> at;                ///< m above the base; else its top
  double down = 0;                         ///< N
  double across = 0;                       ///< N, bends about the strong axis
  double sideways = 0;                     ///< N, about the weak one
  double moment = 0, sideways_moment = 0;  ///< N m
  double torsion = 0;                      ///< N m, about its axis
  static const Description& describe();
};

/// One load case or analysis with its partial factor.
struct MastTerm {
  std::string name;
  double factor = 1;
  static const Description& describe();
};
struct MastCombinationRequest {
  std::string name;
  std::vector<MastTerm> terms;
  static const Description& describe();
};

/// What the plate of a metal spar says of its guylines.
struct PlateRequest {
  std::optional<double> guys;          ///< how many at least
  std::optional<double> guy_strength;  ///< N, breaking force of each at least
  static const Description& describe();
};

/// What is checked of one mast or strut.
struct MastCheckRequest {
  std::string name;                ///< of a beam, or of its own
  std::vector<std::string> beams;  ///< of the machine, from the base upwards; else the one of that name
  std::optional<std::string> section;
  std::vector<MastPieceRequest> pieces;
  std::optional<double> height;  ///< m
  std::optional<std::string> steel;
  std::optional<MastBase> base;  ///< of one that is described here; else clamped
  double top_stiffness = 0;      ///< N/m
  std::vector<MastLoadRequest> loads;
  std::vector<std::string> carries;  ///< sheaves, supports and anchors whose ropes press on it
  std::vector<double> foot;          ///< m, of a mast that carries them; empty: 0, 0, 0
  std::vector<double> towards;       ///< in which its strong axis bends; empty: 1, 0
  bool own_weight = false;
  std::optional<double> sway, bow;
  double load_factor = 1, dynamic_factor = 1, gamma_M0 = 1, gamma_M1 = 1;
  std::vector<MastCombinationRequest> combinations;
  double wall_tolerance = 0;
  MastCurve curve = MastCurve::by_section;
  std::optional<double> buckling_length;  ///< m
  double C_m = 0.9;
  std::optional<double> allowable_stress;  ///< Pa
  std::optional<double> safety;            ///< of the yield stress
  std::optional<double> top_criterion;     ///< of the stiffness of its guys
  std::optional<PlateRequest> plate;
  std::optional<SectionChoice> choose;
  static const Description& describe();
};

}  // namespace taut::checks
