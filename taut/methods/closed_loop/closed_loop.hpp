#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/calc/method.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/calc/result.hpp"
#include "taut/calc/sheet.hpp"

namespace taut {
class Display;
}

/// Statics of a closed loop of two ropes with parallel, jointly loaded branches, after V. D. Martynikhin, about 1971: a
/// running skyline whose return rope is led back over the tail sheave, so that its upper branch carries part of the
/// load.
///
/// Head support A (winch) and tail support B (sheave) stand `span` apart; the carriage, clamped to the lower branch and
/// rolling on the upper one, hangs at the horizontal distance x from A with the vertical sag f under the chord.
/// Three tiers: the formulas of the paper (with misprints repaired, and as printed where the misprint matters),
/// corrected formulas, and a closed form in which the roller presses normal to the rope. Forces in N, lengths in m,
/// angles in rad.
namespace taut::closed_loop {

struct Engine;

enum class Mode { sag, winch_pull, loop_length, free_running };
enum class Carriage { single, two_section };
enum class DistanceKind { horizontal, rope };
enum class Section { first, second };
enum class BranchOffset { normal, vertical };
enum class Roller { free, vertical };
enum class Haul { in, out };
enum class AngleFrom { vertical, horizontal };

/// Which ropes of the catalogue may be chosen. An empty text or a missing grade does not restrict the choice.
struct RopeFilter {
  std::optional<std::string> construction;  ///< "6x36"
  std::optional<std::string> core;          ///< "IWRC", "FC"
  std::optional<double> grade;              ///< nominal wire strength, Pa

  static const Description& describe();
};

/// The deck's keys; see describe() for symbol, unit, range and meaning of each.
struct Input {
  double span = std::numeric_limits<double>::quiet_NaN();
  double slope = 0;
  std::optional<double> height_difference;
  std::vector<double> position;
  Mode mode = Mode::sag;
  std::optional<double> sag;
  std::optional<double> winch_pull;
  double head_efficiency = 1;
  std::optional<double> loop_length;
  double gathering_force = std::numeric_limits<double>::quiet_NaN();
  double gathering_angle = std::numeric_limits<double>::quiet_NaN();
  AngleFrom gathering_angle_from = AngleFrom::vertical;
  std::optional<double> return_weight;
  std::optional<double> traction_weight;
  std::optional<std::string> return_rope;
  std::optional<std::string> traction_rope;
  double tail_efficiency = std::numeric_limits<double>::quiet_NaN();
  int tail_sheaves = 1;
  Carriage carriage = Carriage::single;
  std::optional<double> section_distance;
  DistanceKind distance_kind = DistanceKind::horizontal;
  Section sag_of = Section::first;
  Section position_of = Section::first;
  double branch_distance = 0;
  BranchOffset branch_offset = BranchOffset::normal;
  double carriage_weight = 0;
  double return_stiffness = std::numeric_limits<double>::infinity();
  double traction_stiffness = std::numeric_limits<double>::infinity();
  Roller roller = Roller::free;
  Haul haul = Haul::in;
  std::optional<double> safety_factor;
  std::optional<double> wire_strength;
  double weight_per_area = 98066.5;
  std::optional<RopeFilter> choose_ropes;
  std::optional<double> clearance;

  static const Description& describe();
};

/// A value that was not computed is NaN.
struct Output {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double x = none;
  double f = none;
  double f_second = none;
  double q_b = none;
  double q_T = none;
  // The paper, repaired.
  double P = none;
  double K = none;
  double P_b = none;
  double P_b_no_weight = none;
  double T_b = none;
  double T_n = none;
  double T_up = none;
  double T_lA_paper = none;
  // The paper, as printed.
  double P_b_4_printed = none;
  double T_n_printed = none;
  double T_lA_printed = none;
  // Two-section carriage.
  double delta_f = none;
  double P_b_printed = none;
  double delta_f_printed = none;
  double x_1 = none;
  double x_2 = none;
  double f_1 = none;
  double f_2 = none;
  // Closed-form tier.
  double N = none;
  double P_v = none;
  double P_b_closed = none;
  double delta_f_closed = none;
  double phi = none;
  double T_uA = none;
  double T_uB = none;
  double T_lA = none;
  double T_lB = none;
  double T_U = none;
  double T_lLA = none;
  double T_lLB = none;
  double T_12 = none;
  double T_winch = none;    ///< only where the sheaves at A lose something
  double T_end_max = none;  ///< of the four ends of this position
  double H_1 = none;
  double H_2 = none;
  double H_3 = none;
  double H_4 = none;
  // Sizing.
  double F_return_paper = none;
  double F_traction_paper = none;
  double F_return = none;
  double F_traction = none;
  double f_midspan = none;  ///< where the areas take another sag than f
  double safety_factor_return_paper = none;
  double safety_factor_traction_paper = none;
  // Exact catenaries; computed only with an engine.
  double P_b_exact = none;
  double P_v_exact = none;
  double N_exact = none;
  double phi_exact = none;
  double T_uA_exact = none;
  double T_uB_exact = none;
  double T_lA_exact = none;
  double T_lB_exact = none;
  double T_U_exact = none;
  double T_lLA_exact = none;
  double T_lLB_exact = none;
  double T_12_exact = none;
  double T_winch_exact = none;
  /// Of both ropes over all positions with an answer, both hauls and the winch; only of a run, which without an engine
  /// takes it from the closed-form tier.
  double T_max = none;
  double delta_f_exact = none;
  double upper_sag_exact = none;
  double loop_length_exact = none;
  double traction_length_exact = none;
  double return_length_exact = none;
  double residual_exact = none;
  double closure_exact = none;

  static const Description& describe();
};

/// The tension of the traction rope at A that mode winch_pull asks for, N: the sheaves at A take their part of the pull
/// when the rope runs in, and help the winch to hold when it runs out.
double pull_at_A(const Input& in);
/// The tension on the winch's side of the sheaves at A, N, where the traction rope has T_lA on the other side.
double pull_at_winch(const Input& in, double T_lA);

/// Citation, scope, limits, errata with the tests that show them.
const Method& about();

/// The rules between fields that the deck violates, and rope names that the catalogue does not have. Paths below
/// `input`.
std::vector<Complaint> complaints(const Input& in);

/// The equations of the paper in its order and letters, the corrections beside them, and the closed-form tier, for one
/// carriage position: the only one given, midspan when none is given, or the worst of a list (largest tension at any of
/// the four rope ends in the closed-form tier).
/// Infeasible: no vertical load, the roller lifts off, a rope goes slack, or a rope cannot carry its own weight at that
/// sag; `out` then keeps the values computed before. Precondition: complaints(in) is empty. T is double or Num.
template <class T>
Outcome compute(const Input& in, Sheet<T>& s, Output& out);

/// compute without a calculation note.
Outcome solve(const Input& in, Output& out);

/// The result for a report: values, tables `positions` and `ropes`, checks, steps, comparisons, figures, warnings. The
/// engine adds the exact values, finds the sag in every mode but `sag`, and verifies chosen ropes. `display`: the units
/// of its messages.
Result run(const Input& in, const Engine& engine, const Display& display);
Result run(const Input& in, const Engine& engine);
/// The same without an engine: no exact values.
Result run(const Input& in);
/// What a result says of a rope (`role`: return, traction) that the deck asks a safety factor of without its strength.
std::string unknown_strength(const std::string& role);
/// The lines of the main answer, from a result of this input that is ok.
std::vector<Answer> answers(const Input& in, const Result& r, const Display& display);

}  // namespace taut::closed_loop
