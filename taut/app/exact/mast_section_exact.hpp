#pragma once
#include "taut/calc/quantity.hpp"
#include "taut/methods/mast_section/sizing.hpp"
#include "taut/structure/beam.hpp"
#include "taut/units/display.hpp"

/// The exact column of `mast_section`: the mast of the deck with its guys, solved by the engine. Without guys it is the
/// published clamped cantilever, with the second-order moment that the method leaves out.
namespace taut::app {

/// Values of the exact solution at the carriage position that governs the method; "worst": over all positions.
struct MastSectionExact {
  double M_exact = mast_section::not_computed;                 ///< N m, at the foot
  double M_max_exact = mast_section::not_computed;             ///< N m, the largest along the mast
  double M_max_height_exact = mast_section::not_computed;      ///< m
  double N_exact = mast_section::not_computed;                 ///< N, at the foot
  double Q_exact = mast_section::not_computed;                 ///< N, at the foot
  double top_displacement_exact = mast_section::not_computed;  ///< m, horizontal
  double top_x_exact = mast_section::not_computed;             ///< m, towards the span
  double top_y_exact = mast_section::not_computed;             ///< m, to the left of it
  double top_drop_exact = mast_section::not_computed;          ///< m
  double sigma_exact = mast_section::not_computed;             ///< Pa, the largest along the mast
  double sigma_height_exact = mast_section::not_computed;      ///< m, where
  double sigma_worst_exact = mast_section::not_computed;       ///< Pa
  double M_worst_exact = mast_section::not_computed;           ///< N m, at the foot, the largest of all load cases
  double N_worst_exact = mast_section::not_computed;           ///< N, at the foot, the same
  double N_least_exact = mast_section::not_computed;           ///< N, at the foot, the least; negative: it is pulled up
  double Q_worst_exact = mast_section::not_computed;           ///< N, at the foot, the largest
  double guy_tension_max_exact = mast_section::not_computed;   ///< N, worst
  double guy_safety_min_exact = mast_section::not_computed;    ///< worst
  double buckling_factor_exact = mast_section::not_computed;   ///< worst
  double slack_guys_exact = mast_section::not_computed;        ///< how many
  double force_balance_exact = mast_section::not_computed;     ///< N, worst
  double moment_balance_exact = mast_section::not_computed;    ///< N m, worst
  double guy_closure_exact = mast_section::not_computed;       ///< m, worst

  static const Description& describe();
};

/// The factor of its axial force at which a straight mast buckles, below which second order with imperfections decides
/// (EN 1993-1-1, 5.2.2).
constexpr double least_without_imperfections = 3;

/// A given mast is only warned of below that factor. One that is chosen fails a check there: `r` has the exact values.
void check_chosen_mast(Result& r);

/// What the engine knows of a section for the method's choice and checks; `in` must outlive it. With `safety` n its
/// stress is the larger of those under the ropes' forces, and under n times these, over n: of second order the stress
/// grows faster than the forces, and the reserve is meant for them. The tension of guys put up is not multiplied.
mast_section::SecondOrder second_order_of(const mast_section::Input& in);

/// The method with second order from the engine, and with the exact values, comparisons, tables, checks and figures. A
/// deck with guys, a lateral force or a hinge that finds no equilibrium makes the result infeasible; a plain cantilever
/// is warned of.
Result run_mast_section(const mast_section::Input& in, const Display& display = Display());

/// The tables `guys` and `positions_exact` as described.
std::vector<TableWords> mast_section_exact_words();

}  // namespace taut::app
